#pragma once

#include "deadpoint/casefile/describe/case.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint::press {
struct HeatTables;
struct LoadsResult;
struct RunResult;
}  // namespace deadpoint::press

namespace deadpoint {

class Observer;
struct Machine;
class MeshedParts;
}  // namespace deadpoint
namespace deadpoint::press {
struct FieldOptions;
}
namespace deadpoint::twin {
struct ReducedStates;
struct Reduction;
}  // namespace deadpoint::twin

/// The pipeline of a case: mesh -> loads -> laws -> model -> run.
namespace deadpoint::full {

class SharedModel;
struct ReduceOptions;
struct RunOptions;

/// A press that was read. It builds its meshes and its model when they are first needed, each once,
/// and keeps them for later calls. The command line, sweeps, refinement and the public Press use
/// it. It adds places in the files to mistakes of the case (casefile/files/case_source.hpp).
class Press {
public:
    /// @param size_scale  on all cell sizes, > 0
    explicit Press(casefile::Case input, double size_scale = 1);
    ~Press();
    Press(Press&&) noexcept;
    Press& operator=(Press&&) noexcept;

    [[nodiscard]] const casefile::Case& input() const { return input_; }
    /// Becomes the press of another case. Keeps meshes and model if press::model_part() is the same, else
    /// nothing.
    void take(casefile::Case input);

    /// The mesh of the parts. Its warnings go to the observer of every call, those that come after meshing too, so that
    /// every run and check gets all of them. Errors as mesh_machine() and
    /// check_on_machine().
    /// @param kept  meshes of its parts, for a sketch where the machine is refused; may be null
    const Machine& machine(Observer& observer, MeshedParts* kept = nullptr);
    /// Builds the meshes of a run: of the parts, and of the deformation if that is a separate mesh.
    /// @throws InputError as machine() and prepare_deformation_machine()
    void mesh(Observer& observer);
    /// Wall time of the meshes so far [s].
    [[nodiscard]] double mesh_seconds() const { return mesh_seconds_; }

    /// Motion, joint forces and crankshaft loads over a turn; meshes only if masses follow from
    /// parts. Warnings go to the observer too. Errors as compute_loads().
    /// @param segment  of the operation, from 0
    press::LoadsResult loads(int segment, Observer& observer);
    /// Friction heat, contact conductances and convection in one segment; a case without parts has
    /// friction laws only. Warnings go to the observer too. Errors as press::heat_tables().
    press::HeatTables heat_tables(int segment, Observer& observer);

    /// Finds what a run would refuse before it assembles anything: of the meshes, the loads, the laws, the dimension
    /// chain and the preloads. A case without parts is checked for its loads only.
    /// @throws CaseError, CaseDomainError
    void check(Observer& observer);
    /// Builds everything that does not depend on the operating point, as SharedModel::prepare(). Collective.
    void prepare(Observer& observer);
    /// Computes the case, as run_case(). Collective.
    press::RunResult run(const RunOptions& options, Observer& observer);
    /// Builds a reduced model of the case, as SharedModel::reduce(). Collective.
    std::optional<twin::Reduction> reduce(const ReduceOptions& options, Observer& observer);
    /// The fields of a run of the case on a reduced model, as SharedModel::lift(). Collective.
    void lift(const std::string& file, const twin::ReducedStates& run, const press::FieldOptions& options,
              press::RunResult& result, Observer& observer);
    /// Frees the model of prepare() and run(); the meshes stay.
    void drop_model();

private:
    SharedModel& model(Observer& observer);

    casefile::Case input_;
    double size_scale_;
    std::unique_ptr<Machine> machine_;
    std::unique_ptr<Machine> deformed_;  ///< meshed for the deformation, where that is another mesh
    std::unique_ptr<SharedModel> model_;
    std::vector<std::string> mesh_warnings_;
    double mesh_seconds_ = 0;
    bool meshed_ = false;  ///< both of them
};

}  // namespace deadpoint::full
