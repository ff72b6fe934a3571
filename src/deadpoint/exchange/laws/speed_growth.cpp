#include "deadpoint/exchange/laws/speed_growth.hpp"

#include <cmath>

namespace deadpoint {

double SpeedGrowth::factor(double speed) const
{
    return at_rest + (1 - at_rest) * std::pow(std::abs(speed) / reference_speed, exponent);
}

}  // namespace deadpoint
