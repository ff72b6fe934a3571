#include "deadpoint/study/pipeline/model_parts.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/study/drift/chain_model.hpp"
#include "deadpoint/study/drift/frame_state.hpp"
#include "deadpoint/study/drift/gap_model.hpp"
#include "deadpoint/study/drift/press_compliance.hpp"
#include "deadpoint/study/laws/run_laws.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "deadpoint/study/pipeline/prepare.hpp"
#include "deadpoint/study/pipeline/run_warnings.hpp"
#include "deadpoint/study/pipeline/stopwatch.hpp"
#include "deadpoint/study/result/run_result.hpp"
#include "deadpoint/study/translate/heat.hpp"
#include "deadpoint/study/translate/materials.hpp"

#include <algorithm>
#include <iterator>
#include <memory>

namespace deadpoint::study {

ModelParts::ModelParts(const Machine& meshed, const Machine* own) : machine(meshed), own_deformation(own) {}
ModelParts::~ModelParts() = default;

HeatProblem ModelParts::translate(const casefile::Case& input, Stopwatch& watch, RunResult& result, Observer& observer)
{
    HeatProblem problem;
    Mistakes mistakes;
    mistakes.attempt("operation",
                     [&] { problem = run_laws(input, machine, Vibration::computed, watch, result, observer); });
    watch.stop();
    warn_of_loads(input, machine, result, observer);
    if (input.chain && !chain)
        mistakes.attempt("chain", [&] { chain = std::make_unique<ChainModel>(input, deformed()); });
    mistakes.attempt("preload", [&] { frame_gauges(input, deformed()); });
    mistakes.raise();
    return problem;
}

void ModelParts::need_model(const casefile::Case& input, Stopwatch& watch, Observer& observer)
{
    if (model)
        return;
    watch.start("unknowns");
    model.emplace(machine, describe_materials(input, machine), describe_orders(input, machine), observer,
                  own_deformation, describe_orders(case_of_deformation(input), deformed()));
    model->support(describe_foundation(input, deformed()));
    if (input.chain) {
        watch.start("dimension chain");
        need_chain(input);
    }
    frame_adjoints = adjoints.size();
    if (has_frame_state(input)) {
        watch.start("frame");
        frame = std::make_unique<FrameState>(input, deformed(), *model);
        std::ranges::copy(frame->adjoints(), std::back_inserter(adjoints));
    }
    watch.stop();
}

void ModelParts::need_chain(const casefile::Case& input)
{
    gaps = std::make_unique<GapModel>(describe_gaps(input, deformed(), *chain));
    auto functionals = chain->dimensions;
    functionals.insert(functionals.end(), gaps->functionals.begin(), gaps->functionals.end());
    adjoints = model->adjoints(functionals);
    compliance = press_compliance(*model, *chain, *gaps, machine.half_model);
}

void ModelParts::note_sizes(RunResult& result) const
{
    const auto size = model->size();
    result.cells = size.cells;
    result.heat_unknowns = size.heat_unknowns;
    if (chain || frame) {
        result.deformation_cells = size.deformation_cells;
        result.deformation_unknowns = size.deformation_unknowns;
    }
}

void ModelParts::note_work(RunResult& result) const
{
    result.elastic_iterations = model->elastic_iterations();
    result.ranks = fem::ranks();
    result.peak_memory = fem::peak_memory();
}

}  // namespace deadpoint::study
