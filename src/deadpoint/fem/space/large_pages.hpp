#pragma once

#include <cstddef>

namespace deadpoint::fem {

/// From now on PETSc's matrices ask the kernel for large pages (2 MiB), which products with hundreds of megabytes cross
/// with fewer misses of the address tables. Only a request: kernels that give large pages always, or never, go on as
/// before. Call it before PETSc starts.
void ask_for_large_pages();

/// To the kernel, what malloc keeps of freed arrays: large pages do not come from there.
void give_back_freed_memory();

/// Room for an array of so many bytes, from 32 MiB on at the start of a large page and zero. Null where there is none,
/// or for no bytes. One thread calls these.
void* allocate_array(std::size_t size);
/// Takes what allocate_array() gave.
void release_array(void* array);
/// The array with another length, in its place or another, with what fits of its contents; null, with the array as it
/// was, where there is no room.
void* resize_array(void* array, std::size_t size);

}  // namespace deadpoint::fem
