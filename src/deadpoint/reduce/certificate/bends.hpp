#pragma once

#include <vector>

/// What the heat of laws may differ from that of their tangents, as far as falling heat limits the errors.
namespace deadpoint::reduce {

/// A source in a step. With an error e of its temperature its heat differs from that of its tangent by at most
/// curvature/2 e^2 and by at most bend |e|, and it falls by at least fall |e|.
struct BentLaw {
    double duration = 0;   ///< of the step [s]
    double seen = 0;       ///< |b . z|, by which the output sees the heat [output unit/J]
    double curvature = 0;  ///< [W/K2]
    double bend = 0;       ///< [W/K]
    double fall = 0;       ///< above 0 [W/K]
};

/// A bound of
///   sum of duration seen min(curvature/2 e^2, bend |e|)    over all e with    sum of duration fall e^2 <= energy.
/// Each law is counted either by its curvature, where the sum is at most
///   max(seen curvature / fall) / 2 energy,
/// or, as near a kink, by its bend, where it is at most
///   (sum of duration (seen bend)^2 / fall)^1/2 energy^1/2.
/// Those of the largest seen curvature / fall count by their bends, as many as give the least.
double largest_of_bent(const std::vector<BentLaw>& laws, double energy);

}  // namespace deadpoint::reduce
