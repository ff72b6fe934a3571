#include "deadpoint/full/fields/run_fields.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/full/frame/chain_on_mesh.hpp"
#include "deadpoint/full/model/model_parts.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/chain_series.hpp"
#include "deadpoint/press/drift/crank_play.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <algorithm>
#include <utility>

namespace deadpoint::full {
RunFields::RunFields(const casefile::Case& input, ModelParts& parts, press::FieldTimes times,
                     const press::FieldOptions& options)
    : input_(input), parts_(parts), times_(std::move(times)), checkpoints_(options.checkpoints),
      reference_(input.machine.initial_temperature),
      writer_(input, parts.machine, *parts.model, parts.chain_or_none(), parts.frame_or_none(), parts.adjoints,
              options.folder, options.comments)
{}

void RunFields::take(double time, const fem::Field& field, press::RunResult& result)
{
    const bool viewed = std::ranges::binary_search(times_.viewed, time);
    const bool written = std::ranges::binary_search(times_.written, time);
    if (viewed)
        view_.add(time, field);
    if (std::ranges::binary_search(times_.kept, time))
        kept_.emplace_back(time, field);
    if (written)
        writer_.write(time, field, result);
    if (checkpoints_ && (written || !viewed))
        exact_.emplace(time, field);
}

std::vector<fem::HandedField> RunFields::handed_on() const
{
    auto result = view_.kept();
    std::erase_if(result, [&](const fem::HandedField& field) { return exact_.contains(field.time); });
    for (const auto& [time, field] : exact_)
        result.push_back({time, std::span<const double>(field.owned)});
    std::ranges::sort(result, {}, &fem::HandedField::time);
    return result;
}

void RunFields::make_view(press::RunResult& result)
{
    CloseJoints close;
    if (const auto* chain = parts_.chain_or_none()) {
        const auto growths = play_growths(chain->figures(), result.thermal, result.thermal.time.size() - 1);
        close = [&, chain,
                 shares = press::play_shares(press::crank_play(input_), growths)](const fem::Displacement& u) {
            return close_joints(parts_.machine, *parts_.model, *chain, u, shares).motions;
        };  // the shares at the end hold at all times, since the view is linear in the temperature
    }
    result.view = view_.finish(parts_.machine, *parts_.model, reference_, close);
}

}  // namespace deadpoint::full
