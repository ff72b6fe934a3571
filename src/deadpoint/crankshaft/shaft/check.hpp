#pragma once

#include <string>
#include <vector>

namespace deadpoint {
struct Warning;
}

namespace deadpoint::crankshaft {

struct Section;
struct Shaft;

inline constexpr double same_place = 1e-6;  ///< places that are nearer are one; relative to the length of the shaft

/// Checks that the description is valid.
/// @throws CaseError with every wrong section, disk and bearing: sizes or moduli not positive or not finite, a bore not
/// less
///         than its diameter, something beyond the ends of the shaft, fewer than two bearing positions, stiffness or
///         damping that would drive the shaft, a damping ratio outside 0..1
void check_shaft(const Shaft& shaft);

/// Warnings of probable mistakes: a section more than three times as thick as its neighbours (a
/// pulley or gear does not bend like a beam); a disk at a section that itself weighs more than half
/// the disk or is as thick as that (the mass would count twice); no damping, or only that of the
/// bearings.
/// @throws CaseError as check_shaft
std::vector<Warning> shaft_warnings(const Shaft& shaft);

/// Ends of the shaft along s [m].
double shaft_end(const Shaft& shaft);
/// Mass of a section [kg].
double section_mass(const Section& section);

}  // namespace deadpoint::crankshaft
