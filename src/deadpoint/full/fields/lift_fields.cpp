#include "deadpoint/full/fields/lift_fields.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/reduction/field_file.hpp"
#include "deadpoint/full/fields/run_fields.hpp"
#include "deadpoint/full/frame/frame_state.hpp"
#include "deadpoint/full/model/model_parts.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/frame_courses.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/run/reduced_states.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace deadpoint::full {
namespace {

/// Takes the fields of all states of a run.
void take_all(const twin::ReducedStates& run, const fem::StateFields& of_states, RunFields& fields,
              press::RunResult& result, Observer& observer)
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

void lift_fields(ModelParts& parts, const casefile::Case& input, const std::string& file,
                 const twin::ReducedStates& run, const press::FieldOptions& options, press::RunResult& result,
                 Observer& observer)
{
    Observer silent;  // the run has told of laws and loads already
    Stopwatch told(silent), watch(observer);
    press::RunResult unused;
    const auto problem = parts.translate(input, told, unused, silent);
    parts.need_model(input, watch, observer);
    parts.note_sizes(result);
    watch.start("fields");
    const auto of_states = parts.model->read_fields(file, run.model, run.count);
    RunFields fields(input, parts, press::FieldTimes(problem, true), options);
    take_all(run, of_states, fields, result, observer);
    if (fields.has_view()) {
        watch.start("view");
        fields.make_view(result);
    }
    watch.stop();
    if (result.frame)
        press::warn_about_frame(input, result.thermal, *result.frame, observer);
    parts.note_work(result);
    std::ranges::copy(watch.times(), std::back_inserter(result.timings));
}

}  // namespace deadpoint::full
