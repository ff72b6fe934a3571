#include "deadpoint/full/model/model_parts.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/frame/frame_state.hpp"
#include "deadpoint/full/frame/press_compliance.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/machine/model_part.hpp"
#include "deadpoint/press/problem/deformation_mesh.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/problem/run_laws.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/run/run_warnings.hpp"
#include "deadpoint/press/translate/materials.hpp"

#include <algorithm>
#include <iterator>
#include <memory>

namespace deadpoint::full {

ModelParts::ModelParts(const Machine& meshed, const Machine* own) : machine(meshed), own_deformation(own) {}
ModelParts::~ModelParts() = default;

HeatProblem ModelParts::translate(const casefile::Case& input, Stopwatch& watch, press::RunResult& result,
                                  Observer& observer)
{
    HeatProblem problem;
    Mistakes mistakes;
    mistakes.attempt("operation", [&] {
        problem = press::run_laws(input, machine, press::Vibration::computed, watch, result, observer);
    });
    watch.stop();
    press::warn_of_loads(input, machine, result, observer);
    if (input.chain && !chain)
        mistakes.attempt("chain",
                         [&] { chain = std::make_unique<press::ChainModel>(press::model_part(input), deformed()); });
    mistakes.attempt("preload", [&] { frame_gauges(input, deformed()); });
    mistakes.raise();
    return problem;
}

void ModelParts::need_model(const casefile::Case& input, Stopwatch& watch, Observer& observer)
{
    if (model)
        return;
    const auto part = press::model_part(input);
    watch.start("unknowns");
    model.emplace(machine, press::describe_materials(part, machine), press::describe_orders(part, machine), observer,
                  own_deformation, press::describe_orders(press::case_of_deformation(part), deformed()));
    model->support(describe_foundation(part, deformed()));
    if (part.chain) {
        watch.start("dimension chain");
        need_chain(part);
    }
    frame_adjoints = adjoints.size();
    if (has_frame_state(part)) {
        watch.start("frame");
        frame = std::make_unique<FrameState>(part, deformed(), *model);
        std::ranges::copy(frame->adjoints(), std::back_inserter(adjoints));
    }
    watch.stop();
}

void ModelParts::need_chain(const casefile::Case& part)
{
    gaps = std::make_unique<press::GapModel>(press::describe_gaps(part, deformed(), *chain));
    auto functionals = chain->dimensions;
    functionals.insert(functionals.end(), gaps->functionals.begin(), gaps->functionals.end());
    adjoints = model->adjoints(functionals);
    compliance = press_compliance(*model, *chain, *gaps, machine.half_model);
}

void ModelParts::note_sizes(press::RunResult& result) const
{
    const auto size = model->size();
    result.cells = size.cells;
    result.heat_unknowns = size.heat_unknowns;
    if (chain || frame) {
        result.deformation_cells = size.deformation_cells;
        result.deformation_unknowns = size.deformation_unknowns;
    }
}

void ModelParts::note_work(press::RunResult& result) const
{
    result.elastic_iterations = model->elastic_iterations();
    result.ranks = fem::ranks();
    result.peak_memory = fem::peak_memory();
}

}  // namespace deadpoint::full
