#pragma once

#include <cstddef>
#include <vector>

namespace deadpoint {
struct HeatProblem;
}

namespace deadpoint::reduce {

/// The scalars of an interface's law that may change.
struct JointScalars {
    double film_a = 0, film_b = 0, oil = 0, oil_temperature = 0;
    bool operator==(const JointScalars&) const = default;
};

/// The scalars of a heat balance that may change, at one time: as their changes along a direction, or as the
/// derivatives of a value by them.
struct HeatScalars {
    std::vector<JointScalars> joints;  ///< per interface
    std::vector<double> films;         ///< per surface condition: its coefficient
    std::vector<double> surroundings;  ///< per surface condition: the temperature that its film faces
    std::vector<double> shares;        ///< per source: HeatSource::share
};

/// Sum of the products of all scalars.
double dot(const HeatScalars& a, const HeatScalars& b);

/// (changed - problem) / by, of two problems that differ in these scalars only, in a segment at a time.
HeatScalars change_per(double by, const HeatProblem& problem, const HeatProblem& changed, std::size_t segment,
                       double time);

}  // namespace deadpoint::reduce
