#include "deadpoint/study/reduce/reduce.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/exchange/bare_machine.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/reduction/heat_projector.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/offline/build.hpp"
#include "deadpoint/reduce/offline/difference.hpp"
#include "deadpoint/reduce/offline/training.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"
#include "deadpoint/study/drift/chain_model.hpp"
#include "deadpoint/study/drift/frame_state.hpp"
#include "deadpoint/study/pipeline/model_parts.hpp"
#include "deadpoint/study/pipeline/stopwatch.hpp"
#include "deadpoint/study/reduce/split.hpp"
#include "deadpoint/study/result/run_result.hpp"
#include "deadpoint/study/translate/materials.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace deadpoint::study {
namespace {

constexpr unsigned long long full_seed = 4;

void refuse_tables(const casefile::Case& input, const Machine& machine, Mistakes& mistakes)
{
    const auto materials = describe_materials(input, machine);
    std::set<std::string> refused;
    for (std::size_t p = 0; p < materials.size(); ++p) {
        const auto& m = materials[p];
        const auto& name = input.parts.at(machine.parts[p].name).material;
        const bool varies =
            !m.conductivity_table.empty() || !m.specific_heat_table.empty() || !m.expansion_table.empty();
        if (varies && refused.insert(name).second)
            mistakes.add("materials." + name,
                         "a reduced model needs a material whose properties are constant, and this one has a table",
                         "give it constants at the temperature at which the press works");
    }
}

void refuse_prescribed(const HeatProblem& problem, Mistakes& mistakes)
{
    for (const auto& condition : problem.surfaces)
        if (condition.kind == SurfaceCondition::Kind::temperature)
            mistakes.add("surfaces." + condition.name, "a reduced model takes no prescribed temperature",
                         "state a film with a high coefficient and that ambient");
}

bool starts_uniform(const HeatProblem& problem, std::size_t parts)
{
    for (std::size_t p = 1; p < parts; ++p)
        if (problem.initial_temperature(static_cast<int>(p), {}) != problem.initial_temperature(0, {}))
            return false;
    return true;
}

reduce::BuildOptions complete(reduce::BuildOptions options, const ModelParts& parts, const casefile::Case& input)
{
    options.adjoints = parts.adjoints.size();
    options.reference = input.machine.initial_temperature;
    options.has_dual = parts.chain != nullptr;
    options.dual_row = drift::gap;
    return options;
}

fem::Attribution attribution_of(const ModelParts& parts)
{
    return parts.chain ? fem::Attribution(drift::gap, 1 + parts.chain->bearings()) : fem::Attribution(-1);
}

class Silent : public Observer {};

/// Full runs, against both models.
class FullRuns {
public:
    FullRuns(ModelParts& parts, const reduce::BuildOptions& options) : parts_(parts), options_(options) {}

    void compare(const HeatProblem& problem, const reduce::BuiltModels& models, reduce::RunDifference& large,
                 reduce::RunDifference& small)
    {
        parts_.model->assemble_heat(problem);
        const auto full =
            parts_.model->heat(parts_.adjoints, options_.reference, attribution_of(parts_), silent_, [](double) {}, {});
        parts_.model->release_heat();
        large.widen(to_full(models.large, problem, full));
        small.widen(to_full(models.small.terms, problem, full));
    }

private:
    [[nodiscard]] reduce::RunDifference to_full(const std::shared_ptr<const reduce::PreparedTerms>& terms,
                                                const HeatProblem& problem, const ThermalHistory& full)
    {
        reduce::ReducedRun run(terms, problem, options_.adjoints, options_.reference);
        return reduce::difference(run.go({}, silent_), full, options_.has_dual ? options_.dual_row : SIZE_MAX);
    }
    ModelParts& parts_;
    const reduce::BuildOptions& options_;
    Silent silent_;
};

StatedError stated(const std::string& of, const reduce::RunDifference& difference)
{
    return {of, difference.temperature, difference.gap};
}

// Errors to full runs: of the case, and of drawn coefficients.
void compare_with_full_runs(ModelParts& parts, const reduce::BuildOptions& options, const HeatProblem& as_stated,
                            const HeatProblem& nominal, const reduce::BuiltModels& models, int count, Reduction& result,
                            Observer& observer)
{
    FullRuns runs(parts, options);
    reduce::Draws draws(full_seed);
    observer.stage("full runs");
    reduce::RunDifference large, small, large_drawn, small_drawn;
    runs.compare(as_stated, models, large, small);
    for (int k = 1; k < count; ++k) {
        runs.compare(reduce::drawn_problem(nominal, result.small.box, draws), models, large_drawn, small_drawn);
        observer.progress((k + 1.0) / count, fmt::format("{} of {}", k + 1, count));
    }
    result.large.errors.push_back(stated("as in the case, to a full run", large));
    result.small.errors.push_back(stated("as in the case, to a full run", small));
    if (count < 2)
        return;
    const auto of = fmt::format("{} full runs with drawn coefficients", count - 1);
    result.large.errors.push_back(stated(of, large_drawn));
    result.small.errors.push_back(stated(of, small_drawn));
}

void give_terms(ReducedPress& press, std::shared_ptr<const reduce::PreparedTerms> terms)
{
    press.states = static_cast<std::size_t>(terms->terms.uniform.size());
    press.terms = std::move(terms);
}

// All of a reduced press but its terms and errors.
ReducedPress press_without_terms(const ModelParts& parts, const casefile::Case& input,
                                 const reduce::BuildOptions& options)
{
    ReducedPress press;
    press.version = version;
    press.name = input.machine.name;
    press.case_hash = casefile::case_hash(input);
    press.fixed_part = fixed_part(input);
    press.machine = without_mesh(parts.machine);
    press.cells = static_cast<std::size_t>(parts.model->size().cells);
    press.unknowns = static_cast<std::size_t>(parts.model->size().heat_unknowns);
    press.adjoints = options.adjoints;
    press.reference = options.reference;
    if (parts.chain) {
        press.chain = ReducedChain{parts.chain->figures(), *parts.gaps, parts.chain->dimensions.size()};
        press.chain->gaps.functionals.clear();
    }
    if (parts.frame)
        press.frame = parts.frame->start();
    press.first_frame = parts.frame_adjoints;
    return press;
}

}  // namespace

ReduceOptions reduce_options(const casefile::Case& input)
{
    const auto wanted = input.reduce.value_or(casefile::Reduce{});
    const auto span = [](const std::array<double, 2>& range) { return Span{range[0], range[1]}; };
    ReduceOptions options;
    options.ranges = {span(wanted.film),     span(wanted.conductance),     span(wanted.oil),
                      span(wanted.friction), span(wanted.oil_temperature), span(wanted.ambient),
                      !wanted.together};
    options.build.temperature = wanted.temperature;
    options.build.gap = wanted.gap;
    options.build.largest = static_cast<std::size_t>(wanted.states);
    return options;
}

Reduction reduce_case(ModelParts& parts, const casefile::Case& input, const ReduceOptions& options, Observer& observer)
{
    Stopwatch watch(observer);
    RunResult unused;
    const auto problem = parts.translate(input, watch, unused, observer);
    Mistakes mistakes;
    refuse_tables(input, parts.machine, mistakes);
    refuse_prescribed(problem, mistakes);
    mistakes.raise();
    parts.need_model(input, watch, observer);

    auto as_stated = split_by_part(problem, parts.machine);
    as_stated.problem.field_times.clear();
    auto nominal = as_stated;
    nominal.problem = with_nominal_films(nominal.problem, input.machine.initial_temperature);
    const auto full = parts.model->projector(nominal.problem, parts.adjoints, attribution_of(parts));
    for (std::size_t p = 0; p < parts.machine.parts.size() && !starts_uniform(problem, parts.machine.parts.size()); ++p)
        full->add_part(p);
    const auto build_options = complete(options.build, parts, input);
    Reduction result;
    result.small = press_without_terms(parts, input, build_options);
    result.small.box = free_coefficients(nominal, parts.machine, options.ranges, input.machine.initial_temperature);
    result.large = result.small;
    auto models = reduce::build(*full, nominal.problem, result.small.box, build_options, observer);
    result.small.errors = {stated("anywhere in the box, to the large model", models.small.in_box),
                           stated("as in the case, to the large model", models.small.at_base)};
    for (const auto& [states, error] : models.small.by_size)
        result.small.sizes.push_back({states, error.temperature, error.gap});
    if (!options.fields_file.empty())
        full->write_fields(options.fields_file, reduce::mark_of(models.small.terms->terms));
    if (options.full_runs > 0)
        compare_with_full_runs(parts, build_options, as_stated.problem, nominal.problem, models, options.full_runs,
                               result, observer);
    give_terms(result.small, std::move(models.small.terms));
    give_terms(result.large, std::move(models.large));
    result.residual = std::move(models.residual);
    return result;
}

}  // namespace deadpoint::study
