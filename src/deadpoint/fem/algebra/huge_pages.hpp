#pragma once

#include <cstddef>

namespace deadpoint::fem {

/// From now on PETSc's matrices ask the kernel for huge pages (2 MiB), with which products of
/// hundreds of megabytes have fewer misses in the address tables. It is only a request: kernels
/// that always or never give huge pages behave as before. Call it before PETSc starts.
void ask_for_large_pages();

/// Returns freed arrays that malloc keeps to the kernel, since huge pages do not come from there.
void give_back_freed_memory();

/// Memory for an array of `size` bytes; from 32 MiB on it begins at a huge page and is zero. Null
/// if there is no memory, or for 0 bytes. Only one thread may call these.
void* allocate_array(std::size_t size);
/// Frees memory of allocate_array().
void release_array(void* array);
/// Resizes the array, in place or elsewhere, and keeps the contents that fit. Null, with the array
/// unchanged, if there is no memory.
void* resize_array(void* array, std::size_t size);

}  // namespace deadpoint::fem
