#pragma once

namespace deadpoint::fem {

/// From now on PETSc's matrices ask the kernel for large pages (2 MiB), which products with hundreds of
/// megabytes cross with fewer misses of the address tables. Only a request: kernels that give large pages always, or
/// never, go on as before. Call it before PETSc starts.
void ask_for_large_pages();

/// To the kernel, what malloc keeps of freed arrays: large pages do not come from there.
void give_back_freed_memory();

}  // namespace deadpoint::fem
