#include "deadpoint/crankshaft/shaft/element.hpp"

#include "deadpoint/error.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::crankshaft {
namespace {

// Places of the unknowns within the element.
constexpr int u1 = 0, v1 = 1, w1 = 2, y1 = 3, z1 = 4, u2 = 5, v2 = 6, w2 = 7, y2 = 8, z2 = 9;

void require(bool holds, const char* what, double value)
{
    if (!holds || !std::isfinite(value))
        throw InputError(fmt::format("beam element: {} is {}", what, value));
}

void check(const BeamElement& beam)
{
    require(beam.length > 0, "the length must be positive, it", beam.length);
    require(beam.diameter > 0, "the diameter must be positive, it", beam.diameter);
    require(beam.bore >= 0 && beam.bore < beam.diameter, "the bore must lie between zero and the diameter, it",
            beam.bore);
    require(beam.density >= 0, "the density must not be negative, it", beam.density);
    require(beam.youngs_modulus > 0, "Young's modulus must be positive, it", beam.youngs_modulus);
    require(beam.poissons_ratio > -1 && beam.poissons_ratio <= 0.5, "Poisson's ratio must lie in -1..0.5, it",
            beam.poissons_ratio);
    require(beam.shear_factor >= 0, "the shear factor must not be negative, it", beam.shear_factor);
    require(true, "the axial load must be finite, it", beam.axial_load);
}

void set(Matrix& matrix, int row, int col, double value) { matrix(row, col) = matrix(col, row) = value; }
void set_skew(Matrix& matrix, int row, int col, double value)
{
    matrix(row, col) = value;
    matrix(col, row) = -value;
}

/// Entries of bending in one plane: displacement and slope d1, r1, d2, r2 at the two nodes.
struct BendingEntries {
    double d1_d1, d1_r1, d1_d2, d1_r2, r1_r1, r1_r2;
};

/// Writes the symmetric matrix of bending in both planes; in the (w, ty) plane the rotation has the other sign.
void set_bending(Matrix& matrix, const BendingEntries& e)
{
    const auto plane = [&](int d1, int r1, int d2, int r2, double sign) {
        set(matrix, d1, d1, e.d1_d1);
        set(matrix, d2, d2, e.d1_d1);
        set(matrix, d1, d2, e.d1_d2);
        set(matrix, d1, r1, sign * e.d1_r1);
        set(matrix, d2, r2, -sign * e.d1_r1);
        set(matrix, d1, r2, sign * e.d1_r2);
        set(matrix, r1, d2, -sign * e.d1_r2);
        set(matrix, r1, r1, e.r1_r1);
        set(matrix, r2, r2, e.r1_r1);
        set(matrix, r1, r2, e.r1_r2);
    };
    plane(v1, z1, v2, z2, 1.0);
    plane(w1, y1, w2, y2, -1.0);
}

void scale(Matrix& matrix, double factor)
{
    for (double& value : matrix.values)
        value *= factor;
}

/// The symbols of Eq. 15.
struct Symbols {
    double A, I, L, P;  ///< area, second moment of area, length, shear number Phi
    double spread;      ///< (1 + Phi)^2

    explicit Symbols(const BeamElement& b)
        : A(std::numbers::pi / 4 * (b.diameter * b.diameter - b.bore * b.bore)),
          I(std::numbers::pi / 64 * (std::pow(b.diameter, 4) - std::pow(b.bore, 4))), L(b.length)
    {
        const double shear_modulus = b.youngs_modulus / (2 * (1 + b.poissons_ratio));
        P = b.shear_factor == 0 ? 0 : 12 * b.youngs_modulus * I / (b.shear_factor * A * shear_modulus * L * L);
        spread = (1 + P) * (1 + P);
    }
};

Matrix translation(const Symbols& s, double density)
{
    const auto& [A, I, L, P, spread] = s;
    Matrix m(10, 10);
    set_bending(m, {156 + 294 * P + 140 * P * P, (22 + 38.5 * P + 17.5 * P * P) * L, 54 + 126 * P + 70 * P * P,
                    -(13 + 31.5 * P + 17.5 * P * P) * L, (4 + 7 * P + 3.5 * P * P) * L * L,
                    -(3 + 7 * P + 3.5 * P * P) * L * L});
    set(m, u1, u1, 140 * spread);
    set(m, u2, u2, 140 * spread);
    set(m, u1, u2, 70 * spread);
    scale(m, density * A * L / (420 * spread));
    return m;
}

Matrix rotation(const Symbols& s, double density)
{
    const auto& [A, I, L, P, spread] = s;
    Matrix m(10, 10);
    set_bending(m, {36, (3 - 15 * P) * L, -36, (3 - 15 * P) * L, (4 + 5 * P + 10 * P * P) * L * L,
                    (-1 - 5 * P + 5 * P * P) * L * L});
    scale(m, density * I / (30 * L * spread));
    return m;
}

/// Couples the planes: G = J / I of the rotary inertia between a rotation in one plane and that in the other.
Matrix gyroscopic(const Symbols& s, double density)
{
    const auto& [A, I, L, P, spread] = s;
    const double m7 = (3 - 15 * P) * L;
    const double m8 = (4 + 5 * P + 10 * P * P) * L * L;
    const double m9 = (-1 - 5 * P + 5 * P * P) * L * L;
    Matrix g(10, 10);
    set_skew(g, w1, v1, 36);
    set_skew(g, y1, v1, -m7);
    set_skew(g, z1, w1, -m7);
    set_skew(g, z1, y1, m8);
    set_skew(g, v2, w1, 36);
    set_skew(g, v2, y1, -m7);
    set_skew(g, w2, v1, -36);
    set_skew(g, w2, z1, -m7);
    set_skew(g, w2, v2, 36);
    set_skew(g, y2, v1, -m7);
    set_skew(g, y2, z1, -m9);
    set_skew(g, y2, v2, m7);
    set_skew(g, z2, w1, -m7);
    set_skew(g, z2, y1, m9);
    set_skew(g, z2, w2, m7);
    set_skew(g, z2, y2, m8);
    scale(g, density * 2 * I / (30 * L * spread));
    return g;
}

Matrix stiffness(const Symbols& s, double youngs_modulus)
{
    const auto& [A, I, L, P, spread] = s;
    Matrix k(10, 10);
    set_bending(k, {12, 6 * L, -12, 6 * L, (4 + P) * L * L, (2 - P) * L * L});
    const double along = A * (1 + P) * L * L / I;
    set(k, u1, u1, along);
    set(k, u2, u2, along);
    set(k, u1, u2, -along);
    scale(k, youngs_modulus * I / ((1 + P) * L * L * L));
    return k;
}

Matrix axial_stiffness(const Symbols& s, double axial_load)
{
    const auto& [A, I, L, P, spread] = s;
    Matrix k(10, 10);
    set_bending(k, {36 + 60 * P + 30 * P * P, 3 * L, -(36 + 60 * P + 30 * P * P), 3 * L,
                    (4 + 5 * P + 2.5 * P * P) * L * L, -(1 + 5 * P + 2.5 * P * P) * L * L});
    scale(k, axial_load / (30 * L * spread));
    return k;
}

}  // namespace

ElementMatrices beam_matrices(const BeamElement& beam)
{
    check(beam);
    const Symbols symbols(beam);
    return {translation(symbols, beam.density), rotation(symbols, beam.density), gyroscopic(symbols, beam.density),
            stiffness(symbols, beam.youngs_modulus), axial_stiffness(symbols, beam.axial_load)};
}

}  // namespace deadpoint::crankshaft
