#include "deadpoint/reduce/parallel/in_parallel.hpp"

#include "deadpoint/reduce/parallel/ranks.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace deadpoint::reduce {

void in_parallel(int threads, std::size_t count, const std::function<void(std::size_t)>& work)
{
    std::atomic<std::size_t> next{0};
    std::vector<std::exception_ptr> failed(static_cast<std::size_t>(std::max(threads, 1)));
    const auto serve = [&](std::size_t thread) {
        try {
            for (std::size_t k = next++; k < count; k = next++)
                work(k);
        } catch (...) {
            failed[thread] = std::current_exception();
        }
    };
    std::vector<std::thread> helpers;
    try {
        for (std::size_t t = 1; t < failed.size(); ++t)
            helpers.emplace_back(serve, t);
    } catch (const std::system_error&) {
        // the threads that are there do all of it
    }
    serve(0);
    for (auto& helper : helpers)
        helper.join();
    for (const auto& error : failed)
        if (error)
            std::rethrow_exception(error);
}

void in_parallel(const Ranks& ranks, int threads, std::size_t count, const std::function<void(std::size_t)>& work)
{
    const auto own = static_cast<std::size_t>(ranks.rank()), all = static_cast<std::size_t>(ranks.count());
    in_parallel(threads, (count + all - 1 - own) / all, [&](std::size_t k) { work(own + k * all); });
}

}  // namespace deadpoint::reduce
