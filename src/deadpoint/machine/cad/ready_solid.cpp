#include "deadpoint/machine/cad/ready_solid.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/child_process.hpp"
#include "deadpoint/machine/cad/defeature.hpp"
#include "deadpoint/machine/cad/identity.hpp"
#include "deadpoint/machine/cad/step_solids.hpp"
#include "deadpoint/machine/geometry/packed.hpp"
#include "deadpoint/machine/parts/gmsh_mesh.hpp"
#include "deadpoint/machine/parts/gmsh_session.hpp"
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BinTools.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <fmt/format.h>
#include <sstream>

namespace deadpoint::machine {
namespace {

constexpr double longest_preparation = 1800;  // [s]
constexpr double patience = 60;               // for leaving features out [s]

/// Follows named faces through a change of the shape.
template <class Builder>
void follow(StepSolid& solid, Builder& work)
{
    std::vector<NamedFace> named;
    for (const NamedFace& one : solid.named_faces) {
        if (work.IsDeleted(one.face)) {
            continue;
        }
        const auto& images = work.Modified(one.face);
        if (images.IsEmpty()) {
            named.push_back(one);
        }
        for (const TopoDS_Shape& image : images) {
            named.push_back({TopoDS::Face(image), one.name});
        }
    }
    solid.named_faces = std::move(named);
    solid.shape = work.Shape();
}

/// The chosen solids as one.
StepSolid chosen(const ForeignFile& file, const StepSource& source, const StepContents& contents)
{
    if (contents.solids.empty()) {
        throw InputError(
            fmt::format("part '{}': '{}' holds no solid\n  help: export a closed solid", file.part, file.path));
    }
    std::vector<SolidIdentity> solids;
    for (const StepSolid& solid : contents.solids) {
        solids.push_back({solid.called, solid.name, fingerprint_of(solid.shape, contents.scale)});
    }
    StepSolid result;
    for (const std::size_t i : chosen_solids(file.part, source, solids).solids) {
        const StepSolid& next = contents.solids[i];
        result.named_faces.insert(result.named_faces.end(), next.named_faces.begin(), next.named_faces.end());
        if (result.shape.IsNull()) {
            result.shape = next.shape;
        } else {
            BRepAlgoAPI_Fuse sum(result.shape, next.shape);
            follow(result, sum);
        }
    }
    return result;
}

/// Turns a shape so that the directions of the file that the user names become those of the machine.
void rotate(StepSolid& solid, const std::array<Vec3, 3>& axes)
{
    gp_Trsf rotation;
    rotation.SetValues(axes[0][0], axes[0][1], axes[0][2], 0, axes[1][0], axes[1][1], axes[1][2], 0, axes[2][0],
                       axes[2][1], axes[2][2], 0);
    BRepBuilderAPI_Transform work(solid.shape, rotation, true);
    for (NamedFace& named : solid.named_faces) {
        named.face = TopoDS::Face(work.ModifiedShape(named.face));
    }
    solid.shape = work.Shape();
}

/// Keeps what lies below a place along x [mm].
void cut_beyond(StepSolid& solid, double x)
{
    constexpr double far_away = 1e6;
    BRepPrimAPI_MakeBox beyond(gp_Pnt(x, -far_away, -far_away), gp_Pnt(x + far_away, far_away, far_away));
    BRepAlgoAPI_Cut work(solid.shape, beyond.Shape());
    follow(solid, work);
}

StepSolid prepared(const ForeignFile& file, const StepSource& source, const SolidRules& rules,
                   std::vector<std::string>& notes)
{
    StepSolid solid = chosen(file, source, read_step_solids(file, rules.letters, source.unit));
    rotate(solid, source.axes);
    if (rules.omit > 0) {
        notes = defeature(solid, rules.omit / gmsh_unit);
    }
    if (rules.half) {
        cut_beyond(solid, -rules.position / gmsh_unit);
    }
    return solid;
}

TopTools_IndexedMapOfShape indexed_faces_of(const TopoDS_Shape& shape)
{
    TopTools_IndexedMapOfShape faces;
    TopExp::MapShapes(shape, TopAbs_FACE, faces);
    return faces;
}

std::string packed(const StepSolid& solid, const std::vector<std::string>& notes)
{
    std::ostringstream shape;
    BinTools::Write(solid.shape, shape);
    Packer to;
    to.put(shape.str());
    const auto faces = indexed_faces_of(solid.shape);
    to.put(solid.named_faces.size());
    for (const NamedFace& named : solid.named_faces) {
        to.put(faces.FindIndex(named.face));
        to.put(named.name);
    }
    to.put(notes.size());
    for (const auto& note : notes) {
        to.put(note);
    }
    return to.take();
}

ReadySolid from_bytes(const std::string& bytes)
{
    ReadySolid solid;
    Unpacker from(bytes);
    from.get(solid.shape);
    std::size_t count = 0;
    from.get(count);
    solid.face_names.resize(count);
    for (auto& [number, name] : solid.face_names) {
        from.get(number);
        from.get(name);
    }
    from.get(count);
    solid.notes.resize(count);
    for (auto& note : solid.notes) {
        from.get(note);
    }
    return solid;
}

ReadySolid prepared_in_child(const ForeignFile& file, const StepSource& source, const SolidRules& rules, double seconds,
                             const Waiting& waiting)
{
    const ChildLimits limits{half_of_memory(), seconds, file.path, file.name};
    const auto work = [&] {
        std::string bytes;
        guard_gmsh(file.part, "reading its STEP file", [&] {
            try {
                std::vector<std::string> notes;
                const StepSolid solid = prepared(file, source, rules, notes);
                bytes = packed(solid, notes);
            } catch (const Standard_Failure& failure) {
                throw std::runtime_error(failure.GetMessageString());
            }
        });
        return bytes;
    };
    return from_bytes(
        run_in_child(fmt::format("part '{}': reading '{}'", file.part, file.path), limits, work, waiting));
}

}  // namespace

ReadySolid ready_solid(const ForeignFile& file, const StepSource& source, const SolidRules& rules,
                       const Waiting& waiting)
{
    const auto with = [&](double omit, double seconds) {
        auto own = rules;
        own.omit = omit;
        return prepared_in_child(file, source, own, seconds, waiting);
    };
    const auto without_omission = [&](const std::string& reason) {
        ReadySolid solid = with(0, longest_preparation);
        solid.notes.push_back(fmt::format("holes and roundings up to {:.3g} mm stay: {}; omit = \"0 mm\" does not try",
                                          1e3 * rules.omit, reason));
        return solid;
    };
    try {
        if (rules.omit <= 0) {
            return with(0, longest_preparation);
        }
        try {
            return with(rules.omit, patience);
        } catch (const TimeLimitError&) {
            return without_omission(fmt::format("leaving them out takes longer than {:.0f} s", patience));
        } catch (const ForeignError&) {
            return without_omission("the geometry kernel cannot leave them out");
        }
    } catch (const ForeignError&) {
        throw unreadable(file);
    }
}

StepSolid unpacked(const ReadySolid& ready)
{
    StepSolid solid;
    std::istringstream shape(ready.shape);
    BinTools::Read(solid.shape, shape);
    const auto faces = indexed_faces_of(solid.shape);
    for (const auto& [number, name] : ready.face_names) {
        if (number > 0 && number <= faces.Extent()) {
            solid.named_faces.push_back({TopoDS::Face(faces.FindKey(number)), name});
        }
    }
    return solid;
}

}  // namespace deadpoint::machine
