#pragma once

#include "deadpoint/exchange/deformation.hpp"
#include "deadpoint/exchange/gaps.hpp"

#include <string>
#include <vector>

namespace deadpoint {

struct Machine;
struct DriftSeries;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}

/// Corners of the slide, clearances and the force at a fixed die height.
namespace deadpoint::press {

struct ChainModel;

/// Corners and clearances of a case's chain, as functionals of the deformation.
struct GapModel {
    struct Clearance {
        std::string name;
        ClearanceSeries::Kind kind = ClearanceSeries::Kind::bearing;
        std::string joint;
    };
    std::vector<CornerSeries> corners;  ///< of the model: two in a half model
    std::vector<Clearance> clearances;
    std::vector<std::string> left_out;    ///< joints without a clearance, with the reason
    std::vector<Functional> functionals;  ///< of corners, then of clearances
    bool mirrored = false;                ///< the corners at x > 0 are mirror images
};

GapModel describe_gaps(const casefile::Case& input, const Machine& machine, const ChainModel& chain);

/// Tilts of the slide by the gaps at its corners.
/// @param mirrored  the corners on the right are images of those on the left
Parallelism parallelism(std::vector<CornerSeries> corners, bool mirrored);

/// The curves, from the history's functionals from index `first` on, in the order of
/// GapModel::functionals.
/// @param drift  of the same history: contribution of the crank's play to the corners, and E_SW
GapSeries gap_series(const casefile::Case& input, const GapModel& model, const ThermalHistory& history, int first,
                     const DriftSeries& drift);

/// Warnings of clearances that heat uses up.
std::vector<std::string> gap_warnings(const GapSeries& gaps);

}  // namespace deadpoint::press
