#include "deadpoint/machine/assembly/build.hpp"

#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/machine/assembly/assembly.hpp"
#include "deadpoint/machine/assembly/contacts.hpp"
#include "deadpoint/machine/assembly/inspect.hpp"
#include "deadpoint/machine/assembly/interfaces.hpp"
#include "deadpoint/machine/assembly/limits.hpp"
#include "deadpoint/machine/assembly/measure.hpp"
#include "deadpoint/machine/assembly/overlaps.hpp"
#include "deadpoint/machine/assembly/round.hpp"
#include "deadpoint/machine/assembly/select.hpp"
#include "deadpoint/machine/assembly/sketch.hpp"
#include "deadpoint/machine/cad/survey.hpp"
#include "deadpoint/machine/geometry/polygon.hpp"
#include "deadpoint/machine/geometry/seams.hpp"
#include "deadpoint/machine/parts/cell_limit.hpp"
#include "deadpoint/machine/parts/extrude.hpp"
#include "deadpoint/machine/parts/frame.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include "deadpoint/machine/parts/layers.hpp"
#include "deadpoint/machine/parts/meshed_parts.hpp"
#include "deadpoint/machine/parts/solids.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <numbers>
#include <set>

namespace deadpoint::machine {

namespace {

/// Quality from which no other axis is tried.
constexpr double good_quality = 0.3;

constexpr const char* bad_geometry = "geometry";

std::string path_of(const PartDescription& part) { return "parts." + part.name; }

std::string place(const Vec3& p)
{
    return fmt::format("({:.1f}, {:.1f}, {:.1f}) mm", 1e3 * p[0], 1e3 * p[1], 1e3 * p[2]);
}

void check(const MachineDescription& description)
{
    Mistakes mistakes(bad_geometry);
    std::set<std::string> names;
    for (const PartDescription& part : description.parts) {
        if (part.name.empty()) {
            mistakes.add("parts", "a part has no name; give every part one");
        }
        if (!names.insert(part.name).second) {
            mistakes.add(path_of(part), fmt::format("two parts are called '{}'; rename one", part.name));
        }
        if (!(part.size >= 0) || !(part.density >= 0)) {
            mistakes.add(path_of(part), "cell size and density must not be negative");
        }
    }
    if (description.parts.empty()) {
        mistakes.add("parts", "the machine has no parts; describe at least one");
    }
    if (!(description.size > 0) || !(description.size_scale > 0)) {
        mistakes.add("numerics.size", "the cell size and its scale must be positive");
    }
    if (!(description.seam_tolerance > 0)) {
        mistakes.add("numerics.seam_tolerance", "the seam tolerance must be positive");
    }
    mistakes.raise();
}

/// The hexahedral mesh with the better worst cell over all axes that fit; empty kind of reason if there is none.
struct HexahedronAttempt {
    bool done = false;
    PartMesh mesh;
    std::string reason;
};

HexahedronAttempt try_hexahedra(const std::string& name, const std::vector<Prism>& prisms, const Frame& frame,
                                double size, bool half)
{
    HexahedronAttempt best;
    best.reason = "its shapes have no axis in common";
    double best_quality = poor_quality;
    for (const Axis axis : common_axes(prisms)) {
        const LayeredPart layered = layered_along(prisms, axis, half);
        try {
            const PlaneMesh plane = only_boxes(layered) ? grid_plane(layered, size) : mesh_plane(name, layered, size);
            PartMesh mesh = extrude(layered, plane, size);
            const Worst worst = worst_cell(mesh);
            if (worst.quality >= best_quality) {
                best_quality = worst.quality;
                best = {true, std::move(mesh), {}};
            } else if (!best.done) {
                best.reason = fmt::format("hexahedra would have a scaled Jacobian of {:.3f} at {}", worst.quality,
                                          place(to_machine(frame, worst.where)));
            }
        } catch (const InputError& error) {
            if (!best.done) {
                best.reason = error.what();
            }
        }
        if (best_quality >= good_quality) {
            break;
        }
    }
    return best;
}

/// What helps against bad cells, by what the part is made from.
std::string against_bad_cells(const PartDescription& part)
{
    if (std::holds_alternative<MeshSource>(part.source)) {
        return "mesh it again";
    }
    if (std::holds_alternative<StepSource>(part.source)) {
        return "choose another `size` or `smallest_cell`, or leave more out by `omit`";
    }
    return "choose another cell size for this part, set tetrahedra = true, or correct outlines that nearly touch there";
}

/// The face of a part that is nearest to a place: by its name, or by its form.
std::string nearest_face(const PartMesh& mesh, const Vec3& where)
{
    const auto away = [&](const Face& face) { return norm(centre(face, mesh.nodes) - where); };
    const auto nearest = std::ranges::min_element(mesh.faces, {}, away);
    const auto index = static_cast<std::uint32_t>(nearest - mesh.faces.begin());
    for (const FaceGroup& group : mesh.groups) {
        if (std::ranges::find(group.faces, index) != group.faces.end()) {
            return fmt::format("face '{}'", group.name);
        }
    }
    return describe(mesh.geometries[nearest->geometry]);
}

/// One rule for all parts. @throws InputError
void check_quality(const PartDescription& part, const PartMesh& mesh, Observer& observer)
{
    const Worst worst = worst_cell(mesh);
    if (worst.quality < least_quality) {
        throw InputError(
            fmt::format("part '{}' has inverted or flat cells: the worst, at {} by its {}, has quality {:.2g}, but "
                        "{} is needed; {}",
                        part.name, place(worst.where), nearest_face(mesh, worst.where), worst.quality, least_quality,
                        against_bad_cells(part)));
    }
    if (worst.quality < poor_quality) {
        observer.warn(
            fmt::format("part '{}': its worst cell, at {} by its {}, has quality {:.3f}, which is poor below {}; {} if "
                        "temperatures there matter",
                        part.name, place(worst.where), nearest_face(mesh, worst.where), worst.quality, poor_quality,
                        against_bad_cells(part)));
    }
}

/// Meshes the shapes in a frame of their own. @param towards  see frame_of()
PartMesh mesh_shapes(const PartDescription& part, const std::vector<Prism>& prisms, const Vec3& towards, double size,
                     bool half, Observer& observer)
{
    const Frame frame = frame_of(prisms, towards, half);
    std::vector<Prism> seen;
    for (const Prism& prism : prisms) {
        seen.push_back(to_local(frame, prism));
    }
    if (!part.tetrahedra) {
        HexahedronAttempt attempt = try_hexahedra(part.name, seen, frame, size, half);
        if (attempt.done) {
            return to_machine(frame, std::move(attempt.mesh));
        }
        observer.info(fmt::format("part '{}' gets tetrahedra: {}", part.name, attempt.reason));
    }
    return to_machine(frame, mesh_tetrahedra(part.name, seen, size, half, observer));
}

bool beyond_symmetry(const std::vector<Prism>& prisms)
{
    const auto beyond = [](const Prism& prism) {
        if (prism.operation != Shape::Operation::add) {
            return true;
        }
        const Prism flat = along(prism, prism.box ? Axis::z : prism.axis);
        if (flat.axis == Axis::x) {
            return flat.from > -1e-9;
        }
        if (flat.section.circle) {
            return flat.section.circle->centre[0] - flat.section.circle->radius > -1e-9;
        }
        return std::all_of(flat.section.points.begin(), flat.section.points.end(),
                           [](const Vec2& point) { return point[0] > -1e-9; });
    };
    return std::all_of(prisms.begin(), prisms.end(), beyond);
}

double section_area(const Prism& prism)
{
    if (const auto& circle = prism.section.circle) {
        return std::numbers::pi *
               (circle->radius * circle->radius - prism.section.bore_radius * prism.section.bore_radius);
    }
    double area = std::abs(signed_area(prism.section.points));
    for (const auto& hole : prism.section.holes) {
        area -= std::abs(signed_area(hole));
    }
    return area;
}

/// [m3], without what is cut away.
double volume_of(const std::vector<Prism>& prisms)
{
    double volume = 0;
    for (const Prism& shape : prisms) {
        if (shape.operation == Shape::Operation::add) {
            const Vec3 edges = shape.max - shape.min;
            volume += shape.box ? edges[0] * edges[1] * edges[2] : section_area(shape) * (shape.to - shape.from);
        }
    }
    return volume;
}

std::vector<Prism> joined_prisms(const MachineDescription& description, const PartDescription& part, Observer& observer)
{
    const auto* shapes = std::get_if<std::vector<Shape>>(&part.source);
    if (shapes == nullptr) {
        return {};
    }
    Healed joined =
        healed(part.name, prisms_of(part.name, *shapes), description.seam_tolerance, description.half_model);
    constexpr double worth_a_word = 1e-9;
    constexpr double worth_a_warning = 1e-5;
    if (joined.moved > worth_a_word) {
        const auto text = fmt::format(
            "part '{}': surfaces of its shapes that nearly meet were joined; the largest move is {:.3g} um, near {}",
            part.name, micrometre * joined.moved, place(joined.where));
        joined.moved > worth_a_warning ? observer.warn(text) : observer.info(text);
    }
    return std::move(joined.prisms);
}

/// @param prisms   of the part; none where it is imported
/// @param machine  the box around all shapes
PartMesh mesh_part(const MachineDescription& description, const PartDescription& part, const std::vector<Prism>& prisms,
                   const BoxShape& machine, Observer& observer, const Waiting& waiting)
{
    const double size = in_frame((part.size > 0 ? part.size : description.size) * description.size_scale);
    const bool half = description.half_model;
    if (const auto* step = std::get_if<StepSource>(&part.source)) {
        return mesh_step(part, *step, size, half, waiting);
    }
    if (half && beyond_symmetry(prisms)) {
        return {};
    }
    check_cell_count(part.name, about_hexahedra(volume_of(prisms), size), size, observer);
    const Vec3 towards = middle(machine) - middle(bounds_of(prisms));
    PartMesh mesh = mesh_shapes(part, prisms, towards, size, half, observer);
    if (mesh.cells.empty()) {
        throw InputError(fmt::format("part '{}' has no material left after its cuts; correct its shapes", part.name));
    }
    return mesh;
}

void make_round(Machine& machine, const PartDescription& part, Observer& observer)
{
    if (!part.second_order) {
        return;
    }
    if (const std::size_t straight = add_round_edges(machine, part.density); straight > 0) {
        observer.info(fmt::format("part '{}': {} cells are too thin for round edges and keep straight ones; make its "
                                  "cells smaller along the circumference",
                                  part.name, straight));
    }
}

void add_part(Assembly& assembly, const PartDescription& part, PartMesh mesh, Observer& observer)
{
    if (mesh.cells.empty()) {
        assembly.machine.dropped_parts.push_back(part.name);
        return;
    }
    check_quality(part, mesh, observer);
    append(assembly, part, std::move(mesh));
    make_round(assembly.machine, part, observer);
}

/// What was found so far, without throwing it.
std::vector<Diagnostic> found_in(const Mistakes& mistakes)
{
    try {
        mistakes.raise();
    } catch (const CaseError& error) {
        return error.diagnostics();
    } catch (const CaseDomainError& error) {
        return error.diagnostics();
    }
    return {};
}

/// The stages of a build share its mistakes. A build raises them at the end of each stage; a sketch goes on without the
/// parts at fault.
class Stages {
public:
    enum class At { raise, go_on };
    explicit Stages(At at) : at_(at) {}

    Mistakes mistakes{bad_geometry};

    void end() const
    {
        if (at_ == At::raise) {
            mistakes.raise();
        }
    }
    /// As Mistakes::attempt(). To a sketch, a file that cannot be read is a mistake too.
    void attempt(const std::string& path, const std::function<void()>& action)
    {
        try {
            mistakes.attempt(path, action);
        } catch (const IoError& error) {
            if (at_ == At::raise) {
                throw;
            }
            mistakes.add(path, error);
        }
    }
    [[nodiscard]] bool goes_on() const { return at_ == At::go_on; }
    [[nodiscard]] bool is_sound(const PartDescription& part) const
    {
        const auto found = found_in(mistakes);
        const auto path = path_of(part) + ".";
        return std::ranges::none_of(found, [&](const Diagnostic& d) { return (d.path + ".").starts_with(path); });
    }

private:
    At at_;
};

/// By the index of the part; empty where the shapes are at fault.
std::vector<std::vector<Prism>> drawn_parts(const MachineDescription& description, Stages& stages, Observer& observer)
{
    std::vector<std::vector<Prism>> drawn(description.parts.size());
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const PartDescription& part = description.parts[i];
        stages.attempt(path_of(part), [&] { drawn[i] = joined_prisms(description, part, observer); });
    }
    stages.end();
    return drawn;
}

BoxShape bounds_of_all(const std::vector<std::vector<Prism>>& drawn)
{
    std::vector<Prism> all;
    for (const auto& prisms : drawn) {
        all.insert(all.end(), prisms.begin(), prisms.end());
    }
    return bounds_of(all);
}

/// Mesh files state no unit. A part of their lengths in metres that no press has is refused or questioned.
void question_size(const PartDescription& part, const MeshSource& file, const PartMesh& mesh, Observer& observer)
{
    constexpr double too_long = 100, very_long = 20, very_short = 1e-3;  // [m]
    if (mesh.nodes.empty()) {
        return;
    }
    BoxShape box{mesh.nodes.front(), mesh.nodes.front()};
    for (const Vec3& node : mesh.nodes) {
        for (std::size_t i = 0; i < 3; ++i) {
            box.min[i] = std::min(box.min[i], node[i]);
            box.max[i] = std::max(box.max[i], node[i]);
        }
    }
    const Vec3 edges = box.max - box.min;
    const double length = std::max({edges[0], edges[1], edges[2]});
    const std::string help =
        fmt::format("one unit of the file counts as {:.4g} mm; for a file in millimetres state unit = "
                    "\"1 mm\"",
                    1e3 * file.unit);
    if (length > too_long) {
        throw InputError(fmt::format("part '{}' is {:.0f} m long\n  help: {}", part.name, length, help));
    }
    if (length > very_long || length < very_short) {
        observer.warn(fmt::format("part '{}' is {:.4g} mm long\n  help: {}", part.name, 1e3 * length, help));
    }
}

/// Meshes of files, which are quick to read, and a look at all drawings: what is wrong there is said before anything is
/// meshed.
std::vector<PartMesh> read_mesh_files(const MachineDescription& description, Stages& stages, Observer& observer)
{
    std::vector<PartMesh> meshes(description.parts.size());
    for (std::size_t i = 0; i < description.parts.size(); ++i) {
        const PartDescription& part = description.parts[i];
        if (const auto* file = std::get_if<MeshSource>(&part.source)) {
            stages.attempt(path_of(part), [&] {
                meshes[i] = read_mesh(part, *file, description.half_model, {});
                question_size(part, *file, meshes[i], observer);
            });
            if (description.size_scale != 1) {
                observer.warn(
                    fmt::format("part '{}' keeps the cells of its mesh file: --size does not change them", part.name));
            }
        }
    }
    stages.attempt("parts", [&] { survey_drawings(description, stages.mistakes, observer); });
    stages.end();
    return meshes;
}

/// The shapes of the parts of the assembly.
std::vector<std::vector<Prism>> mesh_parts(const MachineDescription& description, Assembly& assembly, Stages& stages,
                                           Observer& observer, MeshedParts* kept)
{
    const GmshSession session;
    std::vector<std::vector<Prism>> drawn = drawn_parts(description, stages, observer);
    std::vector<PartMesh> files = read_mesh_files(description, stages, observer);
    const BoxShape bounds = bounds_of_all(drawn);
    std::vector<std::vector<Prism>> shapes;
    for (std::size_t i = 0; i < description.parts.size(); ++i) {
        const PartDescription& part = description.parts[i];
        if (!stages.is_sound(part)) {
            continue;
        }
        const double done = static_cast<double>(i) / static_cast<double>(description.parts.size());
        observer.progress(done, part.name);
        const Waiting waiting = [&](double seconds) {
            constexpr double long_time = 15;
            observer.progress(
                done, fmt::format("{}, for {:.0f} s{}", part.name, seconds,
                                  seconds > long_time ? "; a larger `size`, or omit = \"0 mm\", is faster" : ""));
        };
        stages.attempt(path_of(part), [&] {
            const auto make = [&] {
                return std::holds_alternative<MeshSource>(part.source)
                           ? std::move(files[i])
                           : mesh_part(description, part, drawn[i], bounds, observer, waiting);
            };
            PartMesh mesh = kept != nullptr ? kept->once(part.name, make) : make();
            for (const auto& note : mesh.notes) {
                observer.info(fmt::format("part '{}': {}", part.name, note));
            }
            add_part(assembly, part, std::move(mesh), observer);
        });
        if (assembly.machine.parts.size() > shapes.size()) {
            shapes.push_back(std::move(drawn[i]));
        }
    }
    observer.progress(1, "parts meshed");
    if (assembly.machine.parts.empty() && found_in(stages.mistakes).empty()) {
        throw mistake("machine.half_model",
                      "every part lies at x > 0, but a half model keeps x <= 0; mirror the machine or build it whole");
    }
    return shapes;
}

std::vector<double> exposed_fractions(const Machine& machine, const std::vector<double>& covered)
{
    constexpr double noise = 1e-9;
    std::vector<double> result(covered.size());
    for (std::size_t i = 0; i < covered.size(); ++i) {
        const double open = 1 - covered[i];
        result[i] = open < noise ? 0.0 : (open > 1 - noise ? 1.0 : open);
        if (machine.faces[i].symmetry) {
            result[i] = 0;
        }
    }
    return result;
}

void find_floating(Machine& machine)
{
    std::vector<char> tied(machine.parts.size(), 0);
    for (const auto* contacts : {&machine.interfaces, &machine.bonds}) {
        for (const Contact& contact : *contacts) {
            tied[contact.part_a] = tied[contact.part_b] = 1;
        }
    }
    for (std::size_t i = 0; i < machine.parts.size(); ++i) {
        if (tied[i] == 0 && machine.parts.size() > 1) {
            machine.floating_parts.push_back(machine.parts[i].name);
        }
    }
}

void connect(const MachineDescription& description, Assembly& assembly, Mistakes& mistakes)
{
    Machine& machine = assembly.machine;
    std::vector<double> covered(machine.faces.size(), 0.0);
    machine.interfaces = find_interfaces(assembly, description.interfaces, covered, mistakes);
    std::vector<std::array<std::uint32_t, 2>> joined;
    for (const Contact& contact : machine.interfaces) {
        joined.push_back({std::min(contact.part_a, contact.part_b), std::max(contact.part_a, contact.part_b)});
    }
    machine.bonds = find_bonds(assembly, description, joined, covered, mistakes);
    const std::vector<Contact> conducting = conducting_bonds(machine.bonds, description);
    machine.interfaces.insert(machine.interfaces.end(), conducting.begin(), conducting.end());
    machine.exposed_fraction = exposed_fractions(machine, covered);
    for (std::size_t i = 0; i < machine.faces.size(); ++i) {
        const Face& face = machine.faces[i];
        machine.parts[face.part].exposed_area += machine.exposed_fraction[i] * area(machine, face);
    }
}

void select_surfaces(const MachineDescription& description, Assembly& assembly, Mistakes& mistakes)
{
    for (const SurfaceDescription& surface : description.surfaces) {
        mistakes.attempt("surfaces." + surface.name,
                         [&] { assembly.machine.surfaces.push_back(select_surface(assembly, surface)); });
    }
}

// The result contains overlaps and floating parts, for the printed plan.
void warn_about(const Machine& machine, Observer& observer)
{
    for (const Contact& contact : machine.interfaces) {
        if (!contact.perfect || contact.least_coverage() >= least_coverage) {
            continue;
        }
        if (contact.stroke == 0) {
            observer.info(
                fmt::format("interface '{}': {:.1f} % of side a touch side b", contact.name, 100 * contact.coverage()));
            continue;
        }
        const std::string text = fmt::format(
            "interface '{}': over its stroke of {:.1f} mm the sides slide off each other; at the far end "
            "{:.1f} % of side a touch side b, {:.1f} % in the mean over time",
            contact.name, 1e3 * contact.stroke, 100 * contact.least_coverage(), 100 * contact.area / contact.area_a);
        if (contact.least_coverage() < least_guided) {
            observer.warn(text + "; check the direction of travel and the length of the guide");
        } else {
            observer.info(text);
        }
    }
    for (const MeshSurface& surface : machine.surfaces) {
        if (surface.faces.empty()) {
            observer.warn(fmt::format("surface '{}' is empty: it has no exposed faces", surface.name));
        }
    }
}

Assembly begun(const MachineDescription& description)
{
    Assembly assembly;
    assembly.second_order = std::ranges::any_of(description.parts, &PartDescription::second_order);
    assembly.machine.half_model = description.half_model;
    return assembly;
}

/// Names of parts that could not be meshed.
std::vector<std::string> lost_parts(const MachineDescription& description, const Machine& machine)
{
    std::vector<std::string> lost;
    for (const PartDescription& part : description.parts) {
        if (std::ranges::find(machine.parts, part.name, &MeshPart::name) == machine.parts.end() &&
            std::ranges::find(machine.dropped_parts, part.name) == machine.dropped_parts.end()) {
            lost.push_back(part.name);
        }
    }
    return lost;
}

/// The description without what needs these parts: the rest of the machine is checked all the same.
MachineDescription without(const std::vector<std::string>& lost, MachineDescription description)
{
    const auto needed = [&](const std::vector<std::string>& patterns) {
        return std::ranges::any_of(lost, [&](const std::string& part) {
            return patterns.empty() ||
                   std::ranges::any_of(patterns, [&](const auto& pattern) { return matches(pattern, part); });
        });
    };
    std::erase_if(description.surfaces, [&](const auto& surface) { return needed(surface.selector.parts); });
    std::erase_if(description.interfaces,
                  [&](const auto& interface) { return needed(interface.a.parts) || needed(interface.b.parts); });
    description.bonds.clear();
    return description;
}

void build(const MachineDescription& description, Assembly& assembly, Stages& stages, Observer& observer,
           MeshedParts* kept)
{
    check(description);
    observer.stage("mesh");
    const std::vector<std::vector<Prism>> shapes = mesh_parts(description, assembly, stages, observer, kept);
    stages.attempt("parts", [&] { inspect(assembly, description.seam_tolerance, observer); });
    const auto lost = lost_parts(description, assembly.machine);
    if (lost.empty()) {
        stages.end();
    }
    const MachineDescription rest = lost.empty() || stages.goes_on() ? description : without(lost, description);
    connect(rest, assembly, stages.mistakes);
    select_surfaces(rest, assembly, stages.mistakes);
    stages.end();
    assembly.machine.overlaps = find_overlaps(assembly, shapes);
    find_floating(assembly.machine);
    measure(assembly.machine);
}

InterfaceFaces selected(const Assembly& assembly, const InterfaceDescription& description)
{
    InterfaceFaces faces;
    faces.name = description.name;
    const std::array<const SurfaceSelector*, 2> selectors{&description.a, &description.b};
    for (std::size_t side = 0; side < 2; ++side) {
        Mistakes said_before;
        said_before.attempt(description.name,
                            [&] { faces.sides[side] = selected_faces(assembly, *selectors[side], description.name); });
    }
    return faces;
}

std::vector<InterfaceFaces> faces_of_all(const MachineDescription& description, const Assembly& assembly)
{
    const auto& joined = assembly.machine.interfaces;
    std::vector<InterfaceFaces> result;
    for (const auto& interface : description.interfaces) {
        const auto contact = std::ranges::find(joined, interface.name, &Contact::name);
        result.push_back(contact != joined.end() ? faces_of(*contact) : selected(assembly, interface));
    }
    return result;
}

}  // namespace

Machine build_machine(const MachineDescription& description, Observer& observer, MeshedParts* kept)
{
    Assembly assembly = begun(description);
    Stages stages(Stages::At::raise);
    build(description, assembly, stages, observer, kept);
    warn_about(assembly.machine, observer);
    return std::move(assembly.machine);
}

InterfaceFaces faces_of(const Contact& contact)
{
    InterfaceFaces faces;
    faces.name = contact.name;
    faces.joined = true;
    std::set<std::uint32_t> a, b;
    for (const ContactPoint& point : contact.points_as_drawn()) {
        a.insert(point.face_a);
        b.insert(point.face_b);
    }
    faces.sides[0].assign(a.begin(), a.end());
    faces.sides[1].assign(b.begin(), b.end());
    return faces;
}

Sketch sketch_machine(const MachineDescription& description, Observer& observer, MeshedParts* kept)
{
    Assembly assembly = begun(description);
    Stages stages(Stages::At::go_on);
    stages.attempt("parts", [&] { build(description, assembly, stages, observer, kept); });
    Sketch sketch;
    sketch.missing = found_in(stages.mistakes);
    sketch.interfaces = faces_of_all(description, assembly);
    sketch.machine = std::move(assembly.machine);
    return sketch;
}

}  // namespace deadpoint::machine
