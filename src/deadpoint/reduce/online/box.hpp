#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace deadpoint {
struct HeatProblem;
}

/// The free coefficients of a reduced model, and problems with other values of them.
namespace deadpoint::reduce {

/// A coefficient that is free at run time, or several that change together.
struct FreeCoefficient {
    enum class Kind {
        film,             ///< convection of surface conditions, a factor
        side,             ///< conductance of sides of interfaces, a factor
        oil,              ///< from an interface to its oil, a factor on `base`
        heat,             ///< friction heat of sources, a factor
        oil_temperature,  ///< of all oil, a difference [K]
        ambient           ///< a difference [K]
    };
    std::string name;  ///< key of the case
    Kind kind = Kind::film;
    /// Indices of surface conditions, of interfaces times two plus one for side b, of interfaces, or of sources.
    std::vector<std::size_t> members;
    std::vector<double> base;  ///< of each member in the problem that is reduced [W/m2/K], [W] or [K]
    double from = 1, to = 1;   ///< range for which the model was trained
};

using Box = std::vector<FreeCoefficient>;

/// Changes a problem to these values of the box: constant films, and everything else by factors and differences.
/// Differences of the ambient build up over 15 minutes, since a jump is no climate.
void set_values(HeatProblem& problem, const Box& box, const std::vector<double>& values);

/// Draws values of a box: factors of films, sides and heat evenly in their logarithm, all others evenly. In one of five
/// draws all oil is off. The same seed gives the same draws on every machine.
class Draws {
public:
    explicit Draws(unsigned long long seed) : state_(seed) {}
    std::vector<double> values(const Box& box);
    /// Evenly in 0 to 1.
    double next();

private:
    unsigned long long state_;
};

}  // namespace deadpoint::reduce
