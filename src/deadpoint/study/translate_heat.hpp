#pragma once

#include "deadpoint/casefile/case.hpp"
#include "deadpoint/core/observer.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/study/loads.hpp"
#include "deadpoint/study/translate_friction.hpp"
#include "deadpoint/study/translate_materials.hpp"

#include <vector>

namespace deadpoint::study {

/// Order of the elements of every part of the machine.
std::vector<int> describe_orders(const casefile::Case& input, const Machine& machine);

/// Corners of cells in parts of either order.
struct CornerCount {
    long long first_order = 0;
    long long second_order = 0;
    /// Of the heat, about: a second-order mesh has eight for each corner.
    [[nodiscard]] long long unknowns() const { return first_order + 8 * second_order; }
};
CornerCount count_corners(const casefile::Case& input, const Machine& machine);

/// The heat problem of a case: interfaces in the order of the machine's, sources in the order of `Case::friction`.
///
/// A probe beyond the symmetry plane of a half model stands for its mirror image. Warns about friction that no joint
/// uses, about process forces, where calibrated heat does not follow them, and about conductances outside their law's
/// tested range. Conductances hold for the whole run, at the speed of the first segment in which the press runs.
///
/// @param loads  for contact pressures and speeds of bodies that the case leaves out; may be null
HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer,
                          const LoadsResult* loads = nullptr);
/// The same with friction laws that have computed loads already.
HeatProblem describe_heat(const casefile::Case& input, const Machine& machine, Observer& observer,
                          const LoadsResult* loads, FrictionLaws& friction);

/// A course over the time since the run began; a table counts from `start` [s], a daily course from the run's begin.
TimeCourse time_course(const casefile::Course& course, double start);
/// A share of a power over the time since the run began.
TimeCourse scaled_power(const casefile::Course& power, double share);
/// Ambient temperature during a segment that begins at `start` [s].
TimeCourse segment_ambient(const casefile::Case& input, const casefile::Segment& segment, double start);

/// Share of the press that is modelled.
inline double modelled_share(const Machine& machine) { return machine.half_model ? 0.5 : 1.0; }

/// Index of a part by name, or -1.
int part_index(const Machine& machine, const std::string& name);
/// Index of a surface by name, or -1.
int surface_index(const Machine& machine, const std::string& name);

}  // namespace deadpoint::study
