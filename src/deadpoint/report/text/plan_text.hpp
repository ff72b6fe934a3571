#pragma once

#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// The plan of a case before anything is solved, as text.
namespace deadpoint::report {

/// Mass of one body of the whole machine, computed from its mesh.
///
/// In a half model a body that straddles the symmetry plane (one of its parts is cut, or lies
/// wholly on the far side) counts twice; any other body is one of a pair and counts once.
struct BodyMass {
    std::string body;
    int parts = 0;                 ///< modelled
    double computed = 0;           ///< [kg]
    std::optional<double> stated;  ///< in the case file [kg]
    bool partial = false;          ///< exists twice and is cut by the plane of symmetry: less than the body is modelled
    /// Computed over stated, less one; none if no mass is stated or the body is modelled in part
    /// only.
    [[nodiscard]] std::optional<double> deviation() const;
};
std::vector<BodyMass> body_masses(const casefile::Case& description, const Machine& machine);

/// Computed and stated mass may differ by this share before it is warned about.
inline constexpr double mass_tolerance = 0.02;

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
/// the deformation has a separate mesh (study::deformation_scale); second order has about eight
/// times the nodes of first order, whose matrix rows hold about 2.5 times as many entries. Memory
/// is memory_base plus that per unknown, measured on meshes of 0.1 to 2.4 million hexahedra of
/// first order with algebraic multigrid; accurate to about a third.
SizeEstimate estimate_size(const casefile::Case& description, const Machine& machine);
inline constexpr double memory_base = 0.25e9;             ///< program and libraries [byte]
inline constexpr double memory_per_heat_unknown = 2.2e3;  ///< matrices, multigrid, vectors [byte]
inline constexpr double memory_per_deformation_unknown = 3.2e3;

/// Warnings of the plan: masses, overlaps, parts that are not connected, one sentence each.
std::vector<std::string> plan_warnings(const casefile::Case& description, const Machine& machine);

/// The plan as text: bodies and masses, parts with cells and quality, joints and interfaces, bonds, surfaces, size.
std::string plan_text(const casefile::Case& description, const Machine& machine);

}  // namespace deadpoint::report
