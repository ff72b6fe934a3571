/// Requirement: whatever rounding and truncation did to the terms of a small system, they make and lose no heat.
#include "deadpoint/reduce/online/dense_terms.hpp"

#include "deadpoint/error.hpp"
#include "lumps.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <random>

using namespace deadpoint;
using namespace deadpoint::reduce;

namespace {

/// A plate of 12 lumps in a row. A film of 0.3 m2 covers lumps 2 to 7, a joint of 0.2 m2 couples 0 to 3 with 8 to 11.
struct Plate {
    Plate()
    {
        const Eigen::Index n = 12;
        terms.uniform = Eigen::VectorXd::LinSpaced(n, 40, 90);
        terms.solid = Eigen::MatrixXd::Zero(n, n);
        for (int k = 0; k + 1 < n; ++k)
            terms.solid += 3 * (lump(k) - lump(k + 1)) * (lump(k) - lump(k + 1)).transpose();
        auto& layout = terms.geometry.layout;
        layout = {1, 0, 1, 0, 0};
        terms.geometry.interface_area = {0.2};
        terms.geometry.surface_area = {0.3};
        terms.functionals = RowMatrix::Zero(static_cast<Eigen::Index>(layout.count()), n);
        DenseJoint joint;
        joint.aa.factor = joint.bb.factor = joint.between.factor = Eigen::MatrixXd::Zero(n, 4);
        for (int k = 0; k < 4; ++k) {
            joint.aa.factor.col(k) = std::sqrt(0.05) * lump(k);
            joint.bb.factor.col(k) = std::sqrt(0.05) * lump(8 + k);
            joint.between.factor.col(k) = std::sqrt(0.05) * (lump(k) - lump(8 + k));
            add(layout.mean(0, false), 0.25, k);
            add(layout.mean(0, true), 0.25, 8 + k);
        }
        terms.joints = {joint};
        LowRankTerm film{Eigen::MatrixXd::Zero(n, 6)};
        for (int k = 0; k < 6; ++k) {
            film.factor.col(k) = std::sqrt(0.05) * lump(2 + k);
            add(layout.surface(0), 0.05, 2 + k);
        }
        terms.films = {film};
    }
    [[nodiscard]] Eigen::VectorXd lump(int k) const { return Eigen::VectorXd::Unit(12, k) / terms.uniform[k]; }
    void add(std::size_t functional, double value, int k)
    {
        terms.functionals.row(static_cast<Eigen::Index>(functional)) += value * lump(k).transpose();
    }
    [[nodiscard]] Eigen::VectorXd functional(std::size_t index) const
    {
        return terms.functionals.row(static_cast<Eigen::Index>(index)).transpose();
    }
    DenseTerms terms;
};

Eigen::MatrixXd matrix_of(const LowRankTerm& term) { return term.factor * term.factor.transpose(); }

void round_to_floats(Eigen::MatrixXd& matrix) { matrix = matrix.cast<float>().cast<double>().eval(); }

}  // namespace

TEST_CASE("terms that conserve heat already stay the same matrices")
{
    Plate plate;
    const auto given = plate.terms;
    conserve_heat(plate.terms);
    const auto& joint = plate.terms.joints[0];
    CHECK((plate.terms.solid - given.solid).norm() < 1e-15 * given.solid.norm());
    CHECK((matrix_of(joint.aa) - matrix_of(given.joints[0].aa)).norm() < 1e-14 * matrix_of(joint.aa).norm());
    CHECK((matrix_of(joint.bb) - matrix_of(given.joints[0].bb)).norm() < 1e-14 * matrix_of(joint.bb).norm());
    CHECK((matrix_of(joint.between) - matrix_of(given.joints[0].between)).norm() <
          1e-14 * matrix_of(joint.between).norm());
    CHECK((matrix_of(plate.terms.films[0]) - matrix_of(given.films[0])).norm() <
          1e-14 * matrix_of(plate.terms.films[0]).norm());
    CHECK(joint.turning.is_missing());
}

TEST_CASE("numbers of 32 bits and cut columns create no heat")
{
    Plate plate;
    const auto given = plate.terms;
    round_to_floats(plate.terms.solid);
    round_to_floats(plate.terms.joints[0].between.factor);
    round_to_floats(plate.terms.joints[0].aa.factor);
    auto& film = plate.terms.films[0].factor;
    film = film.leftCols(4).eval();
    const auto& uniform = plate.terms.uniform;
    REQUIRE((matrix_of(plate.terms.films[0]) * uniform - plate.functional(4)).norm() >
            0.1 * plate.functional(4).norm());
    REQUIRE((plate.terms.solid * uniform).norm() > 1e-9);
    conserve_heat(plate.terms);
    const auto& joint = plate.terms.joints[0];
    CHECK((plate.terms.solid * uniform).norm() < 1e-14 * given.solid.norm() * uniform.norm());
    CHECK((plate.terms.solid - plate.terms.solid.transpose()).norm() < 1e-14 * given.solid.norm());
    CHECK((joint.between.factor.transpose() * uniform).norm() < 1e-14 * joint.between.factor.norm() * uniform.norm());
    // What a mean gives off, at a uniform temperature and at any other.
    const auto& layout = plate.terms.geometry.layout;
    const Eigen::VectorXd any = uniform.cwiseProduct(Eigen::VectorXd::LinSpaced(12, 290, 330));
    const auto gives = [&](const LowRankTerm& term, const Eigen::VectorXd& integral) {
        CHECK((matrix_of(term) * uniform - integral).norm() < 1e-13 * integral.norm());
        CHECK(uniform.dot(matrix_of(term) * any) == near(integral.dot(any), 1e-13));
    };
    gives(joint.aa, 0.2 * plate.functional(layout.mean(0, false)));
    gives(joint.bb, 0.2 * plate.functional(layout.mean(0, true)));
    gives(plate.terms.films[0], plate.functional(layout.surface(0)));
    CHECK((matrix_of(joint.aa) - matrix_of(given.joints[0].aa)).norm() < 1e-6 * matrix_of(joint.aa).norm());
}

TEST_CASE("columns after the first hold what differs from the mean: the variance over the surface is theirs")
{
    Plate plate;
    conserve_heat(plate.terms);
    Eigen::VectorXd temperatures = Eigen::VectorXd::LinSpaced(12, 0, 11).array().square();
    const Eigen::VectorXd deviations =
        plate.terms.films[0].factor.rightCols(5).transpose() * plate.terms.uniform.cwiseProduct(temperatures);
    const Eigen::VectorXd covered = temperatures.segment(2, 6);
    const double variance = (covered.array() - covered.mean()).square().mean();
    CHECK(deviations.squaredNorm() / 0.3 == near(variance, 1e-12));
}

TEST_CASE("terms of other states are refused by name")
{
    Plate plate;
    const auto given = plate.terms;
    const auto refused = [&](const char* message) {
        CHECK_THROWS_WITH_AS(conserve_heat(plate.terms), doctest::Contains(message), InputError);
        plate.terms = given;
    };
    plate.terms.joints[0].between.factor = plate.terms.joints[0].aa.factor;
    refused("interface 0 conducts heat at a uniform temperature");
    plate.terms.solid(3, 3) += 0.01;
    refused("the solid of a dense system conducts heat at a uniform temperature");
    plate.terms.films[0].factor.setZero();
    refused("surface 0 of a dense system has an area but no mean");
    plate.terms.films[0].factor.conservativeResize(11, 6);
    refused("differ in size");
    plate.terms.joints[0].bb = {};
    refused("differ in size");
    plate.terms.uniform.setZero();
    refused("differ in size");
}
