#include "deadpoint/exchange/step_tolerance.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint {
namespace {

constexpr double same_for_both = 0.02;  // [K]

}  // namespace

double step_tolerance(double time_tolerance)
{
    return time_tolerance * std::min(1.0, std::sqrt(time_tolerance / same_for_both));
}

double time_tolerance_of(double step_tolerance)
{
    return step_tolerance * std::max(1.0, std::cbrt(same_for_both / step_tolerance));
}

}  // namespace deadpoint
