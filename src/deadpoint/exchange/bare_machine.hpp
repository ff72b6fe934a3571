#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <tuple>

/// A machine without its mesh, as a description of a run's loads, laws and heat problem.
namespace deadpoint {

/// Parts, surfaces, interfaces and bonds with their figures; no nodes, cells, faces, contact points or exposed
/// fractions. What it holds is what members() lists, and so what a binary file of it holds (io/binary_file).
Machine without_mesh(const Machine& machine);

constexpr auto last_value(const CellKind*) { return CellKind::tetrahedron; }
constexpr auto members(const FreeformGeometry*) { return std::tuple{}; }
constexpr auto members(const PlaneGeometry*) { return std::tuple{&PlaneGeometry::normal, &PlaneGeometry::offset}; }
constexpr auto members(const CylinderGeometry*)
{
    return std::tuple{&CylinderGeometry::point, &CylinderGeometry::axis, &CylinderGeometry::radius,
                      &CylinderGeometry::bore};
}
constexpr auto members(const VolumeMoments*)
{
    return std::tuple{&VolumeMoments::volume, &VolumeMoments::first, &VolumeMoments::second};
}
constexpr auto members(const MeshPart*)
{
    return std::tuple{&MeshPart::name,          &MeshPart::body,         &MeshPart::first_cell, &MeshPart::cell_count,
                      &MeshPart::kind,          &MeshPart::volume,       &MeshPart::mass,       &MeshPart::cut,
                      &MeshPart::exterior_area, &MeshPart::exposed_area, &MeshPart::pieces,     &MeshPart::min_quality,
                      &MeshPart::mean_quality,  &MeshPart::moments};
}
constexpr auto members(const PlaneMoments*) { return std::tuple{&PlaneMoments::mean, &PlaneMoments::mean_square}; }
constexpr auto members(const SurfaceShare*) { return std::tuple{&SurfaceShare::part, &SurfaceShare::area}; }
constexpr auto members(const SurfaceFigures*)
{
    return std::tuple{&SurfaceFigures::height,        &SurfaceFigures::cylinder_diameter,
                      &SurfaceFigures::disk_diameter, &SurfaceFigures::area_over_perimeter,
                      &SurfaceFigures::moments,       &SurfaceFigures::parts};
}
constexpr auto members(const MeshSurface*)
{
    return std::tuple{&MeshSurface::name, &MeshSurface::area, &MeshSurface::figures};
}
constexpr auto members(const Contact*)
{
    return std::tuple{&Contact::name,       &Contact::geometry, &Contact::area,   &Contact::drawn_area,
                      &Contact::least_area, &Contact::stroke,   &Contact::area_a, &Contact::area_b,
                      &Contact::max_gap,    &Contact::part_a,   &Contact::part_b};
}
constexpr auto members(const Overlap*)
{
    return std::tuple{&Overlap::part_a, &Overlap::part_b, &Overlap::where, &Overlap::depth};
}
constexpr auto members(const Machine*)
{
    return std::tuple{&Machine::parts,    &Machine::surfaces,       &Machine::interfaces,    &Machine::bonds,
                      &Machine::overlaps, &Machine::floating_parts, &Machine::dropped_parts, &Machine::half_model};
}

}  // namespace deadpoint
