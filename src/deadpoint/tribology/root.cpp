#include "deadpoint/tribology/root.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::tribology {

double increasing_root(const std::function<double(double)>& function, double low, double high)
{
    const double at_low = function(low);
    const double at_high = function(high);
    const auto fail = [&](const char* why) {
        throw ConvergenceError(fmt::format("a law of contact has no solution between {:g} and {:g}: {}\n"
                                           "  help: look for extreme sizes, loads or surfaces of the joint",
                                           low, high, why));
    };
    if (!std::isfinite(at_low) || !std::isfinite(at_high))
        fail("it is not a number at the ends");
    if (at_low >= 0)
        return low;
    if (at_high <= 0)
        return high;
    const double width = 4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(low), std::abs(high));
    const auto narrow = [width](double a, double b) { return std::abs(b - a) <= width; };
    constexpr std::uintmax_t most = 200;
    std::uintmax_t evaluations = most;
    const auto [a, b] = boost::math::tools::toms748_solve(function, low, high, at_low, at_high, narrow, evaluations);
    if (evaluations >= most)
        fail("the search does not end");
    return (a + b) / 2;
}

}  // namespace deadpoint::tribology
