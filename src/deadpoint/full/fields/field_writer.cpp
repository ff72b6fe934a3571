#include "deadpoint/full/fields/field_writer.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/drift/play.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/fem/space/fields.hpp"
#include "deadpoint/full/frame/chain_on_mesh.hpp"
#include "deadpoint/full/frame/frame_state.hpp"
#include "deadpoint/io/vtu.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/chain_series.hpp"
#include "deadpoint/press/drift/crank_play.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace deadpoint::full {
namespace {

std::vector<int> bodies_by_part(const Machine& machine)
{
    std::vector<std::string> names;
    std::vector<int> result;
    for (const auto& part : machine.parts) {
        auto found = std::find(names.begin(), names.end(), part.body);
        if (found == names.end())
            found = names.insert(names.end(), part.body);
        result.push_back(static_cast<int>(found - names.begin()));
    }
    return result;
}

}  // namespace

FieldWriter::FieldWriter(const casefile::Case& input, const Machine& machine, fem::Model& model,
                         const press::ChainModel* chain, const FrameState* frame,
                         const std::vector<fem::Adjoint>& adjoints, std::string folder,
                         std::vector<std::string> comments)
    : input_(input), machine_(machine), model_(model), chain_(chain), frame_(frame), adjoints_(adjoints),
      folder_(std::move(folder)), comments_(std::move(comments)), reference_(input.machine.initial_temperature),
      bodies_(bodies_by_part(machine))
{}

void FieldWriter::write(double time, const fem::Field& field, press::RunResult& result)
{
    std::optional<fem::Displacement> displacement;
    if (chain_ || frame_)
        displacement = model_.displacement(field, reference_);
    std::vector<fem::PointData> data;
    if (frame_)
        data = frame_->add_time(input_, time, field, *displacement, *result.frame);
    if (const auto size = model_.size(); size.deformation_cells != size.cells)
        data.clear();  // they belong to the nodes of the deformation's mesh
    std::vector<RigidMotion> motions(machine_.parts.size());
    if (chain_)
        motions = close(time, field, *displacement, result);
    if (!folder_.empty())
        write_file(time, field, displacement ? &*displacement : nullptr, motions, data, result);
}

std::vector<RigidMotion> FieldWriter::close(double time, const fem::Field& field, const fem::Displacement& displacement,
                                            press::RunResult& result)
{
    const auto growths = play_growths(*chain_, model_, adjoints_, field, reference_);
    const auto shares = press::play_shares(press::crank_play(input_), growths);
    auto closed = close_joints(machine_, model_, *chain_, displacement, shares);
    const double gap = model_.apply(adjoints_[drift::gap], field, reference_) + chain_->play_travel(shares, growths);
    result.adjoint_check = press::AdjointCheck{time, gap, closed.gap, closed.opening};
    return std::move(closed.motions);
}

void FieldWriter::write_file(double time, const fem::Field& field, const fem::Displacement* displacement,
                             const std::vector<RigidMotion>& motions, const std::vector<fem::PointData>& data,
                             press::RunResult& result)
{
    const auto name = fmt::format("fields_{:04d}", result.fields.size());
    result.fields.emplace_back(
        time, model_.write_fields(folder_, name, field, displacement, motions, bodies_, comments_, data));
    std::vector<PvdEntry> entries;
    for (const auto& [at, file] : result.fields)
        entries.push_back({at, file});
    if (fem::rank() == 0)
        write_pvd(folder_ + "/fields.pvd", entries);
}

}  // namespace deadpoint::full
