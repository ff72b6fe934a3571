#pragma once

#include "deadpoint/casefile/case.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/planar_system.hpp"

#include <vector>

/// Internal to study/: the dimension chain of a case on its meshed machine.
namespace deadpoint::study {

/// The linkage at bottom dead point and what the deformation moves in it.
struct ChainModel {
    /// @throws InputError if the case is not drawn at bottom dead point; as describe_chain
    ChainModel(const casefile::Case& input, const Machine& machine);

    Linkage linkage;
    mechanism::PlanarSystem system;
    BottomDeadPointSensitivity sensitivity;
    drift::ChainDescription description;
    std::vector<Functional> dimensions;
    std::vector<Functional> centres;  ///< per joint: in body a (x, y), in body b (x, y)
    Functional growth;                ///< of the clearance, out of E_BC
};

/// What closes the joints again after a deformation.
struct Closing {
    std::vector<RigidMotion> motions;  ///< per part
    double gap = 0;                    ///< E_SW, straight from the deformation [m]
    double opening = 0;                ///< largest distance of two centres of a joint that is left [m]
};

Closing close_joints(const Machine& machine, fem::Model& model, const ChainModel& chain,
                     const fem::Displacement& displacement);

/// The chain over time out of the functionals of the dimensions.
DriftSeries drift_series(const ThermalHistory& history);

}  // namespace deadpoint::study
