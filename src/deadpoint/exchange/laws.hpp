#pragma once

#include <functional>

/// Smooth curves of a temperature: the only form in which a physical law reaches the field solver.
namespace deadpoint {

struct LawValue {
    double value = 0;
    double slope = 0;      ///< derivative by the temperature
    bool in_range = true;  ///< false outside the law's well-tested range
};

/// Friction heat of a joint, of the whole press [W], over its temperature [K].
using HeatLaw = std::function<LawValue(double temperature)>;
/// What the ring temperature difference (inner less outer) [K] adds to it through the preload, of the whole press [W].
using RingHeatLaw = std::function<double(double difference)>;
/// Heat transfer coefficient of a surface [W/m2/K] over its temperature [K].
using FilmLaw = std::function<LawValue(double surface_temperature)>;

}  // namespace deadpoint
