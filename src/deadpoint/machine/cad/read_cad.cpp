#include "deadpoint/machine/cad/read_cad.hpp"

#include "deadpoint/core/pattern.hpp"
#include "deadpoint/core/suggest.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/child_process.hpp"
#include "deadpoint/machine/cad/describe_cad.hpp"
#include "deadpoint/machine/foreign/packed.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include <Standard_Failure.hxx>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace deadpoint::machine {
namespace {

constexpr double longest_reading = 1800;  // [s]

void put(Packer& to, const CadPlane& plane)
{
    to.put(plane.normal);
    to.put(plane.offset);
    to.put(plane.loops.size());
    for (const auto& loop : plane.loops) {
        to.put(loop);
    }
}

void get(Unpacker& from, CadPlane& plane)
{
    from.get(plane.normal);
    from.get(plane.offset);
    std::size_t count = 0;
    from.get(count);
    plane.loops.resize(count);
    for (auto& loop : plane.loops) {
        from.get(loop);
    }
}

void put(Packer& to, const CadFace& face)
{
    to.put(face.name);
    to.put(face.area);
    to.put(face.form.index());
    if (const auto* plane = std::get_if<CadPlane>(&face.form)) {
        put(to, *plane);
    } else if (const auto* cylinder = std::get_if<CadCylinder>(&face.form)) {
        to.put(*cylinder);
    } else if (const auto* sphere = std::get_if<CadSphere>(&face.form)) {
        to.put(*sphere);
    }
}

void get(Unpacker& from, CadFace& face)
{
    from.get(face.name);
    from.get(face.area);
    std::size_t form = 0;
    from.get(form);
    if (form == 1) {
        get(from, face.form.emplace<CadPlane>());
    } else if (form == 2) {
        from.get(face.form.emplace<CadCylinder>());
    } else if (form == 3) {
        from.get(face.form.emplace<CadSphere>());
    }
}

void put(Packer& to, const CadSolid& solid)
{
    to.put(solid.name);
    to.put(solid.path);
    to.put(solid.colour);
    to.put(solid.volume);
    to.put(solid.bounds);
    to.put(solid.faces.size());
    for (const CadFace& face : solid.faces) {
        put(to, face);
    }
}

void get(Unpacker& from, CadSolid& solid)
{
    from.get(solid.name);
    from.get(solid.path);
    from.get(solid.colour);
    from.get(solid.volume);
    from.get(solid.bounds);
    std::size_t count = 0;
    from.get(count);
    solid.faces.resize(count);
    for (CadFace& face : solid.faces) {
        get(from, face);
    }
}

std::string packed(const CadModel& model)
{
    Packer to;
    to.put(model.unit);
    to.put(model.scale);
    to.put(model.solids.size());
    for (const CadSolid& solid : model.solids) {
        put(to, solid);
    }
    to.put(model.without_solid.size());
    for (const auto& name : model.without_solid) {
        to.put(name);
    }
    return to.take();
}

CadModel unpacked_model(const std::string& bytes)
{
    CadModel model;
    Unpacker from(bytes);
    from.get(model.unit);
    from.get(model.scale);
    std::size_t count = 0;
    from.get(count);
    model.solids.resize(count);
    for (CadSolid& solid : model.solids) {
        get(from, solid);
    }
    from.get(count);
    model.without_solid.resize(count);
    for (auto& name : model.without_solid) {
        from.get(name);
    }
    return model;
}

/// Open CASCADE throws what is no std::exception.
CadModel read_in_child(const ForeignFile& file, std::optional<double> unit)
{
    try {
        return describe_cad(read_step_solids(file, unit));
    } catch (const Standard_Failure& failure) {
        throw InputError(
            fmt::format("part '{}': '{}' cannot be read ({})\n  help: write it again with the program that wrote it",
                        file.part, file.path, failure.GetMessageString()));
    }
}

}  // namespace

CadModel read_cad(const std::string& part, const std::string& path, std::optional<double> unit, const Waiting& waiting)
{
    check_step_file(part, path);
    const ForeignFile file{part, path, "part.step"};
    const ChildLimits limits{half_of_memory(), longest_reading, file.path, file.name};
    CadModel model = unpacked_model(run_in_child(
        fmt::format("part '{}': reading '{}'", part, path), limits, [&] { return packed(read_in_child(file, unit)); },
        waiting));
    if (model.solids.empty()) {
        throw InputError(
            fmt::format("part '{}': '{}' holds no solid\n  help: export closed solids, not surfaces", part, path));
    }
    return model;
}

std::vector<std::string> chosen_solids(const std::string& part, const std::string& path, const std::string& solid,
                                       const std::vector<std::string>& names)
{
    if (solid.empty()) {
        if (names.size() == 1) {
            return names;
        }
        throw InputError(
            fmt::format("part '{}': '{}' holds {} solids: {}\n  help: choose one by solid = \"{}\"; solid = \"*\" "
                        "makes all of them one piece; `deadpoint init --step` writes a part for each",
                        part, path, names.size(), fmt::join(names, ", "), names.front()));
    }
    std::vector<std::string> found;
    for (const auto& name : names) {
        if (matches(solid, name)) {
            found.push_back(name);
        }
    }
    if (found.empty()) {
        const std::string near = closest_name(solid, names);
        throw InputError(fmt::format("part '{}': '{}' holds no solid '{}'; it holds {}{}", part, path, solid,
                                     fmt::join(names, ", "),
                                     near.empty() ? "" : fmt::format("\n  help: did you mean '{}'?", near)));
    }
    return found;
}

}  // namespace deadpoint::machine
