#include "deadpoint/study/fields/lift_fields.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/reduction/field_file.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/study/drift/chain_model.hpp"
#include "deadpoint/study/drift/frame_courses.hpp"
#include "deadpoint/study/drift/frame_state.hpp"
#include "deadpoint/study/fields/run_fields.hpp"
#include "deadpoint/study/pipeline/model_parts.hpp"
#include "deadpoint/study/pipeline/stopwatch.hpp"
#include "deadpoint/study/reduce/reduced_states.hpp"
#include "deadpoint/study/result/run_result.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace deadpoint::study {
namespace {

/// Of laws and loads that the run has told already.
void take_all(const ReducedStates& run, const fem::StateFields& of_states, RunFields& fields, RunResult& result,
              Observer& observer)
{
    std::size_t done = 0;
    for (const auto& [time, states] : run.states) {
        if (observer.cancelled())
            return;
        const Eigen::Map<const Eigen::VectorXd> values(states.data(), static_cast<Eigen::Index>(states.size()));
        fields.take(time, of_states.lift(values), result);
        ++done;
        observer.progress(static_cast<double>(done) / static_cast<double>(run.states.size()),
                          fmt::format("{} of {}", done, run.states.size()));
    }
}

}  // namespace

void lift_fields(ModelParts& parts, const casefile::Case& input, const std::string& file, const ReducedStates& run,
                 const FieldOptions& options, RunResult& result, Observer& observer)
{
    Observer silent;
    Stopwatch told(silent), watch(observer);
    RunResult unused;
    const auto problem = parts.translate(input, told, unused, silent);
    parts.need_model(input, watch, observer);
    parts.note_sizes(result);
    watch.start("fields");
    const auto of_states = parts.model->read_fields(file, run.model, run.count);
    RunFields fields(input, parts, FieldTimes(problem, true), options);
    take_all(run, of_states, fields, result, observer);
    if (fields.has_view()) {
        watch.start("view");
        fields.make_view(result);
    }
    watch.stop();
    if (result.frame)
        warn_about_frame(input, result.thermal, *result.frame, observer);
    parts.note_work(result);
    std::ranges::copy(watch.times(), std::back_inserter(result.timings));
}

}  // namespace deadpoint::study
