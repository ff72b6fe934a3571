#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/press/result/press_compliance.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace deadpoint {
class Observer;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint {
class Stopwatch;
}
namespace deadpoint::press {
struct ChainModel;
struct GapModel;
struct RunResult;
}  // namespace deadpoint::press

/// The model of a machine and what is built on it once.
namespace deadpoint::full {

class FrameState;

/// Data that runs of similar cases share.
struct ModelParts {
    ModelParts(const Machine& meshed, const Machine* own);
    ~ModelParts();
    ModelParts(const ModelParts&) = delete;

    /// Evaluates the laws of a case; stores loads and friction in the result.
    /// @throws CaseError with all errors of a case on its meshes: loads, laws, dimension chain, preloads
    HeatProblem translate(const casefile::Case& input, Stopwatch& watch, press::RunResult& result, Observer& observer);
    /// Creates unknowns, dimension chain and adjoints if they do not exist yet, from press::model_part() of the case.
    void need_model(const casefile::Case& input, Stopwatch& watch, Observer& observer);
    void need_chain(const casefile::Case& part);
    /// Numbers of cells and unknowns.
    void note_sizes(press::RunResult& result) const;
    /// Iterations of the deformation, ranks and memory so far.
    void note_work(press::RunResult& result) const;

    /// The machine with the mesh of the deformation.
    [[nodiscard]] const Machine& deformed() const { return own_deformation ? *own_deformation : machine; }
    [[nodiscard]] const press::ChainModel* chain_or_none() const { return chain.get(); }
    [[nodiscard]] const FrameState* frame_or_none() const { return frame.get(); }

    const Machine& machine;
    const Machine* own_deformation;
    std::optional<fem::Model> model;
    std::unique_ptr<press::ChainModel> chain;
    std::unique_ptr<press::GapModel> gaps;
    std::unique_ptr<FrameState> frame;
    std::optional<press::PressCompliance> compliance;
    std::vector<fem::Adjoint> adjoints;    ///< of the chain's dimensions and plays, of the gaps, of the frame
    std::size_t frame_adjoints = 0;        ///< index of the first adjoint of the frame
    std::optional<HeatProblem> assembled;  ///< the problem of the prepared matrices
};

}  // namespace deadpoint::full
