#include "deadpoint/reduce/offline/in_parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
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
    for (std::size_t t = 1; t < failed.size(); ++t)
        helpers.emplace_back(serve, t);
    serve(0);
    for (auto& helper : helpers)
        helper.join();
    for (const auto& error : failed)
        if (error)
            std::rethrow_exception(error);
}

}  // namespace deadpoint::reduce
