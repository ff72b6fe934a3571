#include "deadpoint/heat/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::heat {

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

}  // namespace deadpoint::heat
