#pragma once

#include "deadpoint/drift/chain.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "deadpoint/press/drift/chain_figures.hpp"

#include <vector>

namespace deadpoint::casefile {
struct Case;
}

/// The dimension chain of a case.
namespace deadpoint::press {

/// The linkage at bottom dead point and the functionals of the deformation that move it.
struct ChainModel {
    /// @throws InputError if the case is not drawn at bottom dead point; as describe_chain
    ChainModel(const casefile::Case& input, const Machine& machine);

    Linkage linkage;
    mechanism::PlanarSystem system;
    BottomDeadPointSensitivity sensitivity;
    drift::ChainDescription description;
    std::vector<Functional> dimensions;  ///< and behind them the growth of each crank bearing's play
    std::vector<Functional> centres;     ///< per joint: in body a (x, y), in body b (x, y)
    double travel_by_play = 0;           ///< drift::travel_by_play

    [[nodiscard]] int bearings() const { return static_cast<int>(dimensions.size()) - drift::dimension_count; }
    [[nodiscard]] ChainFigures figures() const;
    /// Contribution of the crank's play to the slide's height, with these shares of its bearings'
    /// growths [m].
    [[nodiscard]] double play_travel(const std::vector<double>& shares, const std::vector<double>& growths) const;
};

/// Part of the play's growth that moves the slide: the mean over the crank's bearings of share times growth [m].
double mean_play(const std::vector<double>& shares, const std::vector<double>& growths);

/// E_SW as one functional, with these shares of the bearings' growths.
Functional gap_functional(const ChainModel& chain, const std::vector<double>& shares);

}  // namespace deadpoint::press
