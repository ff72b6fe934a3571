#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

#include <array>
#include <functional>
#include <vector>

/// Viscosity and density of oils over temperature.
namespace deadpoint::tribology {

/// Viscosity over the temperature [K]: kinematic [m2/s] unless said otherwise.
using ViscosityLaw = std::function<LawValue(double temperature)>;
/// Density [kg/m3] over the temperature [K].
using DensityLaw = std::function<LawValue(double temperature)>;

/// Limits of the kinematic viscosity of a lubricant [m2/s]: from below the thinnest fuels and
/// liquefied gases to an oil at its pour point, which has some 1e5 to 1e6 mm2/s. A law that leaves
/// them was extrapolated too far.
inline constexpr double thinnest_oil = 1e-7;
inline constexpr double stiffest_oil = 1;

/// Kinematic viscosity over temperature: ln nu is linear between the points. Beyond them it
/// continues with the end slopes and is flagged as out of range.
class ViscosityCurve {
public:
    /// @param temperature  increasing, at least two points [K]
    /// @param viscosity    as many, positive [m2/s]
    /// @throws InputError  if the points are fewer than two, do not increase, or a viscosity is not positive
    ViscosityCurve(std::vector<double> temperature, std::vector<double> viscosity);

    /// Viscosity [m2/s] and its derivative [m2/s/K]; at a point, the derivative of the side above it.
    /// @throws DomainError if the end slopes lead beyond thinnest_oil and stiffest_oil
    [[nodiscard]] LawValue operator()(double temperature) const;

private:
    std::vector<double> temperature_;
    std::vector<double> log_viscosity_;
};

/// Temperature range in which a formula is well tested [K]; beyond it the value is computed and
/// flagged.
struct TemperatureRange {
    double lowest = 253.15;
    double highest = 423.15;
};

/// log10 log10(nu + 0.7) = a - b log10 T, with nu in mm2/s and T in K (Walther; ASTM D341 for nu above 2 mm2/s).
struct Walther {
    double a = 0;
    double b = 0;  ///< > 0
    TemperatureRange range{};
};

struct ViscosityPoint {
    double temperature = 0;  ///< [K]
    double viscosity = 0;    ///< kinematic [m2/s]
};

/// The Walther line through two points (ASTM D341).
///
/// @param colder, warmer  two states of one oil; order does not matter
/// @throws InputError if a value is not positive, the temperatures are equal, or viscosity does not fall with them
Walther walther_through(const ViscosityPoint& colder, const ViscosityPoint& warmer, TemperatureRange range = {});

/// Viscosity by the Walther line; flagged outside its range and below 2 mm2/s, where D341 needs further terms.
///
/// @throws InputError if b is not positive; the law throws DomainError beyond thinnest_oil and stiffest_oil
ViscosityLaw walther_viscosity(const Walther& line);

/// nu = factor exp(b / (T - pole)) (Vogel 1921, as Cameron uses it with the pole at -95 degC).
struct Vogel {
    double factor = 0;     ///< [m2/s]
    double b = 0;          ///< [K]
    double pole = 178.15;  ///< [K]
    TemperatureRange range{};
};

/// Viscosity by Vogel's formula; flagged outside its range.
///
/// @throws InputError if factor or b is not positive, or the pole lies inside the range; the law throws DomainError
///         at the pole and below, and beyond thinnest_oil and stiffest_oil
ViscosityLaw vogel_viscosity(const Vogel& formula);

/// Density rho = density (1 - expansion (T - temperature)) (linear; mineral oil expands by 6.5e-4 to 7.5e-4 per
/// kelvin).
struct OilDensity {
    double density = 0;           ///< at the temperature below [kg/m3]
    double temperature = 288.15;  ///< [K]
    double expansion = 7e-4;      ///< by volume [1/K]
};

/// Flagged where the density has changed by more than a tenth.
///
/// @throws InputError if the density is not positive or the expansion negative; the law throws DomainError where the
///         density would not be positive
DensityLaw linear_density(const OilDensity& oil);

/// Properties of an oil for plain bearings.
struct Lubricant {
    ViscosityLaw viscosity;  ///< kinematic
    DensityLaw density;
};

/// Dynamic viscosity eta = rho nu [Pa s].
/// @throws InputError if a law of the lubricant is empty
ViscosityLaw dynamic_viscosity(const Lubricant& lubricant);

/// A viscosity grade of ISO 3448: the middle of its class at 40 degC, and the viscosity at 100 degC
/// that mineral oil of viscosity index 95 to 105 has. Grades are classes (10 % wide) and the index
/// is not part of them: the data sheet of an oil takes precedence.
struct IsoVgGrade {
    int grade = 0;
    double at_40 = 0;    ///< [m2/s]
    double at_100 = 0;   ///< [m2/s]
    double density = 0;  ///< at 15 degC, typical [kg/m3]
};

/// ISO VG 10 to 460.
const std::array<IsoVgGrade, 11>& iso_vg_grades();

/// @throws InputError if there is no such grade; the message lists the grades
IsoVgGrade iso_vg_grade(int grade);

/// Walther line and density of a grade.
/// @throws InputError if there is no such grade
Lubricant iso_vg_oil(int grade);

}  // namespace deadpoint::tribology
