#pragma once

#include "deadpoint/core/linear_curve.hpp"

/// Properties of a solid for heat and deformation. SI units, temperatures in kelvin.
namespace deadpoint {

/// Constants, and tables over temperature that replace them: linear between their points, constant
/// beyond.
struct Material {
    double density = 0;         ///< [kg/m3]
    double conductivity = 0;    ///< [W/m/K]; with a table, its value at the start, which scales the matrices
    double specific_heat = 0;   ///< [J/kg/K]; likewise
    double expansion = 0;       ///< [1/K]; likewise
    double youngs_modulus = 0;  ///< [Pa]
    double poissons_ratio = 0;
    LinearCurve conductivity_table{};     ///< empty: the constant
    LinearCurve specific_heat_table{};    ///< empty: the constant
    LinearCurve expansion_table{};        ///< empty: the constant
    bool expansion_is_mean = false;       ///< of the table: mean from the reference temperature on, else instantaneous
    double expansion_reference = 293.15;  ///< of a mean coefficient [K]
};

/// Temperature with the same heat content at the constant specific heat c_0:  T_0 + integral from
/// T_0 of c / c_0 [K], T_0 the table's first point; the temperature itself without a table.
/// Strictly increasing.
double heat_temperature(const Material& material, double temperature);
/// Its derivative c / c_0.
double heat_temperature_slope(const Material& material, double temperature);

/// The transform of Kirchhoff, whose gradient times the constant conductivity k_0 is k grad T: T_0 + integral from T_0
/// of k / k_0  [K] (Carslaw and Jaeger, sec. 1.6); the temperature itself without a table.
double flux_temperature(const Material& material, double temperature);
/// Its derivative k / k_0.
double flux_temperature_slope(const Material& material, double temperature);

/// Coefficient with which the deformation is computed [1/K]: the constant, or the largest value of
/// the table. Not 0 with a table.
double expansion_scale(const Material& material);
/// The rise that gives the same strain with expansion_scale(): (eps(T) - eps(T_start)) / scale
/// [K], with
///   eps = alpha(T) (T - T_reference)          of a mean coefficient,
///   eps = integral of alpha dT                of an instantaneous one.
/// T - T_start without a table.
double expansion_rise(const Material& material, double temperature, double start);
/// Its derivative by the temperature.
double expansion_rise_slope(const Material& material, double temperature);

}  // namespace deadpoint
