#pragma once

#include "deadpoint/exchange/deformation.hpp"

#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::fem {
struct Adjoint;
struct Displacement;
struct Field;
class Model;
}  // namespace deadpoint::fem
namespace deadpoint::press {
struct ChainModel;
}

/// The dimension chain evaluated on a mesh. Collective, as fem::Model.
namespace deadpoint::full {

/// The adjoint of E_SW, with these shares of the bearings' growths.
/// @param adjoints  of ChainModel::dimensions, first
fem::Adjoint gap_adjoint(const press::ChainModel& chain, const std::vector<fem::Adjoint>& adjoints,
                         const std::vector<double>& shares);
/// Growth of each crank bearing's play at a temperature field [m].
std::vector<double> play_growths(const press::ChainModel& chain, fem::Model& model,
                                 const std::vector<fem::Adjoint>& adjoints, const fem::Field& field, double reference);

/// Rigid motions that close the joints again after a deformation.
struct Closing {
    std::vector<RigidMotion> motions;  ///< per part
    double gap = 0;                    ///< E_SW, straight from the deformation [m]
    double opening = 0;                ///< largest distance of two centres of a joint that is left [m]
};

/// @param shares  of the growth of each crank bearing's play; the motions are linear in the
/// displacement
Closing close_joints(const Machine& machine, fem::Model& model, const press::ChainModel& chain,
                     const fem::Displacement& displacement, const std::vector<double>& shares);
/// The growths of the crank's bearings' plays in a deformation [m].
std::vector<double> play_growths(const press::ChainModel& chain, fem::Model& model,
                                 const fem::Displacement& displacement);

}  // namespace deadpoint::full
