#include "deadpoint/crankshaft/shaft/element.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"
#include "shafts.hpp"

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>

using namespace deadpoint;
using namespace deadpoint::crankshaft;

namespace {

BeamElement beam_of(const nlohmann::json& entry)
{
    return {entry["L"], entry["D"], 0, shafts::steel_density, 215e9, 0.277, 0.9, entry["P"]};
}

double largest(const Matrix& m)
{
    double value = 0;
    for (const double entry : m.values)
        value = std::max(value, std::abs(entry));
    return value;
}

template <class Expected>
void check_matrix(const Matrix& m, const Expected& expected, double tolerance)
{
    const double scale = largest(m);
    double worst = 0;
    for (int i = 0; i < m.rows; ++i)
        for (int j = 0; j < m.cols; ++j)
            worst = std::max(worst, std::abs(m(i, j) - expected(i, j)));
    CHECK(worst <= tolerance * scale);
}

/// Displacements and rotation angles at xi in 0..1 of a Timoshenko beam bent by its ends alone, per unknown.
struct Shapes {
    std::array<double, 10> v{}, w{}, v_slope{}, w_slope{}, ty{}, tz{}, ty_slope{}, tz_slope{};
};

/// Constant shear and linear moment: v is a cubic, the rotation a quadratic that differs from v' by a constant.
Shapes shapes_at(double xi, double L, double phi)
{
    const double f = 1 / (1 + phi);
    const double x2 = xi * xi;
    const double x3 = x2 * xi;
    const std::array<double, 4> d{f * (1 - 3 * x2 + 2 * x3 + phi * (1 - xi)),
                                  f * L * (xi - 2 * x2 + x3 + 0.5 * phi * (xi - x2)), f * (3 * x2 - 2 * x3 + phi * xi),
                                  f * L * (-x2 + x3 + 0.5 * phi * (x2 - xi))};
    const std::array<double, 4> d_slope{
        f / L * (-6 * xi + 6 * x2 - phi), f * (1 - 4 * xi + 3 * x2 + 0.5 * phi * (1 - 2 * xi)),
        f / L * (6 * xi - 6 * x2 + phi), f * (-2 * xi + 3 * x2 + 0.5 * phi * (2 * xi - 1))};
    const std::array<double, 4> r{f / L * (-6 * xi + 6 * x2), f * (1 - 4 * xi + 3 * x2 + phi * (1 - xi)),
                                  f / L * (6 * xi - 6 * x2), f * (-2 * xi + 3 * x2 + phi * xi)};
    const std::array<double, 4> r_slope{f / (L * L) * (-6 + 12 * xi), f / L * (-4 + 6 * xi - phi),
                                        f / (L * L) * (6 - 12 * xi), f / L * (-2 + 6 * xi + phi)};
    const std::array<std::size_t, 4> in_v{1, 4, 6, 9};
    const std::array<std::size_t, 4> in_w{2, 3, 7, 8};
    Shapes s;
    for (std::size_t i = 0; i < 4; ++i) {
        const double sign = i % 2 == 0 ? 1 : -1;  // ty = -dw/ds
        s.v[in_v[i]] = d[i];
        s.v_slope[in_v[i]] = d_slope[i];
        s.tz[in_v[i]] = r[i];
        s.tz_slope[in_v[i]] = r_slope[i];
        s.w[in_w[i]] = sign * d[i];
        s.w_slope[in_w[i]] = sign * d_slope[i];
        s.ty[in_w[i]] = -sign * r[i];
        s.ty_slope[in_w[i]] = -sign * r_slope[i];
    }
    return s;
}

/// Integral over the element by Gauss's rule of four points, exact for degree 7.
Matrix integral(double L, double phi, const std::function<double(const Shapes&, std::size_t, std::size_t)>& density)
{
    constexpr std::array<double, 4> at{-0.861136311594052575, -0.339981043584856265, 0.339981043584856265,
                                       0.861136311594052575};
    constexpr std::array<double, 4> weight{0.347854845137453857, 0.652145154862546143, 0.652145154862546143,
                                           0.347854845137453857};
    Matrix m(10, 10);
    for (std::size_t p = 0; p < 4; ++p) {
        const Shapes s = shapes_at(0.5 * (1 + at[p]), L, phi);
        for (std::size_t i = 0; i < 10; ++i)
            for (std::size_t j = 0; j < 10; ++j)
                m(static_cast<int>(i), static_cast<int>(j)) += 0.5 * L * weight[p] * density(s, i, j);
    }
    return m;
}

}  // namespace

TEST_CASE("beam element: matrices agree with the reference")
{
    for (const auto& entry : shafts::reference()["elements"]) {
        CAPTURE(entry["L"].get<double>());
        const ElementMatrices m = beam_matrices(beam_of(entry));
        const auto expect = [&](const char* key) {
            return [&entry, key](int i, int j) { return entry[key][i][j].template get<double>(); };
        };
        // The reference evaluates the same formulas; only rounding may differ.
        check_matrix(m.mass_translation, expect("MT"), 1e-14);
        check_matrix(m.mass_rotation, expect("MR"), 1e-14);
        check_matrix(m.gyroscopic, expect("G"), 1e-14);
        check_matrix(m.stiffness, expect("K"), 1e-14);
        check_matrix(m.axial_stiffness, expect("KP"), 1e-14);
    }
}

TEST_CASE("beam element: lateral matrices are the integrals of Timoshenko's shape functions")
{
    const BeamElement beam{0.11, 0.13, 0.04, 7800, 2.1e11, 0.3, 0.87, -3e5};
    const double A = std::numbers::pi / 4 * (0.13 * 0.13 - 0.04 * 0.04);
    const double I = std::numbers::pi / 64 * (std::pow(0.13, 4) - std::pow(0.04, 4));
    const double shear = 0.87 * A * 2.1e11 / 2.6;
    const double phi = 12 * 2.1e11 * I / (shear * 0.11 * 0.11);
    const auto numeric = [&](const auto& density) { return integral(0.11, phi, density); };
    const ElementMatrices m = beam_matrices(beam);
    const auto lateral = [](const Matrix& matrix) {
        Matrix copy = matrix;
        for (int i = 0; i < 10; ++i)
            for (int j = 0; j < 10; ++j)
                if (i % 5 == 0 || j % 5 == 0)
                    copy(i, j) = 0;
        return copy;
    };
    // The rule is exact for these polynomials: rounding only.
    check_matrix(lateral(m.mass_translation), numeric([&](const Shapes& s, std::size_t i, std::size_t j) {
                     return beam.density * A * (s.v[i] * s.v[j] + s.w[i] * s.w[j]);
                 }),
                 1e-14);
    check_matrix(m.mass_rotation, numeric([&](const Shapes& s, std::size_t i, std::size_t j) {
                     return beam.density * I * (s.ty[i] * s.ty[j] + s.tz[i] * s.tz[j]);
                 }),
                 1e-14);
    // Spin momentum omega J of a section tilted by ty, tz: kinetic energy omega J (ty' tz - tz' ty) / 2.
    check_matrix(m.gyroscopic, numeric([&](const Shapes& s, std::size_t i, std::size_t j) {
                     return beam.density * 2 * I * (s.tz[i] * s.ty[j] - s.ty[i] * s.tz[j]);
                 }),
                 1e-14);
    check_matrix(lateral(m.stiffness), numeric([&](const Shapes& s, std::size_t i, std::size_t j) {
                     return beam.youngs_modulus * I * (s.ty_slope[i] * s.ty_slope[j] + s.tz_slope[i] * s.tz_slope[j]) +
                            shear * ((s.v_slope[i] - s.tz[i]) * (s.v_slope[j] - s.tz[j]) +
                                     (s.w_slope[i] + s.ty[i]) * (s.w_slope[j] + s.ty[j]));
                 }),
                 1e-13);
    check_matrix(m.axial_stiffness, numeric([&](const Shapes& s, std::size_t i, std::size_t j) {
                     return beam.axial_load * (s.v_slope[i] * s.v_slope[j] + s.w_slope[i] * s.w_slope[j]);
                 }),
                 1e-14);
}

TEST_CASE("beam element: a rigid motion strains nothing and has the beam's mass")
{
    const BeamElement beam{0.2, 0.1, 0, 7800, 2.1e11, 0.3, 0.9, 1e5};
    const ElementMatrices m = beam_matrices(beam);
    std::array<double, 10> translation{};
    translation[1] = translation[6] = 1;
    std::array<double, 10> rotation{};  // about the first node, in the plane of v
    rotation[4] = rotation[9] = 1;
    rotation[6] = 0.2;
    double mass = 0;
    for (int i = 0; i < 10; ++i) {
        double forces = 0;
        double gyroscopic = 0;
        for (int j = 0; j < 10; ++j) {
            const auto at = static_cast<std::size_t>(j);
            forces += std::abs(m.stiffness(i, j)) > 0 ? m.stiffness(i, j) * (translation[at] + rotation[at]) : 0;
            gyroscopic += m.gyroscopic(i, j) * translation[at];
            mass += translation[static_cast<std::size_t>(i)] * m.mass_translation(i, j) * translation[at];
        }
        CHECK(std::abs(forces) < 1e-13 * largest(m.stiffness));
        CHECK(std::abs(gyroscopic) < 1e-15);
    }
    CHECK(mass == near(7800 * std::numbers::pi / 4 * 0.01 * 0.2, 1e-14));
}

TEST_CASE("beam element: nonsense is refused")
{
    const BeamElement good{0.2, 0.1, 0, 7800, 2.1e11, 0.3, 0.9, 0};
    BeamElement beam = good;
    beam.length = 0;
    CHECK_THROWS_AS(beam_matrices(beam), InputError);
    beam = good;
    beam.bore = 0.1;
    CHECK_THROWS_AS(beam_matrices(beam), InputError);
    beam = good;
    beam.youngs_modulus = std::nan("");
    CHECK_THROWS_AS(beam_matrices(beam), InputError);
}
