#include "deadpoint/crankshaft/modes.hpp"

#include "deadpoint/crankshaft/shaft/eigen_views.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"
#include "shafts.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::crankshaft;
using shafts::reference;
using shafts::rpm;

namespace {

void check_frequencies(const std::vector<Mode>& found, const nlohmann::json& expected, double tolerance)
{
    REQUIRE(found.size() >= expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i);
        CHECK(found[i].frequency == near(expected[i].get<double>(), tolerance));
    }
}

std::vector<Mode> modes_of(const Shaft& shaft, double speed, int count = 10)
{
    return modes(assemble(shaft), speed, count);
}

/// One lateral plane's frequencies at rest: every second of the pairs.
double plane_frequency(const Shaft& shaft, int number) { return modes_of(shaft, 0)[2 * number].frequency; }

}  // namespace

TEST_CASE("modes: the paper's shaft, three readings of its table, four stiffnesses, four speeds")
{
    for (const auto& entry : reference()["frequencies"]) {
        CAPTURE(entry["variant"].get<std::string>());
        CAPTURE(entry["k"].get<double>());
        CAPTURE(entry["rpm"].get<double>());
        const Shaft shaft = shafts::table1(entry["variant"], entry["k"]);
        // The reference's own pairs, equal by symmetry, differ by 1e-12; both codes are independent solvers.
        check_frequencies(modes_of(shaft, entry["rpm"].get<double>() * rpm), entry["f_Hz"], 1e-9);
    }
}

TEST_CASE("modes: the paper's shaft in elastic housings")
{
    const auto& entry = reference()["frequencies_housing"];
    Shaft shaft = shafts::table1(entry["variant"], entry["k_b2"]);
    for (Bearing& bearing : shaft.bearings) {
        bearing.housing_mass = entry["housing_mass"];
        bearing.support_stiffness = shafts::isotropic(entry["k_b1"]);
    }
    check_frequencies(modes_of(shaft, entry["rpm"].get<double>() * rpm), entry["f_Hz"], 1e-9);
    CHECK(assemble(shaft).size() == 4 * 19 + 2 * 4);
}

TEST_CASE("modes: pinned beam against the exact Timoshenko beam, order h^2")
{
    const auto& beam = reference()["checks"]["ss_timoshenko"];
    double last_error = 0;
    for (const int elements : {4, 8, 16, 32}) {
        CAPTURE(elements);
        const Shaft shaft = shafts::pinned_beam(elements);
        const auto& expected = beam["fe_Hz"][std::to_string(elements)];
        for (int i = 0; i < 4; ++i)
            CHECK(plane_frequency(shaft, i) == near(expected[i].get<double>(), 1e-9));
        const double error = plane_frequency(shaft, 1) / beam["exact_Hz"][1].get<double>() - 1;
        if (elements > 8)  // four elements for two half waves are too coarse for the order
            CHECK(std::log2(last_error / error) == near(2, 0.1));
        last_error = error;
    }
    CHECK(last_error < 1.1e-4);
}

TEST_CASE("modes: tension raises the pinned beam's frequencies")
{
    const auto& expected = reference()["checks"]["ss_axial_P_2MN"];
    Shaft shaft = shafts::pinned_beam(32);
    shaft.axial_load = 2e6;
    for (int i = 0; i < 2; ++i) {
        CHECK(plane_frequency(shaft, i) == near(expected["fe32"][i].get<double>(), 1e-9));
        CHECK(plane_frequency(shaft, i) == near(expected["exact"][i].get<double>(), 1.1e-4));
    }
}

TEST_CASE("modes: the pinned beam buckles at Engesser's load and says so")
{
    const auto& expected = reference()["checks"]["buckling"];
    double stable = 0;
    double buckled = 2e7;
    for (int i = 0; i < 50; ++i) {
        Shaft shaft = shafts::pinned_beam(32);
        const double middle = 0.5 * (stable + buckled);
        shaft.axial_load = -middle;
        try {
            modes_of(shaft, 0, 1);
            stable = middle;
        } catch (const InputError& error) {
            CHECK(std::string(error.what()).find("buckles") != std::string::npos);
            buckled = middle;
        }
    }
    CHECK(stable == near(expected["fe"].get<double>(), 1e-7));
    CHECK(stable == near(expected["engesser"].get<double>(), 2e-5));  // the mesh's error
}

TEST_CASE("modes: whirl of the spinning pinned beam, and its sense")
{
    const auto& expected = reference()["checks"]["ss_whirl_2000rad/s"];
    const std::vector<Mode> found = modes_of(shafts::pinned_beam(32), 2000, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(found[i].frequency == near(expected["fe32"][i / 2][i % 2].get<double>(), 1e-9));
        CHECK(found[i].frequency == near(expected["exact"][i / 2][i % 2].get<double>(), 1.2e-4));
        CHECK(found[i].whirl == (i % 2 == 0 ? Whirl::backward : Whirl::forward));
        CHECK(std::abs(found[i].circularity) == near(1, 1e-6));
    }
    // The other sense of rotation: the same frequencies, each with its sense relative to the spin.
    const std::vector<Mode> reversed = modes_of(shafts::pinned_beam(32), -2000, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        CHECK(reversed[i].frequency == near(found[i].frequency, 1e-10));
        CHECK(reversed[i].whirl == found[i].whirl);
    }
    for (const Mode& mode : modes_of(shafts::pinned_beam(8), 0, 4))
        CHECK(mode.whirl == Whirl::planar);
}

namespace {

/// A disk of 100 kg in the middle of a stiff shaft without mass on two bearings of 1 MN/m, 1 m apart.
Shaft jeffcott()
{
    Shaft shaft = shafts::steel();
    shaft.youngs_modulus = 1e16;  // compliance of the shaft 1e-6 of the bearings'
    shaft.sections = {{1, 0.1, 0, 0}};
    shaft.disks = {{0.5, 100, 1, 1}};
    shaft.bearings = {shafts::bearing("left", 0, 1e6), shafts::bearing("right", 1, 1e6)};
    return shaft;
}

}  // namespace

TEST_CASE("modes: Jeffcott rotor bounces and tilts as in closed form, the shaft without mass")
{
    const std::vector<Mode> found = modes_of(jeffcott(), 1000);
    REQUIRE(found.size() == 4);
    const double bounce = std::sqrt(2 * 1e6 / 100);
    // Id a'' -+ omega Jp a' + 2 k (L/2)^2 a = 0 in complex tilt a = ty + i tz.
    const double tilt = std::sqrt(1000.0 * 1000 + 4 * 5e5) / 2;
    const double expected[]{bounce, bounce, tilt - 500, tilt + 500};
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(2 * std::numbers::pi * found[i].frequency == near(expected[i], 1e-6));
    CHECK(found[2].whirl == Whirl::backward);
    CHECK(found[3].whirl == Whirl::forward);
}

TEST_CASE("modes: Friswell et al., Dynamics of Rotating Machines, example 5.9.1")
{
    const Shaft shaft = shafts::friswell(1e6, 1e6);
    const std::vector<Mode> rest = modes_of(shaft, 0, 6);
    const double at_rest[]{86.658, 86.658, 274.313, 274.313, 716.786, 716.786};
    const std::vector<Mode> spinning = modes_of(shaft, 4000 * rpm, 6);
    const double at_4000[]{85.389, 87.796, 251.785, 294.713, 600.179, 827.075};
    for (std::size_t i = 0; i < 6; ++i) {
        // Printed to three places.
        CHECK(std::abs(2 * std::numbers::pi * rest[i].frequency - at_rest[i]) < 6e-4);
        CHECK(std::abs(2 * std::numbers::pi * spinning[i].frequency - at_4000[i]) < 6e-4);
    }
}

TEST_CASE("modes: the same rotor in anisotropic bearings, test data of ROSS (test_campbell)")
{
    const ShaftSystem system = assemble(shafts::friswell(1e6, 0.8e6));
    const auto table = campbell(system, std::vector<double>{0, 150, 300}, 5);
    const auto& expected = reference()["ross_campbell_test"]["ross_test"];
    for (std::size_t s = 0; s < 3; ++s)
        for (std::size_t i = 0; i < 5; ++i)
            // Printed to 1e-8 rad/s of 82.
            CHECK(2 * std::numbers::pi * table[s][i].frequency == near(expected[s][i].get<double>(), 2e-10));
}

TEST_CASE("critical speeds: where the Campbell diagram meets the line of the speed")
{
    const Shaft shaft = shafts::table1("elemmid", 5e7);
    const ShaftSystem system = assemble(shaft);
    const std::vector<CriticalSpeed> found = critical_speeds(system, 1, 6);
    REQUIRE(found.size() == 6);
    for (const CriticalSpeed& critical : found) {
        CAPTURE(critical.speed);
        double nearest = 1;
        Whirl whirl = Whirl::planar;
        for (const Mode& mode : modes(system, critical.speed, 10)) {
            const double apart = std::abs(mode.frequency * 2 * std::numbers::pi / critical.speed - 1);
            if (apart < nearest) {
                nearest = apart;
                whirl = mode.whirl;
            }
        }
        CHECK(nearest < 1e-10);
        CHECK(critical.whirl == whirl);
        CHECK(critical.whirl != Whirl::planar);
    }
    // Twice per turn: excited at half the frequency.
    const std::vector<CriticalSpeed> twice = critical_speeds(system, 2, 1);
    const double frequency = 2 * twice[0].speed / (2 * std::numbers::pi);
    CHECK(modes(system, twice[0].speed, 1)[0].frequency == near(frequency, 1e-10));
    CHECK_THROWS_AS(critical_speeds(system, 0), InputError);
}

TEST_CASE("critical speeds: those of a uniform pinned beam are near its frequencies, not 1/sqrt(2) of them")
{
    const auto& expected = reference()["checks"]["critical_speed_MC_double_count"];
    const auto found = critical_speeds(assemble(shafts::pinned_beam(16)), 1, 2);
    CHECK(found[0].speed / (2 * std::numbers::pi) == near(expected["correct_Hz"].get<double>(), 0.01));
    CHECK(found[0].whirl == Whirl::backward);
    CHECK(found[1].whirl == Whirl::forward);
}

TEST_CASE("modes: bearing damping shows as damping ratio, and the Campbell table is modes at each speed")
{
    Shaft shaft = jeffcott();
    shaft.sections[0].density = 10;  // dampers need some mass
    shaft.youngs_modulus = 1e13;
    for (Bearing& bearing : shaft.bearings)
        bearing.damping = shafts::isotropic(1e3);
    const auto table = campbell(assemble(shaft), std::vector<double>{0, 100}, 2);
    REQUIRE(table.size() == 2);
    // c / (2 sqrt(k m)) of the bounce; the shaft's compliance is 1e-3 of the bearings'.
    CHECK(table[0][0].damping_ratio == near(2e3 / (2 * std::sqrt(2e6 * 100)), 2e-3));
    CHECK(table[1][0].frequency == near(modes_of(shaft, 100, 2)[0].frequency, 1e-12));
}

TEST_CASE("campbell: a few modes of the resting shaft give what all of them give, at the highest speed too")
{
    Shaft shaft = shafts::table1("elemmid", 5e7);
    std::vector<Section> pieces;
    for (const Section& section : shaft.sections) {
        Section piece = section;
        piece.length /= 3;
        pieces.insert(pieces.end(), 3, piece);
    }
    shaft.sections = pieces;
    const auto compare = [](const Shaft& each) {
        const ShaftSystem system = assemble(each);
        const double highest = 3 * critical_speeds(system, 1, 1).front().speed;
        const std::vector<double> speeds{0, highest / 2, highest};
        const auto table = campbell(system, speeds, 8);
        for (std::size_t s = 0; s < speeds.size(); ++s) {
            const auto full = modes(system, speeds[s], 8);
            REQUIRE(table[s].size() == full.size());
            for (std::size_t i = 0; i < full.size(); ++i) {
                CAPTURE(i);
                // 1e-6 is what is promised; the damping ratio is a part of the same eigenvalue.
                CHECK(table[s][i].frequency == near(full[i].frequency, 1e-6));
                CHECK(std::abs(table[s][i].damping_ratio - full[i].damping_ratio) < 1e-6);
                CHECK(table[s][i].whirl == full[i].whirl);
            }
        }
    };
    REQUIRE(assemble(shaft).size() > 200);  // far more than are kept at first
    compare(shaft);
    for (Bearing& bearing : shaft.bearings) {  // dampers and an oil film couple the modes more than the spin does
        bearing.damping = shafts::isotropic(2e5);
        bearing.stiffness[0][1] = 5e6;
        bearing.stiffness[1][0] = -5e6;
    }
    compare(shaft);
}

namespace {

/// A hollow steel shaft of 300 mm, 30.08 / 7 mm, in ten sections on two bearings at its ends.
Shaft on_springs(double stiffness, double damping = 0)
{
    Shaft shaft;
    shaft.youngs_modulus = 210e9;
    shaft.poissons_ratio = 0.3;
    for (int i = 0; i < 10; ++i)
        shaft.sections.push_back({0.03, 0.03008, 0.007, 7850});
    shaft.bearings = {shafts::bearing("left", 0, stiffness, damping),
                      shafts::bearing("right", 0.3, stiffness, damping)};
    return shaft;
}
constexpr double spring_mass = 7850 * std::numbers::pi / 4 * (0.03008 * 0.03008 - 0.007 * 0.007) * 0.3;

/// Frequencies of a rigid body on springs k at its two ends [Hz]: (2 pi f)^2 is 2 k over its mass, and k L^2 / 2 over
/// its inertia about its middle.
double bounce(double stiffness) { return std::sqrt(2 * stiffness / spring_mass) / (2 * std::numbers::pi); }
double tilt(double stiffness)
{
    const double own = (0.03008 * 0.03008 + 0.007 * 0.007) / 16;  // squared radius of gyration of a section
    return std::sqrt(stiffness * 0.09 / 2 / (spring_mass * (0.09 / 12 + own))) / (2 * std::numbers::pi);
}

/// By Eigen's generalised method on the assembled matrices, which knows nothing of rigid motions [Hz].
std::vector<double> dense_frequencies(const ShaftSystem& system)
{
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(view(system.stiffness), view(system.mass),
                                                                           Eigen::EigenvaluesOnly);
    std::vector<double> result;
    for (const double square : solver.eigenvalues())
        result.push_back(std::sqrt(square) / (2 * std::numbers::pi));
    return result;
}

}  // namespace

TEST_CASE("modes: a shaft on soft springs moves as a rigid body and bends as a free one, however soft they are")
{
    // Ten steps a decade: the method of real matrices does not end at a tenth of such stiffnesses.
    for (double decade = -3; decade < 3.05; decade += 0.1) {
        const double stiffness = std::pow(10, decade);
        CAPTURE(stiffness);
        const auto found = modes_of(on_springs(stiffness), 1e-7, 10);
        REQUIRE(found.size() == 10);
        // The spin splits the tilts by 2e-8, and bending lowers them by a share of k / (12 EI / L^3).
        const double rigid[]{bounce(stiffness), bounce(stiffness), tilt(stiffness), tilt(stiffness)};
        for (std::size_t i = 0; i < 4; ++i)
            CHECK(found[i].frequency == near(rigid[i], 3e-8 * (1 + stiffness)));
        for (const std::size_t i : {4, 5})
            CHECK(found[i].frequency == near(1537.9, 5e-4));  // of ten elements: 3e-4 above, order h^2
    }
}

TEST_CASE("modes: on any stiffness the frequencies are those of the dense matrices, and rise with it")
{
    double before[10]{};
    for (double decade = 2; decade < 15.05; decade += 0.1) {
        const double stiffness = std::pow(10, decade);
        CAPTURE(stiffness);
        const auto system = assemble(on_springs(stiffness));
        const auto found = modes(system, 1e-7, 10);
        const auto expected = dense_frequencies(system);
        REQUIRE(found.size() == 10);
        for (std::size_t i = 0; i < 10; ++i) {
            // The reference's eigenvalues round to 1e-15 of its largest one, (1e8 Hz)^2 and more by the springs.
            if (stiffness < 1e9)
                CHECK(found[i].frequency == near(expected[i], 1e-6, 1e-2 / stiffness * 1e2));
            CHECK(found[i].frequency >= before[i] * (1 - 1e-9));
            before[i] = found[i].frequency;
        }
    }
    CHECK(before[0] == near(modes_of(on_springs(1e14), 0)[0].frequency, 1e-5));  // both are pinned
}

TEST_CASE("modes: they are found with any damping, cross coupling, difference of directions and speed")
{
    for (double decade = -3; decade < 15.05; decade += 0.5)
        for (const double speed : {0.0, 1e-7, 2000.0}) {
            const double stiffness = std::pow(10, decade);
            CAPTURE(stiffness);
            CAPTURE(speed);
            Shaft shaft = on_springs(stiffness, 0.02 * std::sqrt(stiffness * spring_mass));
            CHECK(modes_of(shaft, speed, 6).size() == 6);
            shaft.bearings[0].stiffness = {{{stiffness, 0.3 * stiffness}, {-0.2 * stiffness, 4 * stiffness}}};
            CHECK(modes_of(shaft, speed, 6).size() == 6);
            shaft.bearings[1].stiffness[1][1] *= 1e-3;
            shaft.bearings[0].damping = shaft.bearings[1].damping = {};
            CHECK(modes_of(shaft, speed, 6).size() == 6);
        }
}

TEST_CASE("soft bearings carry the weight to the last digits")
{
    const auto system = assemble(on_springs(1e-3));
    const auto weight = weight_pattern(system, {0, -9.81});
    for (const auto& force : bearing_forces(system, static_displacement(system, weight)))
        CHECK(force[1] == near(-9.81 * spring_mass / 2, 1e-9));
}
