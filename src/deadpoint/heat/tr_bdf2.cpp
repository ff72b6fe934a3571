#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::heat {
namespace {

constexpr double same_for_both = 0.02;  // [K]

}  // namespace

double fit_step(double wanted, double remaining)
{
    if (remaining <= wanted * (1 + 1e-9))
        return remaining;
    return remaining < 2 * wanted ? remaining / 2 : wanted;
}

double step_size_factor(double error, double tolerance, int least, int most)
{
    const double allowed = 0.9 * std::cbrt(tolerance / std::max(error, 1e-30));
    const double power = std::floor(std::log(allowed) / std::log(step_ratio));
    return std::pow(step_ratio, std::clamp(power, 1.0 * least, 1.0 * most));
}

double step_tolerance(double time_tolerance)
{
    return time_tolerance * std::min(1.0, std::sqrt(time_tolerance / same_for_both));
}

double time_tolerance_of(double step_tolerance)
{
    return step_tolerance * std::max(1.0, std::cbrt(same_for_both / step_tolerance));
}

}  // namespace deadpoint::heat
