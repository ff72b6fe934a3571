#include "deadpoint/full/run/reduce.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/exchange/bare_machine.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/reduction/heat_projector.hpp"
#include "deadpoint/full/frame/frame_state.hpp"
#include "deadpoint/full/model/model_parts.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/press/translate/materials.hpp"
#include "deadpoint/reduce/kept/build_checkpoint.hpp"
#include "deadpoint/reduce/offline/build.hpp"
#include "deadpoint/reduce/offline/difference.hpp"
#include "deadpoint/reduce/offline/training.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"
#include "deadpoint/twin/run/films_by_part.hpp"
#include "deadpoint/twin/run/operating_points.hpp"
#include "deadpoint/twin/run/quiet_observer.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace deadpoint::full {
namespace {

constexpr unsigned long long full_seed = 4;

void refuse_tables(const casefile::Case& input, const Machine& machine, Mistakes& mistakes)
{
    const auto materials = press::describe_materials(input, machine);
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

// Fewer sets of coefficients where the fields of all would take too much memory.
int sets_with_room(const reduce::BuildOptions& options, long long unknowns)
{
    constexpr double room = 8e9;  // [byte]
    const double set = static_cast<double>(options.loads_per_set + 1) * sizeof(float) * static_cast<double>(unknowns);
    return std::min(options.sets, static_cast<int>(room / set));
}

reduce::BuildOptions complete(reduce::BuildOptions options, const ModelParts& parts, const casefile::Case& input)
{
    options.sets = sets_with_room(options, parts.model->size().heat_unknowns);
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

struct FullRunErrors {
    reduce::RunDifference large, small;
};

/// Full runs, against both models.
class FullRuns {
public:
    FullRuns(ModelParts& parts, const reduce::BuildOptions& options, const reduce::BuiltModels& models,
             const reduce::BuildCheckpoint& kept, const Observer& observer)
        : parts_(parts), options_(options), models_(models), kept_(kept), silent_(observer)
    {}

    /// Errors in a run, which has a number. @return nothing after Observer::cancelled()
    /// @param full  the problem as the full model takes it  @param reduced  the same split by part
    /// @param known  the full run, if it is there
    std::optional<FullRunErrors> compare(int number, const HeatProblem& full, const HeatProblem& reduced,
                                         const ThermalHistory* known)
    {
        const auto piece = fmt::format("full-run-{:03}", number);
        FullRunErrors errors;
        auto& [large, small] = errors;
        if (kept_.read(piece, large.temperature, large.gap, small.temperature, small.gap))
            return errors;
        const auto history = known ? *known : run(full);
        if (history.interrupted)
            return std::nullopt;
        errors = {to_full(models_.large, reduced, history), to_full(models_.small.terms, reduced, history)};
        kept_.write(piece, large.temperature, large.gap, small.temperature, small.gap);
        return errors;
    }

private:
    [[nodiscard]] ThermalHistory run(const HeatProblem& problem)
    {
        parts_.model->assemble_heat(problem);
        auto history =
            parts_.model->heat(parts_.adjoints, options_.reference, attribution_of(parts_), silent_, [](double) {}, {});
        parts_.model->release_heat();
        return history;
    }
    [[nodiscard]] reduce::RunDifference to_full(const std::shared_ptr<const reduce::PreparedTerms>& terms,
                                                const HeatProblem& problem, const ThermalHistory& full)
    {
        reduce::ReducedRun run(terms, problem, options_.adjoints, options_.reference);
        return reduce::difference(run.go({}, silent_), full, options_.has_dual ? options_.dual_row : SIZE_MAX);
    }
    ModelParts& parts_;
    const reduce::BuildOptions& options_;
    const reduce::BuiltModels& models_;
    const reduce::BuildCheckpoint& kept_;
    twin::Silent silent_;
};

press::StatedError stated(const std::string& of, const reduce::RunDifference& difference)
{
    return {of, difference.temperature, difference.gap};
}

void add_errors(const std::string& of, const FullRunErrors& errors, twin::Reduction& result)
{
    result.large.errors.push_back(stated(of, errors.large));
    result.small.errors.push_back(stated(of, errors.small));
}

// The case as it is, by part, and by part with constant films.
struct Problems {
    HeatProblem whole;
    twin::SplitProblem split, nominal;
    std::vector<twin::SplitProblem> others;  ///< at other speeds and forces
    std::vector<HeatProblem> points;         ///< of operation, with constant films
};

Problems problems_of(const HeatProblem& problem, const ModelParts& parts, const casefile::Case& input,
                     const twin::FreeRanges& ranges, const Observer& observer)
{
    Problems result;
    result.whole = problem;
    result.whole.field_times.clear();
    result.split = twin::split_by_part(result.whole, parts.machine);
    result.nominal = result.split;
    result.nominal.problem = twin::with_nominal_films(result.nominal.problem, input.machine.initial_temperature);
    result.others = twin::other_operation(input, parts.machine, ranges, observer);
    result.points = twin::with_heat_of(result.nominal.problem, result.others);
    return result;
}

// Errors to full runs: of the case, and of drawn coefficients. Returns false if they were interrupted.
bool compare_with_full_runs(FullRuns& runs, const Problems& problems, const reduce::Box& box,
                            const ReduceOptions& options, twin::Reduction& result, Observer& observer)
{
    observer.stage("full runs");
    const auto own = runs.compare(0, problems.whole, problems.split.problem, options.run);
    if (!own)
        return false;
    add_errors("as in the case, to a full run", *own, result);
    reduce::Draws draws(full_seed);
    FullRunErrors drawn;
    for (int k = 1; k < options.full_runs; ++k) {
        const auto problem = reduce::drawn_problem(problems.points, box, draws);
        const auto errors = runs.compare(k, problem, problem, nullptr);
        if (!errors)
            return false;
        drawn.large.widen(errors->large);
        drawn.small.widen(errors->small);
        observer.progress((k + 1.0) / options.full_runs, fmt::format("{} of {}", k + 1, options.full_runs));
    }
    if (options.full_runs > 1)
        add_errors(fmt::format("{} full runs with drawn coefficients", options.full_runs - 1), drawn, result);
    return true;
}

// To the large model.
void state_errors(const reduce::SmallModel& small, twin::ReducedPress& press)
{
    press.errors = {stated("anywhere in the box, to the large model", small.in_box),
                    stated("as in the case, to the large model", small.at_base)};
    for (const auto& [states, error] : small.by_size)
        press.sizes.push_back({states, error.temperature, error.gap});
}

void give_terms(twin::ReducedPress& press, std::shared_ptr<const reduce::PreparedTerms> terms)
{
    press.states = static_cast<std::size_t>(terms->terms.uniform.size());
    press.terms = std::move(terms);
}

// All of a reduced press but its terms and errors.
twin::ReducedPress press_without_terms(const ModelParts& parts, const casefile::Case& input,
                                       const reduce::BuildOptions& options)
{
    twin::ReducedPress press;
    press.version = version;
    press.name = input.machine.name;
    press.case_hash = casefile::case_hash(input);
    press.fixed_part = twin::fixed_part(input);
    press.machine = without_mesh(parts.machine);
    press.cells = static_cast<std::size_t>(parts.model->size().cells);
    press.unknowns = static_cast<std::size_t>(parts.model->size().heat_unknowns);
    press.adjoints = options.adjoints;
    press.reference = options.reference;
    if (parts.chain) {
        press.chain = twin::ReducedChain{parts.chain->figures(), *parts.gaps, parts.chain->dimensions.size()};
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
    const auto span = [](const std::array<double, 2>& range) { return twin::Span{range[0], range[1]}; };
    ReduceOptions options;
    options.ranges = {span(wanted.film),
                      span(wanted.conductance),
                      span(wanted.oil),
                      span(wanted.friction),
                      span(wanted.speed),
                      span(wanted.force),
                      span(wanted.oil_temperature),
                      span(wanted.ambient),
                      !wanted.together};
    options.build.temperature = wanted.temperature;
    options.build.gap = wanted.gap;
    options.build.largest = static_cast<std::size_t>(wanted.states);
    return options;
}

std::string build_text(const casefile::Case& input)
{
    return fmt::format("deadpoint {} case {}", version, casefile::case_hash(input));
}

std::optional<twin::Reduction> reduce_case(ModelParts& parts, const casefile::Case& input, const ReduceOptions& options,
                                           Observer& observer)
{
    Stopwatch watch(observer);
    press::RunResult unused;
    const auto problem = parts.translate(input, watch, unused, observer);
    Mistakes mistakes;
    refuse_tables(input, parts.machine, mistakes);
    refuse_prescribed(problem, mistakes);
    mistakes.raise();
    parts.need_model(input, watch, observer);
    parts.model->release_elasticity();  // all functionals are there

    const auto problems = problems_of(problem, parts, input, options.ranges, observer);
    const auto full =
        parts.model->projector(problems.nominal.problem, parts.adjoints, attribution_of(parts), options.largest_factor);
    if (options.build.certificate)
        full->require_residual();
    const auto build_options = complete(options.build, parts, input);
    const auto mark = fmt::format("{} {} {} sets {} fields", build_text(input), full->mesh(), build_options.sets,
                                  build_options.largest_basis);
    const reduce::BuildCheckpoint kept(options.checkpoint, mark, fem::rank() == 0,
                                       [&](const std::string& text) { observer.warn(text); });
    if (!starts_uniform(problem, parts.machine.parts.size()))
        for (std::size_t p = 0; p < parts.machine.parts.size(); ++p)
            full->add_part(p);
    twin::Reduction result;
    result.small = press_without_terms(parts, input, build_options);
    const double start = input.machine.initial_temperature;
    const auto box = twin::free_coefficients(problems.split, parts.machine, options.ranges, start, problems.others);
    result.small.box = twin::with_heat_of(box, problems.split, problems.others, start);
    auto models = reduce::build(*full, problems.points, box, build_options, kept, observer);
    if (!models)
        return std::nullopt;
    result.large = result.small;
    state_errors(models->small, result.small);
    if (!options.fields_file.empty())
        full->write_fields(options.fields_file, reduce::mark_of(models->small.terms->terms));
    FullRuns runs(parts, build_options, *models, kept, observer);
    if (options.full_runs > 0 && !compare_with_full_runs(runs, problems, box, options, result, observer))
        return std::nullopt;
    give_terms(result.small, std::move(models->small.terms));
    give_terms(result.large, std::move(models->large));
    result.residual = std::move(models->residual);
    return result;
}

}  // namespace deadpoint::full
