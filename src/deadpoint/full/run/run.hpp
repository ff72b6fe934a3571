#pragma once

#include "deadpoint/fem/space/fields.hpp"
#include "deadpoint/press/run/run_outputs.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint {
class Observer;
struct HeatProblem;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::fem {
class Model;
}

namespace deadpoint::drift {
struct BearingPlay;
}
namespace deadpoint::press {
struct ChainModel;
struct FieldOptions;
struct RunResult;
}  // namespace deadpoint::press
namespace deadpoint::twin {
struct ReducedStates;
struct Reduction;
}  // namespace deadpoint::twin

/// The pipeline of one case: machine -> loads -> linkage -> deformation functionals -> heat -> drift.
namespace deadpoint::full {

struct ReduceOptions;

/// Run context at the end of the time steps.
struct RunContext {
    const Machine& machine;
    fem::Model& model;
    const HeatProblem& problem;
    const press::ChainModel* chain;  ///< where the case has one
    const drift::BearingPlay& play;  ///< of its crank
    const std::vector<fem::Adjoint>& adjoints;
    const std::vector<std::pair<double, fem::Field>>& fields;  ///< at RunOptions::kept_times
    double reference;                                          ///< temperature without deformation [K]
};

struct RunOptions : press::RunOutputs {
    std::string start_from;  ///< temperature state to start from instead of the initial temperature; empty: none
    std::string checkpoint_file = {};     ///< where the time steps save their state; empty: nowhere
    double checkpoint_interval = 600;     ///< fem::CheckpointPlan's
    std::string resume_from = {};         ///< checkpoint to continue from; empty: none
    std::vector<double> kept_times = {};  ///< ascending: fields that `on_finish` is given [s]
    std::function<void(const RunContext&)> on_finish = {};
};

/// One machine, ready for runs of similar cases. The common parts are built once: the unknowns, the
/// factor of the deformation and the adjoints of the dimension chain. The heat matrices of
/// prepare() are used by the first following run with the same convection coefficients and
/// conductances, in each process that inherits the prepared memory.
class SharedModel {
public:
    /// @param machine      must outlive this
    /// @param deformation  the machine meshed for the deformation, where that is another mesh; must outlive this
    explicit SharedModel(const Machine& machine, const Machine* deformation = nullptr);
    ~SharedModel();
    SharedModel(SharedModel&&) noexcept;

    /// Checks what a run needs of a case on its meshes, before anything is assembled.
    /// @throws CaseError with all that is wrong with loads, laws, dimension chain and preloads; CaseDomainError where
    ///         values are out of the range of laws
    void check(const casefile::Case& input, Observer& observer);
    /// Builds everything that does not depend on the operating point. A following run() of this or a similar case
    /// starts at the time steps. Errors as run_case.
    void prepare(const casefile::Case& input, Observer& observer);
    /// As run_case, for cases of one press::press::model_key().
    press::RunResult run(const casefile::Case& input, const RunOptions& options, Observer& observer);
    /// Builds a reduced model of the case. Errors as run(), and as reduce_case().
    std::optional<twin::Reduction> reduce(const casefile::Case& input, const ReduceOptions& options,
                                          Observer& observer);
    /// The fields of a run on a reduced model, as lift_fields().
    void lift(const casefile::Case& input, const std::string& file, const twin::ReducedStates& run,
              const press::FieldOptions& options, press::RunResult& result, Observer& observer);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// Computes a case on its meshed machine. Collective under MPI: all ranks call it and get the same result.
///
/// The deformation is left out if the case has no dimension chain. After Observer::cancelled() the
/// result holds everything up to the last finished step, marked as interrupted. A resumed run gives
/// the results of an uninterrupted one (fem/conduction/checkpoint).
///
/// @param deformation  as SharedModel
/// @throws InputError, DomainError, ConvergenceError, IoError
press::RunResult run_case(const casefile::Case& input, const Machine& machine, const RunOptions& options,
                          Observer& observer, const Machine* deformation = nullptr);

}  // namespace deadpoint::full
