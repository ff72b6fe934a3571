#pragma once

#include <cstddef>

namespace deadpoint {
struct ThermalHistory;
}

namespace deadpoint::reduce {

/// Time of a segment after which errors count [s].
inline constexpr double settled_after = 60;

/// Largest differences of two runs at the ends of the steps of both, after the first minute of each segment: before,
/// the mesh itself resolves little. The end of a shorter segment counts too.
struct RunDifference {
    double temperature = 0;  ///< of probes and of the sides of joints [K]
    double gap = 0;          ///< of E_SW [m]
    void widen(const RunDifference& other);
};
/// @param functional  E_SW among ThermalHistory::functionals; none where there is no such index
RunDifference difference(const ThermalHistory& run, const ThermalHistory& other, std::size_t functional);

}  // namespace deadpoint::reduce
