#pragma once

#include <string>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// The plan of a case before anything is solved, as text.
namespace deadpoint::report {

struct SizeEstimate {
    long long hexahedra = 0;
    long long tetrahedra = 0;
    long long heat_unknowns = 0;
    long long deformation_unknowns = 0;  ///< 0 where the case has no dimension chain
    double deformation_scale = 1;        ///< of the deformation's cells to those of the heat
    double memory = 0;                   ///< [byte]
};

/// Unknowns and memory of a run.
///
/// One heat unknown per node and three of deformation, those divided by the cube of the scale if
/// the deformation has a separate mesh (press::deformation_scale); second order has about eight
/// times the nodes of first order, whose matrix rows hold about 2.5 times as many entries. Memory
/// is memory_base plus that per unknown, measured on meshes of 0.1 to 2.4 million hexahedra of
/// first order with algebraic multigrid; accurate to about a third.
SizeEstimate estimate_size(const casefile::Case& description, const Machine& machine);
inline constexpr double memory_base = 0.25e9;             ///< program and libraries [byte]
inline constexpr double memory_per_heat_unknown = 2.2e3;  ///< matrices, multigrid, vectors [byte]
inline constexpr double memory_per_deformation_unknown = 3.2e3;

/// The plan as text: bodies and masses, parts with cells and quality, joints and interfaces, bonds, surfaces, size.
std::string plan_text(const casefile::Case& description, const Machine& machine);

}  // namespace deadpoint::report
