#pragma once

#include "deadpoint/core/vec.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Input of the machine stage (a description of solids, surfaces and contacts) and its output (a
/// mesh with contact points). SI units; coordinates of the machine at bottom dead point.
namespace deadpoint {

enum class Axis : int { x = 0, y = 1, z = 2 };

// ---------------------------------------------------------------- input

/// Box with faces parallel to the coordinate planes.
struct BoxShape {
    Vec3 min{};
    Vec3 max{};
};

/// Full or hollow cylinder along a coordinate axis. `centre` holds the two coordinates across the axis, in the order
/// of the alphabet (axis z: x, y; axis y: x, z; axis x: y, z). `bore` = 0 means full.
struct CylinderShape {
    Axis axis = Axis::z;
    Vec2 centre{};
    double diameter = 0;
    double bore = 0;
    double from = 0;
    double to = 0;
};

/// Polygon with polygonal holes, extruded along a coordinate axis. Points are ordered around the outline, either way;
/// their two coordinates are those across the axis, in the order of the alphabet.
struct OutlineShape {
    Axis axis = Axis::z;
    std::vector<Vec2> points;
    std::vector<std::vector<Vec2>> holes;
    double from = 0;
    double to = 0;
};

struct ShaftSection {
    double length = 0;
    double diameter = 0;
    Vec2 offset{};  ///< of this section's centre from the shaft's centre line (crank throw)
};

/// Stepped shaft: sections one after the other along an axis, starting at `from`.
struct ShaftShape {
    Axis axis = Axis::z;
    Vec2 centre{};
    double from = 0;
    std::vector<ShaftSection> sections;
};

/// Shapes apply in the order listed: `add` joins, `cut` removes; `imprint` only draws its outline into the mesh.
struct Shape {
    enum class Operation { add, cut, imprint };
    Operation operation = Operation::add;
    std::variant<BoxShape, CylinderShape, OutlineShape, ShaftShape> form;
};

/// How finely the solid of a STEP file is meshed, beyond the cell size of its part.
struct StepRules {
    int circle_cells = 24;       ///< cells around a full circle, where they are not smaller than `smallest`
    double smallest = 0;         ///< smallest cell [m]; 0: a third of the cell size
    std::optional<double> omit;  ///< holes and roundings up to this diameter are left out [m]; none: `smallest`
};

struct StepSource {
    std::string path;
    std::string solid = {};           ///< SolidReference as text; empty: all that the file holds
    std::optional<double> unit = {};  ///< length of one unit of the file [m]; none: what the file says, or millimetres
    std::array<Vec3, 3> axes{
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< x, y and z of the machine, as directions of the file
    StepRules rules = {};
};
struct MeshSource {
    std::string path;   ///< Gmsh mesh file; first-order hexahedra or tetrahedra
    double unit = 1.0;  ///< length of one unit of the file [m]
};

struct PartDescription {
    std::string name;
    std::string body;
    std::variant<std::vector<Shape>, StepSource, MeshSource> source;
    double size = 0;          ///< target cell size [m]; 0: that of the machine
    double density = 0;       ///< [kg/m3], for masses only
    Vec3 translation{};       ///< applied to STEP and mesh sources after scaling [m]
    bool tetrahedra = false;  ///< mesh with tetrahedra even where hexahedra would do
    /// True for elements of second order: edges on cylinders are then round, and contacts get the
    /// integration points that these need.
    bool second_order = false;
};

/// Which exterior faces of which parts. All conditions given must hold.
struct SurfaceSelector {
    enum class Kind { exposed, all, plane, cylinder, group };
    Kind kind = Kind::all;
    std::vector<std::string> parts;  ///< names or patterns with * ; empty: every part
    Axis axis = Axis::z;             ///< plane: its normal; cylinder: its axis
    double position = 0;             ///< plane: coordinate along its normal [m]
    std::optional<Vec3> normal;      ///< plane: in place of `axis`, either way; exact to 1 mrad
    Vec3 point{};                    ///< plane: on it, where `normal` is given [m]
    Vec2 centre{};                   ///< cylinder: across its axis [m]
    double diameter = 0;             ///< cylinder [m]
    std::string group;               ///< name of a physical surface of a mesh or STEP source
    /// Selects only what is inside this box: shares of faces, and contacts clipped to it.
    std::optional<BoxShape> within;
};

struct SurfaceDescription {
    std::string name;
    SurfaceSelector selector;
};

/// One of the positions that represent the travel of a slide over a turn.
struct TravelStop {
    Vec3 offset{};     ///< of the moving body from where it is drawn, as seen from the standing one [m]
    double share = 0;  ///< of the time; at 0 it counts for the least coverage only
};

/// Travel of one body along another, over times much longer than a turn. The shares of its stops
/// sum to 1.
struct Travel {
    std::string moving;    ///< body
    std::string standing;  ///< body
    std::vector<TravelStop> stops;
};

struct InterfaceDescription {
    std::string name;   ///< "joint.interface"
    SurfaceSelector a;  ///< the integrated side
    SurfaceSelector b;
    double gap = 0;  ///< largest distance between the two sides that still counts as contact [m]; 0: automatic
    /// Distributes a contact of these two bodies over the swept areas; either body may have side a.
    /// Without stops the contact is that of the drawn bodies.
    Travel travel{};
    bool partial = false;  ///< side a may reach beyond side b; else most of it must be covered
};

/// How heat passes between touching parts of one body that are held together without being one solid. They still move
/// together.
struct BondDescription {
    std::string name;
    std::vector<std::string> between;  ///< pairs "a|b" (patterns) of one body
    bool open = false;                 ///< no heat passes; else that of a conductance
};

struct MachineDescription {
    std::vector<PartDescription> parts;
    std::vector<SurfaceDescription> surfaces;
    std::vector<InterfaceDescription> interfaces;
    double size = 0.03;                  ///< target cell size of parts that state none [m]
    double size_scale = 1;               ///< scales every size
    double seam_tolerance = 1e-5;        ///< surfaces of shapes of one part that are this close are joined [m]
    bool half_model = false;             ///< keep x <= 0 only; the cut faces become the symmetry plane
    std::vector<std::string> unbonded;   ///< pairs "a|b" (patterns) of one body that touch but are not bonded
    std::vector<BondDescription> bonds;  ///< those that are not in perfect contact
};

// ---------------------------------------------------------------- output

enum class CellKind : std::uint8_t { hexahedron, tetrahedron };

/// First-order cell; node order as in VTK (hexahedron: bottom 0-3 counter-clockwise seen from the top, then top 4-7).
struct Cell {
    CellKind kind = CellKind::hexahedron;
    std::uint32_t part = 0;
    std::array<std::uint32_t, 8> nodes{};
};

struct PlaneGeometry {
    Vec3 normal{};      ///< unit, out of the solid
    double offset = 0;  ///< normal . x on the plane [m]
};
struct CylinderGeometry {
    Vec3 point{};  ///< on the axis
    Vec3 axis{};   ///< unit
    double radius = 0;
    bool bore = false;  ///< true where the solid lies outside the radius
};
struct FreeformGeometry {};
using FaceGeometry = std::variant<FreeformGeometry, PlaneGeometry, CylinderGeometry>;

/// Exterior face of a cell; 3 or 4 nodes, counter-clockwise seen from outside.
struct Face {
    std::uint32_t cell = 0;
    std::uint32_t part = 0;
    std::uint8_t node_count = 4;
    bool symmetry = false;  ///< on the plane x = 0 of a half model
    std::array<std::uint32_t, 4> nodes{};
    std::uint32_t geometry = 0;  ///< index into Machine::geometries
};

/// Integrals of 1, x, y and x^2 + y^2 over the cells of a part. Edges are straight here.
struct VolumeMoments {
    double volume = 0;  ///< [m3]
    Vec2 first{};       ///< of x and y [m4]
    double second = 0;  ///< of x^2 + y^2 [m5]
};

struct MeshPart {
    std::string name;
    std::string body;
    std::uint32_t first_cell = 0;
    std::uint32_t cell_count = 0;
    CellKind kind = CellKind::hexahedron;
    double volume = 0;         ///< of the mesh, round edges included [m3], this model (half of a cut part)
    double mass = 0;           ///< volume times density [kg]
    bool cut = false;          ///< cut by the symmetry plane
    double exterior_area = 0;  ///< [m2], without the symmetry plane
    double exposed_area = 0;   ///< [m2], without symmetry plane, contacts and bonds
    std::uint32_t pieces = 1;  ///< pieces without a common face of two cells
    double min_quality = 0;    ///< of its worst cell, 0..1 (machine/geometry/part_mesh)
    double mean_quality = 0;
    VolumeMoments moments{};
};

/// One integration point of a contact, on both sides.
struct ContactPoint {
    std::uint32_t face_a = 0;
    std::uint32_t face_b = 0;
    Vec3 position_a{};  ///< on face a: its facet, or where its edges are round the surface that they span
    Vec3 position_b{};  ///< on face b
    Vec3 normal{};      ///< unit, out of a into b, of the true (not faceted) surface
    double weight = 0;  ///< area [m2], times the share of time it is in contact; sums to Contact::area
};

/// Two surfaces in contact: an interface of a joint, or a bond of two parts of one body.
///
/// Where one body travels along the other, `points` hold the contact at every stop. The two
/// positions of a point then meet at that stop. Each is given on its own body as drawn, where the
/// field of that body is defined.
struct Contact {
    std::string name;       ///< of the interface, or "part|part" for a bond
    FaceGeometry geometry;  ///< of side a
    std::vector<ContactPoint> points;
    std::vector<ContactPoint> drawn_points;  ///< of the bodies as drawn, where one travels; else none
    double area = 0;                         ///< in contact, mean over time [m2]
    double drawn_area = 0;                   ///< in contact as drawn [m2]
    double least_area = 0;                   ///< the smallest in contact over the travel [m2]
    double stroke = 0;                       ///< length of the travel [m]
    double area_a = 0;                       ///< of the whole integrated side [m2]
    double area_b = 0;                       ///< of the whole other side [m2]
    double max_gap = 0;                      ///< largest distance between two points that meet [m]
    std::uint32_t part_a = 0;                ///< interfaces join exactly one part to one part
    std::uint32_t part_b = 0;
    bool perfect = true;  ///< of a bond: both sides have one temperature; else it conducts as an interface, or is open
    /// Share of the integrated side in contact as drawn, and the least over the travel.
    [[nodiscard]] double coverage() const { return area_a > 0 ? drawn_area / area_a : 0.0; }
    [[nodiscard]] double least_coverage() const { return area_a > 0 ? least_area / area_a : 0.0; }
    /// The contact as drawn, for results at bottom dead point.
    [[nodiscard]] const std::vector<ContactPoint>& points_as_drawn() const
    {
        return drawn_points.empty() ? points : drawn_points;
    }
};

struct SurfaceFace {
    std::uint32_t face = 0;
    double fraction = 1;  ///< share of the face's area that is exposed, or in the selection
    bool central = true;  ///< its centre is in the selection: for conditions at nodes
};

/// First and second moment of a surface's area about the machine's axis, by its area.
struct PlaneMoments {
    Vec2 mean{};             ///< of x and y [m]
    double mean_square = 0;  ///< of x^2 + y^2 [m2]
};

/// The share of a surface that lies on one part.
struct SurfaceShare {
    std::uint32_t part = 0;
    double area = 0;  ///< [m2], with the fractions
};

/// Figures of a surface, for laws that need no mesh then. Lengths along edges of the mesh are those of whole faces.
struct SurfaceFigures {
    std::optional<double> height;             ///< along y, of a surface on one part [m]
    std::optional<double> cylinder_diameter;  ///< of a surface that is a single cylinder [m]
    /// Diameter of a disk [m]: that of the largest cylinder at which its faces end, along the normal of one of them.
    /// None if there is no such cylinder, or if the surface lies on several parts or reaches beyond it.
    std::optional<double> disk_diameter;
    /// Area over perimeter of a surface that is a single plane [m]. The perimeter runs along the edges of its faces
    /// that no other of its faces shares, the plane of symmetry left out: a half has the quotient of the whole.
    std::optional<double> area_over_perimeter;
    /// From one point per face: exact in the mean of flat faces, second moments as fine as the mesh.
    PlaneMoments moments;
    std::vector<SurfaceShare> parts;  ///< in the order of their first faces
};

struct MeshSurface {
    std::string name;
    std::vector<SurfaceFace> faces;
    double area = 0;  ///< [m2], with the fractions
    SurfaceFigures figures{};
};

struct Overlap {
    std::string part_a;
    std::string part_b;
    Vec3 where{};
    double depth = 0;  ///< [m]
};

/// An edge of a cylinder in a part of second order. It is the parabola through its nodes and its middle, which lies on
/// the cylinder; faces and cells follow it as in elements with nodes in the middle of edges (exchange/round_edges).
struct RoundEdge {
    std::array<std::uint32_t, 2> nodes{};  ///< ascending
    Vec3 bulge{};                          ///< from the middle of the chord to the middle of the edge [m]
};

/// The meshed machine. Its parts, surfaces and contacts carry the figures that loads and laws need; without_mesh()
/// (exchange/bare_machine) keeps only these.
struct Machine {
    std::vector<Vec3> nodes;
    std::vector<RoundEdge> round_edges;  ///< ascending by their nodes; edges that are not listed are straight
    std::vector<Cell> cells;
    std::vector<std::uint32_t> piece_of_cell;  ///< within its part, from 0; none where every part is one piece
    std::vector<Face> faces;
    std::vector<FaceGeometry> geometries;
    std::vector<MeshPart> parts;
    std::vector<MeshSurface> surfaces;  ///< in the order of the description
    /// Contacts of joints, in the order of the description; then the bonds with a conductance, also among `bonds`.
    std::vector<Contact> interfaces;
    std::vector<Contact> bonds;            ///< all of them: what moves together
    std::vector<double> exposed_fraction;  ///< per face, mean over time, 0..1; 0 on the symmetry plane
    std::vector<Overlap> overlaps;
    std::vector<std::string> floating_parts;  ///< not connected: no bond, no interface
    std::vector<std::string> dropped_parts;   ///< wholly on the far side of the symmetry plane
    bool half_model = false;
};

/// The faces of an interface, also of one that was refused.
struct InterfaceFaces {
    std::string name;  ///< as InterfaceDescription::name
    /// Indices of Machine::faces. Of a contact the faces that touch; where it was refused, those its selectors match.
    std::array<std::vector<std::uint32_t>, 2> sides;
    bool joined = false;  ///< Machine::interfaces holds it
};

}  // namespace deadpoint
