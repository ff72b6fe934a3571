#include "deadpoint/full/fields/view_recorder.hpp"

#include "deadpoint/exchange/decimated_surface.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/estimate/pod.hpp"
#include "deadpoint/fem/model.hpp"
#include "deadpoint/machine/assembly/decimated_surface.hpp"
#include "deadpoint/press/result/view_data.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace deadpoint::full {
namespace {

std::vector<Vec3> closed_displacement(const DecimatedSurface& surface, const fem::Model& model,
                                      const fem::Displacement& displacement, const CloseJoints& close)
{
    auto moved = model.at_corners(surface.vertices, displacement);
    const auto motions = close(displacement);
    for (std::size_t p = 0; p < surface.parts.size(); ++p) {
        const auto& part = surface.parts[p];
        for (std::size_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v)
            moved[v] = moved[v] + rigid_displacement(motions[p], surface.positions[v]);
    }
    return moved;
}

// Where the deformation does not follow the temperature linearly, the rise that it follows is put behind it: both then
// have the same coefficients.
void put_rise(std::vector<float>& field, fem::Model& model, double reference)
{
    const auto rise = model.expansion_rise({{field.begin(), field.end()}}, reference);
    field.insert(field.end(), rise.owned.begin(), rise.owned.end());
}

// What was put behind a temperature field; if nothing was, the field less `reference`.
fem::Field take_rise(fem::Field& field, const fem::Model& model, double reference)
{
    fem::Field rise;
    if (model.expands_linearly()) {
        for (const double temperature : field.owned)
            rise.owned.push_back(temperature - reference);
        return rise;
    }
    const auto half = field.owned.begin() + static_cast<std::ptrdiff_t>(field.owned.size() / 2);
    rise.owned.assign(half, field.owned.end());
    field.owned.erase(half, field.owned.end());
    return rise;
}

}  // namespace

void ViewRecorder::add(double time, const fem::Field& field)
{
    times_.push_back(time);
    fields_.emplace_back(field.owned.begin(), field.owned.end());
}

std::vector<fem::HandedField> ViewRecorder::kept() const
{
    std::vector<fem::HandedField> result;
    for (std::size_t i = 0; i < times_.size(); ++i)
        result.push_back({times_[i], std::span<const float>(fields_[i])});
    return result;
}

press::ViewData ViewRecorder::finish(const Machine& whole, fem::Model& model, double reference,
                                     const CloseJoints& close)
{
    press::ViewData view;
    if (!model.expands_linearly())
        for (auto& field : fields_)
            put_rise(field, model, reference);
    auto fields = fem::pod(fields_, view_tolerance, view_modes);
    fields_ = {};
    view.time = std::move(times_);
    view.surface = machine::decimated_surface(whole, view_triangles);
    view.reference = reference;
    view.coefficients = std::move(fields.coefficients);
    view.largest_rise = fields.largest_rise;
    view.error = fields.error;
    std::vector<fem::Field> rises{take_rise(fields.base, model, reference)};
    for (auto& mode : fields.modes)
        rises.push_back(take_rise(mode, model, 0.0));
    view.temperature.base = model.at_corners(view.surface.vertices, fields.base);
    for (const auto& mode : fields.modes)
        view.temperature.modes.push_back(model.at_corners(view.surface.vertices, mode));
    if (!close)
        return view;
    // Cases start from a uniform temperature; the fields were stored as floats.
    const bool starts_undeformed =
        std::ranges::all_of(view.temperature.base, [&](double t) { return std::abs(t - reference) < 1e-4; });
    std::size_t deformed = 0;
    while (deformed < fields.modes.size() && fields.residual_energy[deformed] > view_deformation_tolerance)
        ++deformed;
    rises.resize(1 + deformed);
    if (starts_undeformed)
        rises.erase(rises.begin());
    for (const auto& displacement : model.displacements_of_rises(rises))
        view.displacement.modes.push_back(closed_displacement(view.surface, model, displacement, close));
    view.displacement.base.resize(view.surface.vertices.size());
    if (!starts_undeformed) {
        view.displacement.base = std::move(view.displacement.modes.front());
        view.displacement.modes.erase(view.displacement.modes.begin());
    }
    return view;
}

}  // namespace deadpoint::full
