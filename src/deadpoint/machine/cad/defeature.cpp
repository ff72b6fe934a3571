#include "deadpoint/machine/cad/defeature.hpp"

#include "deadpoint/machine/cad/face_middle.hpp"
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Defeaturing.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::machine {
namespace {

/// Most faces in a chain of holes and roundings: the kernel takes minutes for longer ones, and mostly fails.
constexpr int most_faces = 24;

double volume_of(const TopoDS_Shape& shape)
{
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
}

/// Whether the solid lies outside of the face's radius, by its normal in the middle of the face.
bool hollow(const TopoDS_Face& face, const gp_Pnt& centre)
{
    const FaceMiddle middle = middle_of(face);
    return middle.out.Dot(gp_Vec(centre, middle.point)) < 0;
}

double turn_of(const TopoDS_Face& face)
{
    double u[2]{};
    double v[2]{};
    BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
    return u[1] - u[0];
}

/// Holes, and roundings of at most a quarter turn and a bit; not pins, which are the part itself.
bool is_small(const TopoDS_Face& face, double diameter)
{
    constexpr double of_rounding = 0.6 * std::numbers::pi;
    const BRepAdaptor_Surface surface(face);
    switch (surface.GetType()) {
    case GeomAbs_Cylinder: {
        const gp_Cylinder cylinder = surface.Cylinder();
        return 2 * cylinder.Radius() <= diameter && (turn_of(face) <= of_rounding || hollow(face, cylinder.Location()));
    }
    case GeomAbs_Torus:
        return 2 * surface.Torus().MinorRadius() <= diameter;
    case GeomAbs_Sphere:
        return 2 * surface.Sphere().Radius() <= diameter;
    case GeomAbs_Cone: {
        double u[2]{};
        double v[2]{};
        BRepTools::UVBounds(face, u[0], u[1], v[0], v[1]);
        const gp_Cone cone = surface.Cone();
        const auto radius = [&](double along) {
            return std::abs(cone.RefRadius() + along * std::sin(cone.SemiAngle()));
        };
        return 2 * std::max(radius(v[0]), radius(v[1])) <= diameter && hollow(face, cone.Location());
    }
    default:
        return false;
    }
}

using Neighbours = TopTools_IndexedDataMapOfShapeListOfShape;

/// Whether all neighbours of a face across its edges are in a set: the bottom of a hole.
bool enclosed(const TopoDS_Shape& face, const Neighbours& around, const TopTools_IndexedMapOfShape& faces)
{
    bool any = false;
    for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
        if (!around.Contains(edge.Current())) {
            return false;
        }
        for (const TopoDS_Shape& other : around.FindFromKey(edge.Current())) {
            if (other.IsSame(face)) {
                continue;
            }
            any = true;
            if (!faces.Contains(other)) {
                return false;
            }
        }
    }
    return any;
}

/// The faces of a solid, each once.
std::vector<TopoDS_Shape> faces_of(const TopoDS_Shape& solid)
{
    TopTools_IndexedMapOfShape all;
    TopExp::MapShapes(solid, TopAbs_FACE, all);
    std::vector<TopoDS_Shape> faces;
    for (int i = 1; i <= all.Extent(); ++i) {
        faces.push_back(all.FindKey(i));
    }
    return faces;
}

/// Whether a face is as small as the bottom of a hole of this diameter. A large face between roundings is none.
bool fits_hole(const TopoDS_Shape& face, double diameter)
{
    Bnd_Box box;
    BRepBndLib::Add(face, box, false);
    const gp_XYZ edges = box.CornerMax().XYZ() - box.CornerMin().XYZ();
    constexpr double slack = 1e-3;
    return std::max({edges.X(), edges.Y(), edges.Z()}) <= (1 + slack) * diameter;
}

/// Faces of small holes and roundings, and bottoms of holes.
TopTools_IndexedMapOfShape small_faces(const TopoDS_Shape& solid, const Neighbours& around, double diameter)
{
    const auto all = faces_of(solid);
    TopTools_IndexedMapOfShape small;
    for (const TopoDS_Shape& face : all) {
        if (is_small(TopoDS::Face(face), diameter)) {
            small.Add(face);
        }
    }
    const TopTools_IndexedMapOfShape sides = small;
    for (const TopoDS_Shape& face : all) {
        if (!sides.Contains(face) && fits_hole(face, diameter) && enclosed(face, around, sides)) {
            small.Add(face);
        }
    }
    return small;
}

/// The faces of a set that are connected with one of them across edges.
TopTools_ListOfShape connected(const TopoDS_Shape& first, const Neighbours& around,
                               const TopTools_IndexedMapOfShape& set, TopTools_IndexedMapOfShape& taken)
{
    TopTools_ListOfShape group;
    std::vector<TopoDS_Shape> open{first};
    taken.Add(first);
    while (!open.empty()) {
        const TopoDS_Shape face = open.back();
        open.pop_back();
        group.Append(face);
        for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
            for (const TopoDS_Shape& other : around.FindFromKey(edge.Current())) {
                if (set.Contains(other) && !taken.Contains(other)) {
                    taken.Add(other);
                    open.push_back(other);
                }
            }
        }
    }
    return group;
}

/// Small faces in groups that touch: a hole with its bottom, a chain of roundings.
std::vector<TopTools_ListOfShape> features(const TopoDS_Shape& solid, double diameter)
{
    Neighbours around;
    TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, around);
    const auto small = small_faces(solid, around, diameter);
    std::vector<TopTools_ListOfShape> groups;
    TopTools_IndexedMapOfShape taken;
    for (int i = 1; i <= small.Extent(); ++i) {
        if (!taken.Contains(small.FindKey(i))) {
            groups.push_back(connected(small.FindKey(i), around, small, taken));
        }
    }
    return groups;
}

/// The solid without some of its faces; false where it cannot be closed.
bool without(StepSolid& solid, const TopTools_ListOfShape& faces)
{
    try {
        BRepAlgoAPI_Defeaturing work;
        work.SetShape(solid.shape);
        work.AddFacesToRemove(faces);
        work.SetRunParallel(false);
        work.Build();
        if (!work.IsDone() || work.HasErrors() || !BRepCheck_Analyzer(work.Shape()).IsValid()) {
            return false;
        }
        TopTools_IndexedMapOfShape left;
        TopExp::MapShapes(work.Shape(), TopAbs_FACE, left);
        TopTools_IndexedMapOfShape before;
        TopExp::MapShapes(solid.shape, TopAbs_FACE, before);
        if (left.Extent() >= before.Extent()) {
            return false;
        }
        std::vector<NamedFace> named;
        for (const NamedFace& one : solid.named_faces) {
            if (left.Contains(one.face)) {
                named.push_back(one);
            }
            for (const TopoDS_Shape& image : work.Modified(one.face)) {
                named.push_back({TopoDS::Face(image), one.name});
            }
        }
        solid.named_faces = std::move(named);
        solid.shape = work.Shape();
        return true;
    } catch (const Standard_Failure&) {
        return false;
    }
}

}  // namespace

std::vector<std::string> defeature(StepSolid& solid, double diameter)
{
    const double before = volume_of(solid.shape);
    const auto groups = features(solid.shape, diameter);
    if (groups.empty()) {
        return {};
    }
    TopTools_ListOfShape everything;
    for (TopTools_ListOfShape group : groups) {
        if (group.Extent() <= most_faces) {
            everything.Append(group);
        }
    }
    std::size_t done = 0;
    if (!everything.IsEmpty() && without(solid, everything)) {
        done = groups.size() - features(solid.shape, diameter).size();
    } else {
        // One by one; after the first, faces next to it are new ones, so groups are looked for again.
        std::size_t skip = 0;
        for (auto left = groups; skip < left.size(); left = features(solid.shape, diameter)) {
            left[skip].Extent() <= most_faces&& without(solid, left[skip]) ? ++done : ++skip;
        }
    }
    std::vector<std::string> notes;
    if (done > 0) {
        notes.push_back(fmt::format(
            "holes and roundings up to {:.3g} mm are left out: {} of {}, which changes its volume by {:+.3f} %",
            diameter, done, groups.size(), 100 * (volume_of(solid.shape) / before - 1)));
    }
    if (done < groups.size()) {
        notes.push_back(fmt::format(
            "holes and roundings up to {:.3g} mm stay: {}, around which the faces do not close without them", diameter,
            groups.size() - done));
    }
    return notes;
}

}  // namespace deadpoint::machine
