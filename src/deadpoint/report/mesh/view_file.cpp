#include "deadpoint/report/mesh/view_file.hpp"

#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/crankshaft/modes.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/decimated_surface.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/view_data.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> flat(const std::vector<Vec3>& vectors)
{
    std::vector<double> result;
    result.reserve(3 * vectors.size());
    for (const auto& v : vectors)
        result.insert(result.end(), v.begin(), v.end());
    return result;
}
const std::vector<double>& flat(const std::vector<double>& values) { return values; }

Json array_json(std::span<const double> values)
{
    const auto q = quantise(values);
    return {{"low", q.low}, {"step", q.step}, {"data", packed(q.numbers)}};
}

template <class Value>
Json modal_json(const press::ModalField<Value>& field)
{
    Json json;
    json["base"] = array_json(flat(field.base));
    json["modes"] = Json::array();
    for (const auto& mode : field.modes)
        json["modes"].push_back(array_json(flat(mode)));
    return json;
}

// Triangles of a part, by vertices counted from its first; a part of more than 65 536 vertices cannot be: the whole
// surface has fewer.
std::string packed_triangles(const DecimatedSurface& surface, const LightPart& part)
{
    std::vector<std::uint16_t> numbers;
    for (std::size_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
        for (const auto v : surface.triangles[t])
            numbers.push_back(static_cast<std::uint16_t>(v - part.first_vertex));
    return packed(numbers);
}

Json parts_json(const Machine& machine, const DecimatedSurface& surface)
{
    Json list = Json::array();
    for (std::size_t p = 0; p < machine.parts.size(); ++p) {
        const auto& light = surface.parts[p];
        list.push_back({{"name", machine.parts[p].name},
                        {"body", machine.parts[p].body},
                        {"first_vertex", light.first_vertex},
                        {"vertices", light.vertex_count},
                        {"triangles", light.triangle_count},
                        {"symmetry_triangles", light.symmetry_triangles},
                        {"data", packed_triangles(surface, light)}});
    }
    return list;
}

std::vector<std::size_t> spread(std::size_t count, std::size_t at_most)
{
    std::vector<std::size_t> chosen;
    const std::size_t wanted = std::min(count, at_most);
    for (std::size_t i = 0; i < wanted; ++i)
        chosen.push_back(i * count / wanted);
    return chosen;
}

}  // namespace

Quantised quantise(std::span<const double> values)
{
    Quantised result;
    if (values.empty())
        return result;
    if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); }))
        throw DomainError("a field for the report holds a value that is not finite");
    const auto [low, high] = std::ranges::minmax(values);
    constexpr double most = 65535;
    result.low = low;
    result.step = (high - low) / most;
    result.numbers.reserve(values.size());
    for (const double v : values)
        result.numbers.push_back(
            result.step > 0 ? static_cast<std::uint16_t>(std::clamp(std::round((v - low) / result.step), 0.0, most))
                            : std::uint16_t{0});
    return result;
}

std::string packed(std::span<const std::uint16_t> numbers)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(2 * numbers.size());
    for (const auto n : numbers) {
        bytes.push_back(static_cast<std::uint8_t>(n & 0xff));
        bytes.push_back(static_cast<std::uint8_t>(n >> 8));
    }
    return base64(bytes);
}

std::string base64(std::span<const std::uint8_t> bytes)
{
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = (group << 8) | (k < count ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k <= count ? letters[(group >> (18 - 6 * k)) & 63] : '=';
    }
    return text;
}

Json surface_json(const Machine& machine, const DecimatedSurface& surface)
{
    return {{"half_model", machine.half_model},
            {"merged_within_m", surface.grid},
            {"vertices", surface.vertices.size()},
            {"positions_m", array_json(flat(surface.positions))},
            {"parts", parts_json(machine, surface)}};
}

Json directions_json(const casefile::Case& input)
{
    const auto found = casefile::find_viewer(input);
    const auto* viewer = std::get_if<Viewer>(&found);
    const auto shown = viewer != nullptr ? *viewer : Viewer();
    return {{"front", shown.front}, {"left", shown.left}, {"up", shown.up}};
}

Json view_json(const casefile::Case& input, const Machine& machine, const press::ViewData& view)
{
    const auto& surface = view.surface;
    Json json;
    json["version"] = version;
    json["case"] = {{"name", input.machine.name}, {"hash", casefile::case_hash(input)}};
    json["initial_temperature_K"] = view.reference;
    json["largest_rise_K"] = view.largest_rise;
    json["error_of_modes_K"] = view.error;
    json["time_s"] = view.time;
    json["coefficients"] = view.coefficients;
    json["temperature_K"] = modal_json(view.temperature);
    if (!view.displacement.base.empty())
        json["displacement_m"] = modal_json(view.displacement);
    json.update(surface_json(machine, surface));
    json["directions"] = directions_json(input);
    json["probes"] = Json::array();
    for (const auto& [name, probe] : input.probes)
        json["probes"].push_back(
            {{"name", name}, {"part", probe.part}, {"position_m", probe.position}, {"note", probe.note}});
    return json;
}

Json motion_json(const press::LoadsResult& loads)
{
    const auto& history = loads.history;
    const auto chosen = spread(history.angle.size(), 120);
    Json json;
    json["version"] = version;
    json["past_bottom_deg"] = Json::array();
    json["slide_height_m"] = Json::array();
    for (const auto i : chosen) {
        json["past_bottom_deg"].push_back((history.angle[i] - history.angle.front()) * 180 / std::numbers::pi);
        json["slide_height_m"].push_back(history.height[i]);
    }
    json["bodies"] = Json::array();
    for (std::size_t b = 0; b < loads.linkage.bodies.size(); ++b) {
        Json body{{"name", loads.linkage.bodies[b]},
                  {"ground", static_cast<int>(b) == loads.linkage.ground},
                  {"slide", static_cast<int>(b) == loads.linkage.slide_body},
                  {"poses", Json::array()}};
        for (const auto i : chosen) {
            const auto& pose = history.bodies[b].pose[i];
            body["poses"].push_back({pose.translation[0], pose.translation[1], pose.angle});
        }
        json["bodies"].push_back(body);
    }
    json["joints"] = Json::array();
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j) {
        const auto& joint = loads.linkage.joints[j];
        const bool slide = joint.kind == LinkageJoint::Kind::slide;
        Json entry{{"name", joint.name},
                   {"kind", slide ? "slide" : "revolute"},
                   {"body_a", joint.body_a},
                   {"body_b", joint.body_b},
                   {"places", Json::array()}};
        if (slide)
            entry["direction"] = joint.direction;
        for (const auto i : chosen)
            entry["places"].push_back(history.joints[j].centre[i]);
        json["joints"].push_back(entry);
    }
    return json;
}

}  // namespace deadpoint::report
