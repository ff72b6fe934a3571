#pragma once

/// Tolerances and limits of contacts and meshes.
namespace deadpoint::machine {

/// Least share of the integrated side of an interface that must find a partner.
inline constexpr double least_coverage = 0.98;
/// Share of the integrated side that should touch along the whole travel; below it the program
/// warns, since guides are normally longer.
inline constexpr double least_guided = 0.5;
/// Largest distance between two surfaces that counts as contact if an interface states none [m].
inline constexpr double contact_tolerance = 1e-5;
/// Quality of a cell (part_mesh.hpp) below which it counts as inverted or flat, whatever its part comes from.
inline constexpr double least_quality = 1e-3;
/// Quality below which its part is warned about, and hexahedra give way to tetrahedra.
inline constexpr double poor_quality = 0.05;

}  // namespace deadpoint::machine
