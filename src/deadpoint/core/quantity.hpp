#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>

/// Text with a unit ("300 kN") to SI numbers and back. The only place where units other than SI exist.
namespace deadpoint {

/// Dimension of a number. Angles differ from plain numbers, temperature differences from
/// temperatures.
enum class Dimension {
    none,
    length,
    area,
    mass,
    density,
    time,
    angle,
    angular_velocity,
    velocity,
    force,
    power,
    pressure,
    temperature,
    temperature_difference,
    conductivity,
    specific_heat,
    heat_transfer_coefficient,
    thermal_resistance,
    expansion,
    kinematic_viscosity,
    stiffness,
    damping,
    inertia,
    heat_flux,
    thermal_conductance,
    volume,
    volume_flow,
    heat_capacity,
    acceleration,
    bedding,
};

/// Name and units of a dimension.
struct DimensionInfo {
    Dimension dimension;
    std::string_view name;       ///< with its article: "a length"
    std::string_view si_unit;    ///< "m"
    std::string_view preferred;  ///< unit in which values are written: "mm"
    std::string_view example;    ///< "200 mm"
};

/// @return the entry of `dimension`
const DimensionInfo& dimension_info(Dimension dimension);
/// All dimensions, in the order of the enumeration.
std::span<const DimensionInfo> all_dimensions();

/// Reason why a text is not the expected quantity.
struct QuantityProblem {
    std::string
        code;  ///< "missing-unit", "unknown-unit", "unit-mismatch", "not-a-quantity", "decimal-comma", "not-finite"
    std::string message;  ///< the mistake
    std::string help;     ///< what to write instead
};

/// SI value of a text such as "300 kN", "68 degF" or "1.05e-5 1/K" (units of UDUNITS-2, besides those below).
///
/// Angles have the units deg, rad and mrad. Angular velocities have rpm, rad/s and deg/s; "Hz"
/// would be ambiguous (turns or radians). Temperatures have K, degC and degF. Temperature
/// differences have K only, since the zero of degC and degF is not that of a difference. A decimal
/// factor moves the point in the text, so that "29.8 mm" and "0.0298 m" give the same double.
///
/// @param text      number, optional space, unit; surrounding space is ignored
/// @param dimension the expected dimension; Dimension::none accepts a number without unit
/// @return the value in SI units, finite, or the problem
/// @throws IoError if the unit database of UDUNITS-2 cannot be read
std::variant<double, QuantityProblem> try_parse_quantity(std::string_view text, Dimension dimension);

/// As try_parse_quantity.
/// @throws InputError with message and help in one text
double parse_quantity(std::string_view text, Dimension dimension);

/// The value as text in the dimension's preferred unit, or in SI if the preferred unit would lose a
/// bit; try_parse_quantity(format_quantity(v, d), d) == v exactly, for every finite v.
/// @param value in SI units, finite
std::string format_quantity(double value, Dimension dimension);

/// Shortest text that reads back as the same double, always with a point or an exponent ("1.0", "1e-10").
std::string format_number(double value);

}  // namespace deadpoint
