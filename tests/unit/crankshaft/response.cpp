#include "deadpoint/crankshaft/modes.hpp"
#include "deadpoint/crankshaft/response/harmonic_response.hpp"
#include "deadpoint/crankshaft/response/periodic.hpp"
#include "deadpoint/crankshaft/response/periodic_load.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"
#include "shafts.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::crankshaft;
using shafts::reference;
using shafts::rpm;
using Complex = std::complex<double>;

namespace {

std::vector<double> column(const Matrix& m, int col)
{
    std::vector<double> values;
    for (int row = 0; row < m.rows; ++row)
        values.push_back(m(row, col));
    return values;
}

/// Spring forces on the first two bearings together and on the others together: Bx, By, Ex, Ey.
Readings seat_sums(const ShaftSystem& system)
{
    Readings readings{Matrix(4, system.size()), Matrix(4, system.size())};
    for (std::size_t b = 0; b < system.bearings.size(); ++b)
        for (int i = 0; i < 2; ++i)
            readings.displacement((b < 2 ? 0 : 2) + i, first_unknown(system.bearings[b].node) + i) =
                system.bearings[b].stiffness[0][0];
    return readings;
}

double largest(const Matrix& m)
{
    double value = 0;
    for (const double entry : m.values)
        value = std::max(value, std::abs(entry));
    return value;
}

double largest_difference(const Matrix& a, const Matrix& b)
{
    double value = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
        value = std::max(value, std::abs(a.values[i] - b.values[i]));
    return value;
}

/// A load on the crank of the small shaft that pulses in x and sways in y, with a constant part.
PeriodicLoad small_load(const ShaftSystem& system, int samples)
{
    PeriodicLoad load{0.02, force_pattern(system, 0.2), Matrix(samples, 2)};
    for (int n = 0; n < samples; ++n) {
        const double angle = 2 * std::numbers::pi * n / samples;
        load.histories(n, 0) = 1e4 * std::exp(-8 * (1 - std::cos(angle - 1)));
        load.histories(n, 1) = 500 + 2e3 * std::sin(3 * angle);
    }
    return load;
}

/// Forces of the first bearing and motion of the pulley, also its velocity.
Readings small_readings(const ShaftSystem& system)
{
    Readings readings{Matrix(4, system.size()), Matrix(4, system.size())};
    const int bearing = first_unknown(system.bearings[0].node);
    const int pulley = first_unknown(node_at(system, 0.5));
    for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j)
            readings.displacement(i, bearing + j) =
                system.bearings[0].stiffness[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
        readings.displacement(2 + i, pulley + i) = 1e8;
        readings.velocity(2 + i, pulley + i) = 1e5;
    }
    return readings;
}

}  // namespace

TEST_CASE("static: the crank's load shares over the bearings, and the sag, as in the reference")
{
    for (const auto& entry : reference()["static"]) {
        CAPTURE(entry["variant"].get<std::string>());
        CAPTURE(entry["k"].get<double>());
        const ShaftSystem system = assemble(shafts::table1(entry["variant"], entry["k"]));
        const Matrix at_crank = force_pattern(system, shafts::crank_middle);
        std::vector<double> load = column(at_crank, 0);
        for (double& value : load)
            value *= -40e3;
        const std::vector<double> q = static_displacement(system, load);
        const std::vector<Vec2> forces = bearing_forces(system, q);
        // Condition of K is 1e6; both are direct solutions.
        for (std::size_t b = 0; b < 4; ++b)
            CHECK(forces[b][0] == near(entry["force_on_bearings_N"][b].get<double>(), 1e-8));
        const auto sag = q[static_cast<std::size_t>(first_unknown(node_at(system, shafts::crank_middle)))];
        CHECK(sag == near(entry["v_node9_m"].get<double>(), 1e-8));
    }
}

TEST_CASE("static: weight, distributed along the sections, as in the reference")
{
    for (const auto& entry : reference()["static"]) {
        const ShaftSystem system = assemble(shafts::table1(entry["variant"], entry["k"]));
        const std::vector<double> weight = weight_pattern(system, {-9.81, 0});
        const std::vector<Vec2> forces = bearing_forces(system, static_displacement(system, weight));
        for (std::size_t b = 0; b < 4; ++b)
            CHECK(forces[b][0] == near(entry["gravity_only_force_on_bearings_N"][b].get<double>(), 1e-8));
    }
}

TEST_CASE("static: a housing that sinks under its own weight takes load off the middle of three bearings")
{
    Shaft shaft = shafts::pinned_beam(4);
    const double k = 2e8, support = 1e8, housing = 300, g = 9.81;
    for (Bearing& end : shaft.bearings)
        end.stiffness = shafts::isotropic(k);
    Bearing middle = shafts::bearing("middle", 0.5, k);
    middle.housing_mass = housing;
    middle.support_stiffness = shafts::isotropic(support);
    shaft.bearings.insert(shaft.bearings.begin() + 1, middle);
    const ShaftSystem system = assemble(shaft);
    const std::vector<Vec2> forces =
        bearing_forces(system, static_displacement(system, weight_pattern(system, {0, -g})));
    // Force method: the beam on its ends sags by 5 w L^4 / 384 EI + w L^2 / 8 ks A G under its weight w, and by
    // F (L^3 / 48 EI + L / 4 ks A G) less with the middle's F; ends and middle give way like springs.
    const double area = std::numbers::pi / 4 * 0.01, w = 7850 * area * g;
    const double EI = 210e9 * std::numbers::pi / 64 * 1e-4, shear = 0.9 * area * 210e9 / 2.6;
    const double sag = 5 * w / (384 * EI) + w / (8 * shear) + 0.5 * w / k - housing * g / support;
    const double give = 1 / (48 * EI) + 1 / (4 * shear) + 0.5 / k + 1 / k + 1 / support;
    const double carried = sag / give;
    CHECK(forces[1][1] == near(-carried, 1e-7));
    CHECK(forces[0][1] == near(-0.5 * (w - carried), 1e-7));
    CHECK(forces[2][1] == near(forces[0][1], 1e-9));
}

TEST_CASE("static: on two bearings housings change nothing for the shaft")
{
    Shaft shaft = shafts::pinned_beam(4);
    for (Bearing& end : shaft.bearings)
        end.stiffness = shafts::isotropic(2e8);
    const auto forces = [](const Shaft& of) {
        const ShaftSystem system = assemble(of);
        return bearing_forces(system, static_displacement(system, weight_pattern(system, {0, -9.81})));
    };
    const auto before = forces(shaft);
    shaft.bearings[0].housing_mass = 300;
    shaft.bearings[0].support_stiffness = shafts::isotropic(1e8);
    const auto after = forces(shaft);
    for (std::size_t b = 0; b < 2; ++b)
        CHECK(after[b][1] == near(before[b][1], 1e-8));
}

TEST_CASE("static: without a shear factor a beam only bends; each section has its own")
{
    const double EI = 210e9 * std::numbers::pi / 64 * 1e-4, area = std::numbers::pi / 4 * 0.01, G = 210e9 / 2.6;
    const auto sag = [](double first_half, double second_half) {
        Shaft shaft = shafts::pinned_beam(4);
        for (Bearing& bearing : shaft.bearings)
            bearing.stiffness = shafts::isotropic(1e16);
        for (std::size_t i = 0; i < 4; ++i)
            shaft.sections[i].shear_factor = i < 2 ? first_half : second_half;
        const ShaftSystem system = assemble(shaft);
        const std::vector<double> load = column(force_pattern(system, 0.5), 1);
        return static_displacement(system, load)[static_cast<std::size_t>(first_unknown(2) + 1)];
    };
    // Half of the force shears each half over L / 2, and the mean of both ends of that is the middle's share.
    CHECK(sag(0, 0) == near(1 / (48 * EI), 1e-7));
    CHECK(sag(0.9, 0) == near(1 / (48 * EI) + 1 / (8 * 0.9 * area * G), 1e-7));
    CHECK(sag(0.9, 0.5) == near(1 / (48 * EI) + 1 / (8 * 0.9 * area * G) + 1 / (8 * 0.5 * area * G), 1e-7));
}

TEST_CASE("static: load in the middle of a pinned beam bends and shears it")
{
    Shaft shaft = shafts::pinned_beam(4);
    for (Bearing& bearing : shaft.bearings)
        bearing.stiffness = shafts::isotropic(1e16);
    const ShaftSystem system = assemble(shaft);
    std::vector<double> load = column(force_pattern(system, 0.5), 1);
    for (double& value : load)
        value *= -1e4;
    const double sag = static_displacement(system, load)[static_cast<std::size_t>(first_unknown(2) + 1)];
    const double EI = 210e9 * std::numbers::pi / 64 * 1e-4;
    const double shear = 0.9 * std::numbers::pi / 4 * 0.01 * 210e9 / 2.6;
    // The elements are exact for end loads; bearings give 1e-8, the solver 1e-9.
    CHECK(sag == near(-1e4 * (1 / (48 * EI) + 1 / (4 * shear)), 1e-7));
    CHECK(sag == near(reference()["checks"]["static_centre"]["closed"].get<double>(), 1e-7));
}

TEST_CASE("static: what gives way below two bearings does not change what they carry")
{
    Shaft shaft = shafts::pinned_beam(4);
    for (Bearing& bearing : shaft.bearings) {
        bearing.stiffness = shafts::isotropic(5e7);
        bearing.housing_mass = 3;
        bearing.support_stiffness = Matrix2{{{2e8, 3e7}, {3e7, 1e8}}};
    }
    const ShaftSystem system = assemble(shaft, std::vector<double>{0.3});
    const Matrix at_load = force_pattern(system, 0.3);
    const std::vector<double> across = column(at_load, 0), along = column(at_load, 1);
    std::vector<double> load(across.size());
    for (std::size_t i = 0; i < load.size(); ++i)
        load[i] = 3000 * across[i] - 2000 * along[i];
    const std::vector<Vec2> forces = bearing_forces(system, static_displacement(system, load));
    for (std::size_t b = 0; b < 2; ++b) {
        const double share = b == 0 ? 0.7 : 0.3;  // by the lever, the beam being 1 m long
        CHECK(forces[b][0] == near(share * 3000, 1e-8));
        CHECK(forces[b][1] == near(share * -2000, 1e-8));
    }
}

TEST_CASE("static: a force spread over the crank keeps sum and moment, and bends as its integral")
{
    const Shaft shaft = shafts::pinned_beam(3);
    const ShaftSystem system = assemble(shaft, std::vector<double>{0.3, 0.5, 0.7});
    const Matrix spread = force_pattern(system, 0.5, 0.4);
    for (int direction = 0; direction < 2; ++direction) {
        const std::vector<double> q = static_displacement(system, column(spread, direction));
        const double sag = q[static_cast<std::size_t>(first_unknown(node_at(system, 0.5)) + direction)];
        // By reciprocity: the mean, over the spread, of the deflection under a unit force in the middle. That curve is
        // a cubic between the nodes, so Simpson's rule on each half with its exact middle values is exact.
        const ShaftSystem fine = assemble(shaft, std::vector<double>{0.3, 0.4, 0.5, 0.6, 0.7});
        const std::vector<double> unit = static_displacement(fine, column(force_pattern(fine, 0.5), direction));
        const auto at = [&](double s) {
            return unit[static_cast<std::size_t>(first_unknown(node_at(fine, s)) + direction)];
        };
        const double mean = (at(0.3) + 4 * at(0.4) + 2 * at(0.5) + 4 * at(0.6) + at(0.7)) / 12;
        CHECK(sag == near(mean, 1e-9));
    }
    CHECK_THROWS_AS(force_pattern(system, 0.5, 0.3), InputError);  // no node at its ends
}

TEST_CASE("harmonic response of the paper's shaft in damped bearings")
{
    for (const auto& entry : reference()["harmonic"]) {
        CAPTURE(entry["variant"].get<std::string>());
        const double damping = entry["c_bearing"];
        const ShaftSystem system = assemble(shafts::table1(entry["variant"], entry["k"], damping));
        const double omega = 2 * std::numbers::pi * entry["freq_Hz"].get<double>();
        std::vector<Complex> force(static_cast<std::size_t>(system.size()));
        const auto crank = static_cast<std::size_t>(first_unknown(node_at(system, shafts::crank_middle)));
        force[crank] = 1000;
        const std::vector<Complex> q = harmonic_response(system, entry["rpm"].get<double>() * rpm, omega, force);
        const auto close = [](Complex value, const nlohmann::json& expected, double scale) {
            return std::abs(value - Complex(expected[0], expected[1])) <= 1e-9 * scale;  // direct solutions
        };
        CHECK(close(q[crank], entry["v9"], std::abs(q[crank])));
        CHECK(close(q[crank + 1], entry["w9"], std::abs(q[crank])));
        for (std::size_t b = 0; b < 4; ++b) {
            const auto at = static_cast<std::size_t>(first_unknown(system.bearings[b].node));
            const Complex k(entry["k"].get<double>(), omega * damping);
            CHECK(close(k * q[at], entry["bearing_force_y"][b], std::abs(k * q[at])));
            CHECK(close(k * q[at + 1], entry["bearing_force_z"][b], std::abs(k * q[at])));
        }
    }
}

TEST_CASE("periodic response: rectangular pulse on the paper's shaft against the reference's exact solution")
{
    for (const auto& entry : reference()["pulse_exact"]) {
        CAPTURE(entry["variant"].get<std::string>());
        ShaftSystem system = assemble(shafts::table1(entry["variant"], entry["k"]));
        for (std::size_t i = 0; i < system.damping.values.size(); ++i)
            system.damping.values[i] = entry["beta"].get<double>() * system.stiffness.values[i];
        const double period = entry["period_s"];
        const double width = entry["tau_s"];
        const double speed = entry["rpm"].get<double>() * rpm;
        // The edges are ramps over two samples, which errs by (omega dt)^2 / 12: extrapolated from two spacings.
        const auto pulse = [&](int samples) {
            PeriodicLoad load{period, Matrix(system.size(), 1), Matrix(samples, 1)};
            load.patterns(first_unknown(node_at(system, shafts::crank_middle)), 0) = -40e3;
            const int edge = static_cast<int>(std::lround(width / period * samples));
            for (int n = 0; n <= edge; ++n)
                load.histories(n, 0) = n == 0 || n == edge ? 0.5 : 1.0;
            return periodic_response(system, speed, load, seat_sums(system));
        };
        const int samples = 30000;
        const Matrix read = pulse(samples);
        const Matrix coarse = pulse(samples / 2);
        const char* names[]{"By", "Bz", "Ey", "Ez"};
        double worst = 0;
        for (int r = 0; r < 4; ++r)
            for (std::size_t i = 0; i < entry["t"].size(); ++i) {
                const int n = static_cast<int>(std::lround(entry["t"][i].get<double>() / period * samples));
                const double value = (4 * read(n, r) - coarse(n / 2, r)) / 3;
                const double error = std::abs(value - entry[names[r]][i].get<double>());
                if (i != 0 && entry["t"][i].get<double>() != width)
                    worst = std::max(worst, error);
                CHECK(error < 4.0);  // at an edge the order of the extrapolation is lost
            }
        CHECK(worst < 0.1);
        for (const int r : {0, 2}) {
            double peak = 0;
            double mean = 0;
            for (int n = 0; n < samples; ++n) {
                peak = std::max(peak, std::abs(read(n, r)));
                mean += read(n, r) / samples;
            }
            const std::string seat = r == 0 ? "By" : "Ey";
            CHECK(peak == near(entry["peak_abs_" + seat].get<double>(), 2e-4));
            CHECK(mean == near(entry["mean_" + seat].get<double>(), 1e-7));
        }
    }
}

TEST_CASE("periodic response: harmonic balance and Newmark agree with the exact solution")
{
    const ShaftSystem system = assemble(shafts::small_shaft(), std::vector<double>{0.2});
    const PeriodicLoad load = small_load(system, 240);
    const Readings readings = small_readings(system);
    const double speed = 2 * std::numbers::pi / load.period;
    const Matrix exact = periodic_response(system, speed, load, readings);
    const double scale = largest(exact);

    PeriodicSettings balance;
    balance.method = PeriodicMethod::harmonic_balance;
    balance.harmonics = 300;
    // The kinks of the load leave a tail in k^-2, the shaft's inertia k^-2 more.
    CHECK(largest_difference(exact, periodic_response(system, speed, load, readings, balance)) < 1e-5 * scale);
    balance.harmonics = 1200;
    CHECK(largest_difference(exact, periodic_response(system, speed, load, readings, balance)) < 2e-7 * scale);

    PeriodicSettings newmark;
    newmark.method = PeriodicMethod::newmark;
    newmark.newmark_repeat = 1e-9;
    double last = 0;
    for (const int steps : {8, 16, 32}) {
        newmark.steps_per_sample = steps;
        const double error =
            largest_difference(exact, periodic_response(system, speed, load, readings, newmark)) / scale;
        if (last > 0)
            CHECK(std::log2(last / error) == near(2, 0.15));
        last = error;
    }
    CHECK(last < 2e-4);
}

TEST_CASE("periodic response: one mode against the closed form of a sine")
{
    // Against harmonic_response at the load's own frequency; the sine is linear between 3000 samples: 4e-7.
    const ShaftSystem system = assemble(shafts::small_shaft(), std::vector<double>{0.2});
    const int samples = 3000;
    PeriodicLoad load{0.01, Matrix(system.size(), 1), Matrix(samples, 1)};
    const int crank = first_unknown(node_at(system, 0.2));
    load.patterns(crank, 0) = 1e4;
    for (int n = 0; n < samples; ++n)
        load.histories(n, 0) = std::cos(4 * std::numbers::pi * n / samples);
    const Readings readings = small_readings(system);
    const Matrix read = periodic_response(system, 300, load, readings);
    std::vector<Complex> force(static_cast<std::size_t>(system.size()));
    force[static_cast<std::size_t>(crank)] = 1e4;
    const double omega = 400 * std::numbers::pi;
    const std::vector<Complex> q = harmonic_response(system, 300, omega, force);
    for (int r = 0; r < 4; ++r) {
        Complex amplitude = 0;
        for (int i = 0; i < system.size(); ++i)
            amplitude += (readings.displacement(r, i) + Complex(0, omega) * readings.velocity(r, i)) *
                         q[static_cast<std::size_t>(i)];
        for (int n = 0; n < samples; n += 100)
            CHECK(std::abs(read(n, r) - std::real(amplitude * std::polar(1.0, omega * 0.01 * n / samples))) <
                  2e-6 * largest(read));
    }
}

TEST_CASE("periodic response: a shaft without mass follows its load")
{
    Shaft shaft = shafts::small_shaft();
    for (Section& section : shaft.sections)
        section.density = 0;
    for (Bearing& bearing : shaft.bearings)
        bearing.damping = {};
    shaft.disks[0] = {0.5, 1e-3, 1e-6, 1e-6};
    const ShaftSystem system = assemble(shaft, std::vector<double>{0.2});
    const PeriodicLoad load = small_load(system, 60);
    Readings readings = small_readings(system);
    readings.velocity = Matrix(4, system.size());
    const Matrix read = periodic_response(system, 100, load, readings);
    for (int n = 0; n < 60; n += 7) {
        std::vector<double> force(static_cast<std::size_t>(system.size()));
        for (int i = 0; i < system.size(); ++i)
            for (int c = 0; c < 2; ++c)
                force[static_cast<std::size_t>(i)] += load.patterns(i, c) * load.histories(n, c);
        const std::vector<double> q = static_displacement(system, force);
        for (int r = 0; r < 4; ++r) {
            double expected = 0;
            for (int i = 0; i < system.size(); ++i)
                expected += readings.displacement(r, i) * q[static_cast<std::size_t>(i)];
            CHECK(std::abs(read(n, r) - expected) < 2e-3 * largest(read));  // the speck of mass at the pulley
        }
    }
    shaft.bearings[0].damping = shafts::isotropic(1e4);
    CHECK_THROWS_AS(periodic_response(assemble(shaft, std::vector<double>{0.2}), 100, load, readings), InputError);
}

TEST_CASE("periodic response: without damping, or growing, it is refused with the remedy")
{
    Shaft shaft = shafts::small_shaft();
    shaft.modal_damping = 0;
    for (Bearing& bearing : shaft.bearings)
        bearing.damping = {};
    const std::vector<double> crank{0.2};
    ShaftSystem system = assemble(shaft, crank);
    const PeriodicLoad load = small_load(system, 30);
    try {
        periodic_response(system, 100, load, small_readings(system));
        FAIL("an undamped shaft was accepted");
    } catch (const InputError& error) {
        CHECK(std::string(error.what()).find("give a modal damping ratio") != std::string::npos);
    }
    shaft.modal_damping = 1e-4;
    shaft.bearings[0].stiffness = {{{2e8, 1.5e8}, {-1.5e8, 2e8}}};  // an oil film that whips
    system = assemble(shaft, crank);
    CHECK_THROWS_AS(periodic_response(system, 100, load, small_readings(system)), DomainError);
    PeriodicLoad broken = load;
    broken.histories(3, 1) = std::nan("");
    CHECK_THROWS_AS(periodic_response(system, 100, broken, small_readings(system)), DomainError);
}

TEST_CASE("unbalance: a stiff rotor runs at e x^2 / (1 - x^2)")
{
    Shaft shaft = shafts::steel();
    shaft.youngs_modulus = 1e16;  // compliance of the shaft 1e-6 of the bearings'
    shaft.sections = {{0.5, 0.1, 0, 0}, {0.5, 0.1, 0, 0}};
    const double angle = 0.7;
    shaft.disks = {{0.5, 100, 1, 1, 100 * 1e-4, angle}};
    shaft.bearings = {shafts::bearing("left", 0, 1e6), shafts::bearing("right", 1, 1e6)};
    const double natural = std::sqrt(2 * 1e6 / 100);
    for (const double x : {0.5, -0.5, 2.0}) {
        const auto responses = unbalance_response(shaft, std::vector<double>{x * natural});
        const double radius = 1e-4 * x * x / (1 - x * x);
        const Complex expected = std::polar(1.0, angle) * radius;
        // Circles with the throw: x = Re(r e^(i theta)), y = Im.
        CHECK(std::abs(responses[0].x[1] - expected) < 1e-5 * std::abs(radius));
        CHECK(std::abs(responses[0].y[1] - Complex(0, -1) * expected) < 1e-5 * std::abs(radius));
        CHECK(std::abs(responses[0].bearing_x[0] - 1e6 * expected) < 1e-5 * 1e6 * std::abs(radius));
    }
    CHECK(1e-4 * 0.25 / 0.75 == near(reference()["checks"]["jeffcott_unbalance"]["closed"].get<double>(), 1e-12));
}
