/// Requirement: the air of enclosures, eliminated from a stage's equations, is what the equations with it would give.
#include "deadpoint/heat/enclosed_air.hpp"

#include "lumps.hpp"
#include "near.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <memory>

using namespace deadpoint;
using namespace deadpoint::heat;

namespace {

using Air = EnclosedAir<lumps::DenseSystem>;

/// Three lumps, two enclosures: air 0 touches lumps 0 and 1, air 1 lumps 1 and 2.
struct TwoRooms {
    TwoRooms()
    {
        problem.enclosures = {{"cabin", 3000, 4, 295}, {"pit", 800, 0, 310}};
        problem.segments = {lumps::segment(problem, 1000, 290)};
        system = std::make_unique<lumps::DenseSystem>(lumps::terms_of({{1, 1, 1}, {{0, 1, 5}}, {}, {}, {}}, problem),
                                                      problem);
        air = std::make_unique<Air>(problem.enclosures, *system);
        air->start_from({295, 310});
        air->load(0) = Eigen::Vector3d(20, 9, 0);
        air->load(1) = Eigen::Vector3d(0, 6, 12);
        for (const std::size_t k : {0, 1})
            air->complete_load(k, factor);
    }
    static constexpr double factor = 40;
    HeatProblem problem;
    std::unique_ptr<lumps::DenseSystem> system;
    std::unique_ptr<Air> air;
};

}  // namespace

TEST_CASE("a stage with its air eliminated has the solution of the stage with the air in it")
{
    TwoRooms at;
    Eigen::Matrix3d a;
    a << 9e4, -3e3, 1e3, -3e3, 8e4, -2e3, 1e3, -2e3, 7e4;
    const Eigen::Vector3d residual(5e3, -2e3, 700);
    const std::vector<double> of_air{900, -1500};
    // Whole system, as in the class's comment.
    Eigen::Matrix<double, 5, 5> whole = Eigen::Matrix<double, 5, 5>::Zero();
    whole.topLeftCorner<3, 3>() = a;
    const double f = TwoRooms::factor;
    whole.block<3, 1>(0, 3) = -f * at.air->load(0);
    whole.block<3, 1>(0, 4) = -f * at.air->load(1);
    whole.bottomLeftCorner<2, 3>() = whole.topRightCorner<3, 2>().transpose();
    whole(3, 3) = 3000 + f * (29 + 4);
    whole(4, 4) = 800 + f * 18;
    Eigen::Matrix<double, 5, 1> right;
    right << residual, 900, -1500;
    const Eigen::Matrix<double, 5, 1> expected = whole.partialPivLu().solve(right);

    std::vector<RankOne<Eigen::VectorXd>> terms;
    at.air->add_terms(terms);
    REQUIRE(terms.size() == 2);
    Eigen::MatrixXd reduced = a;
    for (const auto& [coefficient, load] : terms)
        reduced -= coefficient * *load * load->transpose();
    Eigen::VectorXd field_right = residual;
    at.air->eliminate(of_air, field_right);
    const Eigen::VectorXd field = reduced.partialPivLu().solve(field_right);
    CHECK((field - expected.head<3>()).norm() < 1e-13 * expected.norm());
    const auto solution = at.air->solution(of_air, field);
    CHECK(solution[0] == near(expected[3], 1e-12));
    CHECK(solution[1] == near(expected[4], 1e-12));
    CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(reduced).eigenvalues()[0] > 0);
    CHECK(at.air->update(of_air, field) == near(std::max(std::abs(expected[3]), std::abs(expected[4])), 1e-12));
    CHECK(at.air->temperatures()[0] == near(295 - expected[3], 1e-13));
    CHECK(at.air->at_start() == std::vector<double>{295, 310});  // until the step is accepted
}

TEST_CASE("with conduction from the same films the reduced matrix stays positive, for any stage length")
{
    for (const double f : {1e-3, 1.0, 1e3, 1e7}) {
        TwoRooms at;
        for (const std::size_t k : {0, 1})
            at.air->complete_load(k, f);
        // Films of 20, 9 + 6 and 12 W/K on the diagonal, tiny capacities: the worst case.
        Eigen::MatrixXd reduced = (Eigen::Vector3d::Constant(1e-6) + f * Eigen::Vector3d(20, 15, 12)).asDiagonal();
        std::vector<RankOne<Eigen::VectorXd>> terms;
        at.air->add_terms(terms);
        for (const auto& [coefficient, load] : terms)
            reduced -= coefficient * *load * load->transpose();
        CAPTURE(f);
        CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(reduced).eigenvalues()[0] > 0);
    }
}

TEST_CASE("the air of a closed room alone goes through a step as TR-BDF2 does")
{
    // C T' = -G (T - T_room), nothing else: both stages are solved by one update each.
    TwoRooms at;
    const double dt = 300, f = diagonal * dt;
    for (const std::size_t k : {0, 1}) {
        at.air->load(k).setZero();
        at.air->complete_load(k, f);
    }
    const auto balance_of = [&] {
        HeatBalance balance;
        for (std::size_t k = 0; k < 2; ++k) {
            AirFlow flow;
            flow.temperature = at.air->temperatures()[k];
            flow.to_room = at.problem.enclosures[k].exchange * (flow.temperature - 290);
            balance.air.push_back(flow);
        }
        return balance;
    };
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(3);
    const auto start = balance_of();
    at.air->begin_first_stage(dt, false, start);
    at.air->update(at.air->residual(balance_of()), nothing);
    const double middle = at.air->temperatures()[0];
    CHECK(std::abs(at.air->residual(balance_of())[0]) < 1e-9);  // of 9e5 J: straight, so one update solves it
    at.air->begin_second_stage();
    at.air->update(at.air->residual(balance_of()), nothing);
    const double z = -4.0 / 3000 * dt;
    const double of_middle = (1 + diagonal * z) / (1 - diagonal * z);
    const double of_end = (bdf_middle * of_middle - bdf_now) / (1 - diagonal * z);
    CHECK(middle - 290 == near(5 * of_middle, 1e-12));
    CHECK(at.air->temperatures()[0] - 290 == near(5 * of_end, 1e-12));
    CHECK(at.air->temperatures()[1] == near(310, 1e-14));  // exchanges with nobody

    const double end = at.air->temperatures()[0];
    CHECK(at.air->accept(dt) == near(3000 * (end - 295), 1e-10));
    const auto state = at.air->states()[0];
    CHECK(state.start == end);
    CHECK(state.slope == near(-4.0 / 3000 * (end - 290), 1e-10));  // the stage's own formula
}

TEST_CASE("a first guess goes along the slope where it is known, and stays where it is not")
{
    TwoRooms at;
    HeatBalance balance;
    balance.air.resize(2);
    at.air->set_states({{295, 0.02, 295}, {310, -0.01, 310}});
    at.air->begin_first_stage(100, false, balance);
    CHECK(at.air->temperatures() == std::vector<double>{295, 310});
    at.air->begin_first_stage(100, true, balance);
    CHECK(at.air->temperatures()[0] == near(295 + gamma_stage * 2, 1e-15));
    CHECK(at.air->temperatures()[1] == near(310 - gamma_stage * 1, 1e-15));
    // The second guess goes straight through the first stage.
    at.air->begin_second_stage();
    CHECK(at.air->temperatures()[0] == near(297, 1e-15));
}

TEST_CASE("states come back as they were given")
{
    TwoRooms at;
    at.air->set_states({{301, 0.5, 302}, {303, -0.25, 304}});
    CHECK(at.air->at_start() == std::vector<double>{301, 303});
    CHECK(at.air->temperatures() == std::vector<double>{302, 304});
    CHECK(at.air->states()[1].slope == -0.25);
    at.air->start_from({290, 291});
    CHECK(at.air->temperatures() == std::vector<double>{290, 291});
    CHECK(at.air->count() == 2);
    CHECK_THROWS(at.air->start_from({290}));
}

TEST_CASE("the residual of a first step's error estimate is that of the heat kept at its three times")
{
    TwoRooms at;
    std::array<HeatBalance, 3> stages;
    const std::array<double, 3> kept{100, 60, 45};
    for (std::size_t i = 0; i < 3; ++i) {
        stages[i].air.resize(2);
        stages[i].air[0].from_surfaces = kept[i];
        stages[i].air[1].from_surfaces = 7;
        stages[i].air[1].power = 10;
        stages[i].air[1].to_room = 5;
    }
    const auto result = at.air->first_error(50, {&stages[0], &stages[1], &stages[2]});
    CHECK(result[0] == near(step_error(50, 100, 60, 45), 1e-13));
    CHECK(std::abs(result[1]) < 1e-12);  // even heat has no error
}
