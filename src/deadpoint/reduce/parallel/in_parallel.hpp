#pragma once

#include <cstddef>
#include <functional>

namespace deadpoint::reduce {

class Ranks;

/// Calls work(0) to work(count - 1), each once, on several threads of which the caller is one. What one of them throws
/// is thrown again at the end; the thread that met it takes no more work. Where the system gives fewer threads, those
/// do all of it.
void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work);

/// The same shared out over ranks, of which each has so many threads: this one calls work(rank), work(rank + ranks),
/// ...
void in_parallel(const Ranks& ranks, int threads, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace deadpoint::reduce
