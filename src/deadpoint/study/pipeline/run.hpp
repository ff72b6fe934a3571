#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/observer.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/gaps.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/study/drift/frame_state.hpp"
#include "deadpoint/study/laws/friction.hpp"
#include "deadpoint/study/pipeline/accuracy.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "deadpoint/study/pipeline/view_data.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The pipeline of one case: machine -> loads -> linkage -> deformation functionals -> heat -> drift.
namespace deadpoint::study {

/// The adjoint's gap against the gap of the deformation solved directly at the last field time.
struct AdjointCheck {
    double time = 0;
    double by_adjoint = 0;
    double by_deformation = 0;
    double joint_opening = 0;  ///< largest distance of two centres of a joint after closing [m]
};

/// A name and its value over the steps, for files and tables.
struct JointHistory {
    std::string name;
    Series temperature;        ///< area mean of both sides of its interfaces [K]
    std::vector<double> heat;  ///< friction heat, whole press [W]
};

struct RunResult {
    ThermalHistory thermal;  ///< of the model: half of the press in a half model
    double whole = 1;        ///< factor from the model to the whole press
    std::vector<std::string> probes;
    std::vector<std::string> parts;
    std::vector<std::string> sources;
    std::vector<std::string> body_heat;   ///< names, as ThermalHistory::body_heat
    std::vector<std::string> oil;         ///< circuits, as ThermalHistory::oil
    std::vector<std::string> enclosures;  ///< names, as ThermalHistory::enclosures
    std::vector<JointHistory> joints;
    std::vector<FrictionSummary> friction;  ///< at every speed and force of the operation
    std::optional<LoadsResult> loads;  ///< of the first segment in which the press runs, where the case has a linkage
    std::optional<BottomDeadPointSensitivity> sensitivity;
    std::optional<DriftSeries> drift;
    std::vector<DriftCauses> causes;  ///< at the largest |E_SW| of all steps, where that is not the end, and at the end
    GapSeries gaps;
    std::optional<AdjointCheck> adjoint_check;
    std::optional<FrameResult> frame;  ///< where the case states a foundation, preload or wanted stress
    std::optional<ViewData> view;
    std::optional<AccuracyReport> accuracy;  ///< where the case asks for one
    long long cells = 0;
    long long heat_unknowns = 0;
    long long deformation_cells = 0;  ///< the same as cells, or those of its own mesh; 0 without deformation
    long long deformation_unknowns = 0;
    int elastic_iterations = 0;
    int ranks = 1;
    double peak_memory = 0;                               ///< of all ranks together [byte]
    std::vector<std::pair<std::string, double>> timings;  ///< stage, wall time [s]
    std::vector<std::pair<double, std::string>> fields;   ///< time [s], file in the results folder
};

struct ChainModel;

/// What is at hand when the time steps are done.
struct RunInside {
    const Machine& machine;
    fem::Model& model;
    const HeatProblem& problem;
    const ChainModel* chain;         ///< where the case has one
    const drift::BearingPlay& play;  ///< of its crank
    const std::vector<fem::Adjoint>& adjoints;
    const std::vector<std::pair<double, fem::Field>>& fields;  ///< at RunOptions::kept_times
    double reference;                                          ///< temperature without deformation [K]
};

struct RunOptions {
    std::string start_from;    ///< temperature state to start from instead of the initial temperature; empty: none
    std::string state_file;    ///< where the state at the end is written; empty: nowhere
    std::string field_folder;  ///< existing folder for field files; empty: no field files
    std::vector<std::string> comments = {};  ///< for the head of the field files: version, case hash, warnings so far
    bool view = false;                       ///< make RunResult::view
    bool causes = false;                     ///< make RunResult::causes, where the case has a dimension chain
    std::string checkpoint_file = {};        ///< where the time steps keep their state; empty: nowhere
    double checkpoint_interval = 600;        ///< fem::CheckpointPlan's
    bool resume = false;                     ///< go on from checkpoint_file
    std::vector<double> kept_times = {};     ///< ascending: fields that `at_end` is given [s]
    std::function<void(const RunInside&)> at_end = {};
};

/// One machine, ready for runs of like cases: what does not change between them is made once, the unknowns, the factor
/// of the deformation and the adjoints of the dimension chain. The heat matrices that prepare() makes serve the first
/// run after it whose films and conductances are the same, in each process that takes the prepared memory over.
class SharedModel {
public:
    /// @param machine      must outlive this
    /// @param deformation  the machine meshed for the deformation, where that is another mesh; must outlive this
    explicit SharedModel(const Machine& machine, const Machine* deformation = nullptr);
    ~SharedModel();
    SharedModel(SharedModel&&) noexcept;

    /// Makes all of it for a case, whose run and whose like's then start with the time steps. Errors as run_case.
    void prepare(const casefile::Case& input, Observer& observer);
    /// As run_case, for cases of one shared_part().
    RunResult run(const casefile::Case& input, const RunOptions& options, Observer& observer);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

/// The part of a case on which SharedModel rests, as text: equal for cases that can share one. Operating points, loads,
/// friction, oil, other heat, time stepping and output may differ.
std::string shared_part(const casefile::Case& input);

/// Computes a case on its meshed machine. Collective under MPI: all ranks call it and get the same result.
///
/// The deformation is left out where the case has no dimension chain. After Observer::cancelled() the result holds
/// everything up to the last finished step, marked as interrupted. A run that is resumed gives what one without a pause
/// gives (fem/conduction/checkpoint).
///
/// @param deformation  as SharedModel
/// @throws InputError, DomainError, ConvergenceError, IoError
RunResult run_case(const casefile::Case& input, const Machine& machine, const RunOptions& options, Observer& observer,
                   const Machine* deformation = nullptr);

}  // namespace deadpoint::study
