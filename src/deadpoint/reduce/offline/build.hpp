#pragma once

#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/full_model.hpp"
#include "deadpoint/reduce/offline/small_model.hpp"
#include "deadpoint/reduce/online/box.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace deadpoint {
class Observer;
}

namespace deadpoint::reduce {

class BuildCheckpoint;

/// A reduced model of two sizes. The large one says how far the small one is off.
struct BuiltModels {
    std::shared_ptr<const PreparedTerms> large;
    SmallModel small;
    std::shared_ptr<const ResidualTerms> residual;  ///< of the large one, if BuildOptions::certificate asks for it
};

/// Builds a reduced model in two stages.
///
/// 1. Fields (shift M + K)^-1 load at values drawn from the box, one load after the other, with shifts between
///    1e-7 and 0.5 1/s. They are orthonormal in M; the large model is the Galerkin projection on them.
/// 2. Training runs of the large model in the box. The small model has the states that occur most in them and in the
///    dual problem of E_SW.
/// The basis of the full model is that of the small model afterwards.
/// Pieces that were kept are not computed again; on one rank the result is the same bit by bit.
/// @param points  of operation, the case's own first, with constant convection coefficients. They differ in friction
///                heat. Each is trained alike, half of the runs with a pause
/// @param kept  where finished pieces are kept
/// @return nothing after Observer::cancelled()
std::optional<BuiltModels> build(FullModel& full, const std::vector<HeatProblem>& points, const Box& box,
                                 const BuildOptions& options, const BuildCheckpoint& kept, Observer& observer);

}  // namespace deadpoint::reduce
