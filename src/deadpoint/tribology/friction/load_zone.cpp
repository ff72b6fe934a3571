#include "deadpoint/tribology/friction/load_zone.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/root.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace deadpoint::tribology {
namespace {

constexpr int quadrature_points = 32;

struct Quadrature {
    std::array<double, quadrature_points> node{};    // in 0 .. 1
    std::array<double, quadrature_points> weight{};  // sums to 1
};

/// Gauss-Legendre points by Newton's method on the Legendre polynomial.
Quadrature gauss_legendre()
{
    constexpr int n = quadrature_points;
    Quadrature rule;
    for (std::size_t i = 0; i < n; ++i) {
        double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (n + 0.5));
        double slope = 0;
        for (int step = 0; step < 20; ++step) {
            double previous = 1;
            double value = x;
            for (int k = 2; k <= n; ++k) {
                const double next = ((2 * k - 1) * x * value - (k - 1) * previous) / k;
                previous = value;
                value = next;
            }
            slope = n * (x * value - previous) / (x * x - 1);
            x -= value / slope;
        }
        rule.node[i] = (1 - x) / 2;
        rule.weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
    return rule;
}

void check(const RollingRow& row, double radial)
{
    if (row.elements < 1)
        throw InputError(fmt::format("rolling row: {} rolling elements; give their number", row.elements));
    require_positive("stiffness of a rolling element", row.stiffness);
    require_positive("exponent of a rolling element's stiffness", row.exponent);
    require_not_negative("radial force of a rolling row [N]", radial);
    if (!(row.contact_angle >= 0) || row.contact_angle >= std::numbers::pi / 2)
        throw InputError(fmt::format("rolling row: contact angle {} rad is outside 0 .. pi/2", row.contact_angle));
}

/// An approach at which the row carries at least this radial force.
double ample_radial(const RollingRow& row, double force, double base)
{
    double radial = std::abs(base) + std::pow(force / (row.elements * row.stiffness), 1 / row.exponent);
    while (radial_force(row, {base, radial}) < force)
        radial *= 2;
    return radial;
}

}  // namespace

double mean_approach(const RowApproach& approach, double exponent, int harmonic)
{
    static const Quadrature rule = gauss_legendre();
    const auto [base, radial] = approach;
    if (base + radial <= 0)
        return 0;
    const double end = base >= radial ? std::numbers::pi : std::acos(-base / radial);  // end of the load zone
    double sum = 0;
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
        const double t = rule.node[i] * std::numbers::pi / 2;  // psi = end sin t: smooth at the end of the zone
        const double psi = end * std::sin(t);
        const double value = base + radial * std::cos(psi);
        if (value > 0)
            sum += rule.weight[i] * std::pow(value, exponent) * (harmonic == 1 ? std::cos(psi) : 1) * std::cos(t);
    }
    return sum * end / 2;  // dpsi = end cos t (pi/2) dnode, over 0 .. pi as half the ring
}

double radial_integral(double zone, double exponent)
{
    require_positive("load zone", zone);
    require_positive("exponent of the load zone", exponent);
    return mean_approach({1 - 1 / (2 * zone), 1 / (2 * zone)}, exponent, 1);
}

double axial_integral(double zone, double exponent)
{
    require_positive("load zone", zone);
    require_positive("exponent of the load zone", exponent);
    return mean_approach({1 - 1 / (2 * zone), 1 / (2 * zone)}, exponent, 0);
}

double element_load(const RollingRow& row, const RowApproach& approach, double psi)
{
    const double value = approach.base + approach.radial * std::cos(psi);
    return value > 0 ? row.stiffness * std::pow(value, row.exponent) : 0;
}

double largest_load(const RollingRow& row, const RowApproach& approach) { return element_load(row, approach, 0); }

double summed_load(const RollingRow& row, const RowApproach& approach, double power)
{
    return row.elements * std::pow(row.stiffness, power) * mean_approach(approach, power * row.exponent, 0);
}

double radial_force(const RollingRow& row, const RowApproach& approach)
{
    return row.elements * row.stiffness * mean_approach(approach, row.exponent, 1) * std::cos(row.contact_angle);
}

double axial_force(const RollingRow& row, const RowApproach& approach)
{
    return summed_load(row, approach, 1) * std::sin(row.contact_angle);
}

RowApproach spread_radial(const RollingRow& row, double force, double base)
{
    check(row, force);
    if (force == 0)
        return {base, 0};
    const double high = ample_radial(row, force, base);
    const auto excess = [&](double radial) { return radial_force(row, {base, radial}) - force; };
    return {base, increasing_root(excess, 0, high)};
}

RowApproach spread_single(const RollingRow& row, double radial, double axial)
{
    check(row, radial);
    require_not_negative("axial force of a single rolling row [N]", axial);
    if (row.contact_angle == 0) {
        if (axial > 0)
            throw InputError(
                "rolling row: an axial force needs a contact angle\n  help: state the angle under that force");
        return spread_radial(row, radial, 0);
    }
    const double tangent = std::tan(row.contact_angle);
    if (radial == 0)
        return {std::pow(axial / (row.elements * row.stiffness * std::sin(row.contact_angle)), 1 / row.exponent), 0};

    // Shape of the zone from the ratio of the forces (radial approach 1, base 0 or more), then its size.
    const auto shortfall = [&](double base) {
        const RowApproach unit{base, 1};
        return axial / radial - tangent * mean_approach(unit, row.exponent, 0) / mean_approach(unit, row.exponent, 1);
    };
    double base = 0;
    if (shortfall(0) > 0) {
        double high = 1;
        while (shortfall(high) > 0)
            high *= 2;
        base = increasing_root([&](double x) { return -shortfall(x); }, 0, high);
    }
    const double size = std::pow(radial / radial_force(row, {base, 1}), 1 / row.exponent);
    return {base * size, size};
}

std::vector<RowApproach> spread_pair(const RollingRow& row, double radial, double axial, double base)
{
    check(row, radial);
    if (!std::isfinite(axial) || !std::isfinite(base))
        throw InputError(
            fmt::format("pair of rolling rows: axial force {} N or approach {} m is no number", axial, base));
    if (axial == 0) {
        const RowApproach each = spread_radial(row, radial / 2, base);
        return {each, each};
    }
    if (row.contact_angle == 0)
        throw InputError("pair of rolling rows: an axial force needs a contact angle\n  help: state the angle");

    // At a given axial shift, the radial force gives the common radial approach; the axial force gives the shift.
    const auto rows_at = [&](double shift) {
        RowApproach first{base + shift, 0};
        RowApproach second{base - shift, 0};
        if (radial > 0) {
            const auto excess = [&](double r) {
                return radial_force(row, {first.base, r}) + radial_force(row, {second.base, r}) - radial;
            };
            double high =
                std::abs(base) + std::abs(shift) + std::pow(radial / (row.elements * row.stiffness), 1 / row.exponent);
            while (excess(high) < 0)
                high *= 2;
            first.radial = second.radial = increasing_root(excess, 0, high);
        }
        return std::vector<RowApproach>{first, second};
    };
    const auto excess = [&](double shift) {
        const auto rows = rows_at(shift);
        return axial_force(row, rows[0]) - axial_force(row, rows[1]) - std::abs(axial);
    };
    double high =
        std::pow(std::abs(axial) / (row.elements * row.stiffness * std::sin(row.contact_angle)), 1 / row.exponent) +
        std::abs(base);
    for (int i = 0; i < 60 && excess(high) < 0; ++i)
        high *= 2;
    if (!(excess(high) >= 0))
        throw ConvergenceError(
            fmt::format("pair of rolling rows: no equilibrium under {} N radial and {} N axial\n  help: "
                        "check contact angle and preload",
                        radial, axial));
    auto rows = rows_at(increasing_root(excess, 0, high));
    if (axial < 0)
        std::swap(rows[0], rows[1]);
    return rows;
}

}  // namespace deadpoint::tribology
