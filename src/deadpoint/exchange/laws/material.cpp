#include "deadpoint/exchange/laws/material.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint {
namespace {

// The temperature up to which a constant value has the same integral as the table up to `temperature`.
double equivalent(const LinearCurve& table, double constant, double temperature)
{
    return table.empty() ? temperature : table.x().front() + table.integral(temperature) / constant;
}

double ratio(const LinearCurve& table, double constant, double temperature)
{
    return table.empty() ? 1.0 : table.value(temperature) / constant;
}

double strain(const Material& m, double temperature)
{
    return m.expansion_is_mean ? m.expansion_table.value(temperature) * (temperature - m.expansion_reference)
                               : m.expansion_table.integral(temperature);
}

}  // namespace

double heat_temperature(const Material& m, double temperature)
{
    return equivalent(m.specific_heat_table, m.specific_heat, temperature);
}

double heat_temperature_slope(const Material& m, double temperature)
{
    return ratio(m.specific_heat_table, m.specific_heat, temperature);
}

double flux_temperature(const Material& m, double temperature)
{
    return equivalent(m.conductivity_table, m.conductivity, temperature);
}

double flux_temperature_slope(const Material& m, double temperature)
{
    return ratio(m.conductivity_table, m.conductivity, temperature);
}

double expansion_scale(const Material& m)
{
    if (m.expansion_table.empty())
        return m.expansion;
    constexpr double any = 1e-5;  // of a table of zeros
    double largest = 0;
    for (const double value : m.expansion_table.y())
        largest = std::max(largest, std::abs(value));
    return largest > 0 ? largest : any;
}

double expansion_rise(const Material& m, double temperature, double start)
{
    if (m.expansion_table.empty())
        return temperature - start;
    return (strain(m, temperature) - strain(m, start)) / expansion_scale(m);
}

double expansion_rise_slope(const Material& m, double temperature)
{
    if (m.expansion_table.empty())
        return 1;
    const auto& table = m.expansion_table;
    const double mean_part = m.expansion_is_mean ? table.slope(temperature) * (temperature - m.expansion_reference) : 0;
    return (table.value(temperature) + mean_part) / expansion_scale(m);
}

}  // namespace deadpoint
