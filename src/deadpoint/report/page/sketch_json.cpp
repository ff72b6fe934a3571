#include "deadpoint/report/page/sketch_json.hpp"

#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/exchange/decimated_surface.hpp"
#include "deadpoint/exchange/face_points.hpp"
#include "deadpoint/press/check/case_sketch.hpp"
#include "deadpoint/report/mesh/view_file.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;
using casefile::Case;

struct Box {
    Vec3 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
             std::numeric_limits<double>::max()};
    Vec3 high{-low[0], -low[1], -low[2]};

    void add(const Vec3& point)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            low[i] = std::min(low[i], point[i]);
            high[i] = std::max(high[i], point[i]);
        }
    }
    [[nodiscard]] bool empty() const { return low[0] > high[0]; }
};

Json box_json(const Box& box) { return box.empty() ? Json() : Json{box.low, box.high}; }

void add_face(const Machine& machine, std::uint32_t face, Box& box)
{
    const auto& entry = machine.faces[face];
    for (std::size_t i = 0; i < entry.node_count; ++i)
        box.add(machine.nodes[entry.nodes[i]]);
}

/// How heat passes a surface, or what else it is for, in a word.
std::string condition_of(const Case& input, const std::string& name)
{
    const auto& surface = input.surfaces.at(name);
    const auto heats = [&](const auto& entry) { return entry.second.surface == name; };
    if (surface.heat_flux || std::ranges::any_of(input.heat_sources, heats))
        return "heat";
    if (surface.temperature || !surface.temperature_formula.empty())
        return "fixed";
    if (surface.film)
        return "film";
    if (surface.insulated)
        return "insulated";
    if (input.chain && (name == input.chain->slide_surface || name == input.chain->table_surface ||
                        name == input.chain->ground_surface))
        return "chain";
    return "none";
}

/// Collects which marks each face bears. A group is a set of marks that faces have in common; group 0 has none.
class Marks {
public:
    explicit Marks(const Machine& machine) : machine_(machine), of_face_(machine.faces.size()) {}

    Json list = Json::array();

    void add(Json mark, const std::vector<std::uint32_t>& faces)
    {
        Box box;
        for (const auto face : faces) {
            of_face_[face].push_back(static_cast<std::uint16_t>(list.size()));
            add_face(machine_, face, box);
        }
        mark["box"] = box_json(box);
        list.push_back(std::move(mark));
    }
    std::uint16_t group(std::uint32_t face)
    {
        const auto [entry, added] = numbers_.try_emplace(of_face_[face], static_cast<std::uint16_t>(groups_.size()));
        if (added)
            groups_.push_back(of_face_[face]);
        return entry->second;
    }
    [[nodiscard]] Json groups() const { return groups_; }

private:
    const Machine& machine_;
    std::vector<std::vector<std::uint16_t>> of_face_;
    std::vector<std::vector<std::uint16_t>> groups_{{}};
    std::map<std::vector<std::uint16_t>, std::uint16_t> numbers_{{{}, 0}};
};

/// Whole faces that stand for a surface: those of which it takes at least half, or all where there are none such.
std::vector<std::uint32_t> whole_faces(const MeshSurface& surface)
{
    std::vector<std::uint32_t> most, all;
    for (const auto& entry : surface.faces) {
        all.push_back(entry.face);
        if (entry.fraction >= 0.5)
            most.push_back(entry.face);
    }
    return most.empty() ? all : most;
}

Json interface_mark(const InterfaceFaces& interface, std::size_t side)
{
    return {
        {"kind", "interface"}, {"name", interface.name}, {"side", side == 0 ? "a" : "b"}, {"joined", interface.joined}};
}

std::vector<std::uint32_t> faces_of_parts(const Machine& machine, const std::vector<std::string>& patterns)
{
    std::vector<std::uint32_t> faces;
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f) {
        const auto& part = machine.parts[machine.faces[f].part].name;
        if (std::ranges::any_of(patterns, [&](const auto& pattern) { return matches(pattern, part); }))
            faces.push_back(f);
    }
    return faces;
}

Marks marks_of(const Case& input, const press::CaseSketch& sketch)
{
    const auto& machine = *sketch.machine;
    Marks marks(machine);
    for (const auto& interface : sketch.interfaces)
        for (std::size_t side = 0; side < 2; ++side)
            marks.add(interface_mark(interface, side), interface.sides[side]);
    for (const auto& surface : machine.surfaces) {
        const bool exposed = input.surfaces.at(surface.name).select == casefile::Surface::Select::exposed;
        marks.add({{"kind", "surface"},
                   {"name", surface.name},
                   {"condition", condition_of(input, surface.name)},
                   {"exposed", exposed},
                   {"area_m2", surface.area}},
                  whole_faces(surface));
    }
    for (const auto& [name, source] : input.heat_sources)
        if (!source.parts.empty())
            marks.add({{"kind", "heated"}, {"name", name}, {"condition", "heat"}},
                      faces_of_parts(machine, source.parts));
    return marks;
}

void add_groups(const DecimatedSurface& surface, Marks& marks, Json& json)
{
    for (std::size_t p = 0; p < surface.parts.size(); ++p) {
        const auto& part = surface.parts[p];
        std::vector<std::uint16_t> groups;
        for (std::size_t t = part.first_triangle; t < part.first_triangle + part.triangle_count; ++t)
            groups.push_back(marks.group(surface.faces[t]));
        json["parts"][p]["groups"] = packed(groups);
    }
    json["groups"] = marks.groups();
    json["marks"] = std::move(marks.list);
}

Json joint_json(const std::string& name, const casefile::Joint& joint, const press::CaseSketch& sketch)
{
    const bool slide = joint.kind == casefile::Joint::Kind::slide;
    Json json{{"name", name},         {"kind", slide ? "slide" : "revolute"}, {"bodies", joint.bodies},
              {"at_m", joint.centre}, {"direction", joint.direction},         {"driver", joint.driver}};
    Box box;
    for (const auto& interface : sketch.interfaces)
        if (interface.name.starts_with(name + "."))
            for (const auto& side : interface.sides)
                for (const auto face : side)
                    add_face(*sketch.machine, face, box);
    json["box"] = box_json(box);
    Json elements = Json::array();
    for (const auto& element : joint.elements)
        elements.push_back({element.position - element.width / 2, element.position + element.width / 2});
    json["elements_m"] = elements;
    return json;
}

Json sought_json(const press::SoughtFace& sought)
{
    using Kind = SurfaceSelector::Kind;
    const auto& selector = sought.selector;
    Json json{{"path", sought.path}, {"parts", selector.parts}, {"axis", static_cast<int>(selector.axis)}};
    json["kind"] = selector.kind == Kind::cylinder ? "cylinder" : selector.kind == Kind::plane ? "plane" : "other";
    json["centre_m"] = selector.centre;
    json["diameter_m"] = selector.diameter;
    json["position_m"] = selector.normal ? Json() : Json(selector.position);
    json["within_m"] = selector.within ? Json{selector.within->min, selector.within->max} : Json();
    return json;
}

/// Middle of a surface by its area [m]; of a half model on the plane of symmetry.
std::optional<Vec3> middle_of(const Machine& machine, const std::string& name)
{
    const auto surface = std::ranges::find(machine.surfaces, name, &MeshSurface::name);
    if (surface == machine.surfaces.end() || surface->faces.empty())
        return std::nullopt;
    Vec3 sum{};
    double area = 0;
    for (const auto& entry : surface->faces) {
        const auto& face = machine.faces[entry.face];
        const double own = entry.fraction * face_area(machine, face);
        for (std::size_t i = 0; i < face.node_count; ++i)
            sum = sum + (own / face.node_count) * machine.nodes[face.nodes[i]];
        area += own;
    }
    Vec3 middle = (1 / area) * sum;
    if (machine.half_model)
        middle[0] = 0;
    return middle;
}

/// Where the case says that a plane lies, beside the crank; for a surface that is not in the machine.
std::optional<Vec3> stated_place(const Case& input, const std::string& name, const Vec3& crank)
{
    const auto surface = input.surfaces.find(name);
    if (surface == input.surfaces.end() || surface->second.select != casefile::Surface::Select::plane ||
        !surface->second.position || !surface->second.axis)
        return std::nullopt;
    Vec3 place = crank;
    place[static_cast<std::size_t>(*surface->second.axis)] = *surface->second.position;
    return place;
}

/// Places between which the dimensions of the chain are measured.
Json chain_json(const Case& input, const press::CaseSketch& sketch)
{
    Json json = Json::object();
    const auto& chain = *input.chain;
    const auto stroke = casefile::find_stroke_direction(input);
    json["stroke"] = std::holds_alternative<Vec2>(stroke) ? std::get<Vec2>(stroke) : Vec2{0, 1};
    Vec3 centre{};
    if (const auto crank = input.joints.find(chain.crank_joint); crank != input.joints.end()) {
        centre = {crank->second.centre[0], crank->second.centre[1], 0};
        json["crank"] = centre;
    }
    for (const auto& [key, surface] :
         {std::pair{"slide", chain.slide_surface}, {"table", chain.table_surface}, {"ground", chain.ground_surface}}) {
        const auto middle = sketch.machine ? middle_of(*sketch.machine, surface) : std::nullopt;
        if (const auto place = middle ? middle : stated_place(input, surface, centre))
            json[key] = *place;
    }
    return json;
}

Json overlaps_json(const Machine& machine)
{
    Json list = Json::array();
    for (const auto& overlap : machine.overlaps)
        list.push_back(
            {{"parts", {overlap.part_a, overlap.part_b}}, {"at_m", overlap.where}, {"depth_m", overlap.depth}});
    return list;
}

}  // namespace

Json sketch_json(const Case& input, const press::CaseSketch& sketch)
{
    Json json;
    const Machine none;
    const Machine& machine = sketch.machine ? *sketch.machine : none;
    const auto& surface = sketch.surface;
    json = surface_json(machine, surface);
    if (machine.parts.empty())
        json.update({{"groups", Json::array({Json::array()})}, {"marks", Json::array()}});
    else {
        auto marks = marks_of(input, sketch);
        add_groups(surface, marks, json);
    }
    json["directions"] = directions_json(input);
    json["joints"] = Json::array();
    for (const auto& [name, joint] : input.joints)
        json["joints"].push_back(joint_json(name, joint, sketch));
    json["probes"] = Json::array();
    for (const auto& [name, probe] : input.probes)
        json["probes"].push_back({{"name", name}, {"part", probe.part}, {"at_m", probe.position}});
    json["chain"] = input.chain ? chain_json(input, sketch) : Json::object();
    json["sought"] = Json::array();
    for (const auto& sought : sketch.sought)
        json["sought"].push_back(sought_json(sought));
    json["overlaps"] = overlaps_json(machine);
    return json;
}

}  // namespace deadpoint::report
