#include "deadpoint/machine/cad/read_cad.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/child_process.hpp"
#include "deadpoint/machine/cad/describe_cad.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include "deadpoint/machine/geometry/packed.hpp"
#include <Standard_Failure.hxx>

#include <fmt/format.h>

namespace deadpoint::machine {
namespace {

constexpr double longest_reading = 1800;       // [s]
constexpr double patience_with_overflow = 30;  // with a number beyond all measure [s]

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
    to.put(solid.called);
    to.put(solid.fingerprint);
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
    from.get(solid.called);
    from.get(solid.fingerprint);
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
CadModel read_in_child(const ForeignFile& file, StepLetters letters, std::optional<double> unit)
{
    try {
        return describe_cad(read_step_solids(file, letters, unit));
    } catch (const Standard_Failure& failure) {
        throw InputError(
            fmt::format("part '{}': '{}' cannot be read ({})\n  help: write it again with the program that wrote it",
                        file.part, file.path, failure.GetMessageString()));
    }
}

}  // namespace

CadModel read_cad(const std::string& part, const std::string& path, std::optional<double> unit, const Waiting& waiting)
{
    const StepText text = check_step_file(part, path);
    const ForeignFile file{part, path, "part.step"};
    const ChildLimits limits{half_of_memory(), text.overflow > 0 ? patience_with_overflow : longest_reading, file.path,
                             file.name};
    CadModel model;
    try {
        model = unpacked_model(run_in_child(
            fmt::format("part '{}': reading '{}'", part, path), limits,
            [&] { return packed(read_in_child(file, text.letters, unit)); }, waiting));
    } catch (const TimeLimitError&) {
        if (text.overflow == 0) {
            throw;
        }
        throw InputError(fmt::format("part '{}': '{}', line {}: a number is too large\n  help: export the part again",
                                     part, path, text.overflow));
    } catch (const ForeignError&) {
        throw unreadable(file);
    }
    if (model.solids.empty()) {
        throw InputError(
            fmt::format("part '{}': '{}' holds no solid\n  help: export closed solids, not surfaces", part, path));
    }
    return model;
}

}  // namespace deadpoint::machine
