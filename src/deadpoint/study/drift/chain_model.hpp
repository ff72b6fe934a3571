#pragma once

#include "deadpoint/drift/chain.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "deadpoint/study/drift/chain_figures.hpp"

#include <vector>

namespace deadpoint::fem {
struct Adjoint;
struct Displacement;
struct Field;
}  // namespace deadpoint::fem

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::fem {
class Model;
}

/// Internal to study/: the dimension chain of a case on its meshed machine.
namespace deadpoint::study {

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

/// E_SW as one functional, or the adjoint of it, with these shares of the bearings' growths.
/// @param adjoints  of ChainModel::dimensions, first
Functional gap_functional(const ChainModel& chain, const std::vector<double>& shares);
fem::Adjoint gap_adjoint(const ChainModel& chain, const std::vector<fem::Adjoint>& adjoints,
                         const std::vector<double>& shares);
/// Growth of each crank bearing's play at a temperature field [m].
std::vector<double> play_growths(const ChainModel& chain, fem::Model& model, const std::vector<fem::Adjoint>& adjoints,
                                 const fem::Field& field, double reference);

/// Rigid motions that close the joints again after a deformation.
struct Closing {
    std::vector<RigidMotion> motions;  ///< per part
    double gap = 0;                    ///< E_SW, straight from the deformation [m]
    double opening = 0;                ///< largest distance of two centres of a joint that is left [m]
};

/// @param shares  of the growth of each crank bearing's play; the motions are linear in the
/// displacement
Closing close_joints(const Machine& machine, fem::Model& model, const ChainModel& chain,
                     const fem::Displacement& displacement, const std::vector<double>& shares);
/// The growths of the crank's bearings' plays in a deformation [m].
std::vector<double> play_growths(const ChainModel& chain, fem::Model& model, const fem::Displacement& displacement);

}  // namespace deadpoint::study
