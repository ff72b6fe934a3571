/// Interfaces of bodies that slide along each other: contact spread over the stroke by the share of time.
#include "deadpoint/machine/assembly/limits.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace machine_test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double bottom = 0.1, top = 0.3, width = 0.1;  // of the slider as drawn
constexpr double stroke = 0.12;

/// Stops along y, each with the same share of time.
Travel along_y(const std::vector<double>& positions)
{
    Travel travel{"slide", "frame", {}};
    for (const double s : positions) {
        travel.stops.push_back({{0, s, 0}, 1.0 / static_cast<double>(positions.size())});
    }
    return travel;
}

/// Mean positions of equal shares of time of a motion at constant speed up and down the stroke.
std::vector<double> uniform(int count)
{
    std::vector<double> result;
    for (int i = 0; i < count; ++i) {
        result.push_back(stroke * (i + 0.5) / count);
    }
    return result;
}

/// The same of the harmonic motion stroke / 2 (1 - cos(w t)).
std::vector<double> harmonic(int count)
{
    std::vector<double> result;
    for (int i = 0; i < count; ++i) {
        const double mean = (std::sin((i + 1) * pi / count) - std::sin(i * pi / count)) / (pi / count);
        result.push_back(0.5 * stroke * (1 - mean));
    }
    return result;
}

/// A slider on the face x = 0 of a guide that is long enough for the stroke; meshes do not match.
MachineDescription slider_on_guide(const Travel& travel)
{
    MachineDescription description;
    description.parts = {part("slider", "slide", {add(BoxShape{{0, bottom, 0}, {0.05, top, width}})}, 0.027),
                         part("guide", "frame", {add(BoxShape{{-0.04, -0.05, -0.01}, {0, 0.55, 0.11}})}, 0.019)};
    InterfaceDescription interface;
    interface.name = "guide.face";
    interface.a = on_plane("slider", Axis::x, 0);
    interface.b = on_plane("guide", Axis::x, 0);
    interface.travel = travel;
    description.interfaces = {interface};
    return description;
}

/// Largest error of the contact area below any height of the guide, as a share of the whole. The exact one is the
/// integral of width times the share of time covered, P(s > y - top) - P(s > y - bottom), over the height.
double profile_error(const Machine& machine, const std::function<double(double)>& integral_of_distribution)
{
    const Contact& contact = machine.interfaces[0];
    const auto height = [&](std::uint32_t face) {
        double highest = -1e9;
        for (int i = 0; i < machine.faces[face].node_count; ++i) {
            highest = std::max(highest, machine.nodes[machine.faces[face].nodes[i]][1]);
        }
        return highest;
    };
    double error = 0;
    for (std::uint32_t f = 0; f < machine.faces.size(); ++f) {
        if (machine.parts[machine.faces[f].part].name != "guide") {
            continue;
        }
        const double y = height(f);
        double below = 0;
        for (const ContactPoint& point : contact.points) {
            below += height(point.face_b) < y + 1e-9 ? point.weight : 0;
        }
        const double exact = width * (integral_of_distribution(y - bottom) - integral_of_distribution(y - top));
        error = std::max(error, std::abs(below - exact) / contact.area);
    }
    return error;
}

/// Integral of P(position < s) from far below to s.
double integral_uniform(double s)
{
    const double within = std::clamp(s, 0.0, stroke);
    return 0.5 * within * within / stroke + std::max(s - stroke, 0.0);
}
double integral_harmonic(double s)
{
    const double r = 0.5 * stroke, u = std::clamp(s / r - 1, -1.0, 1.0);
    return r * (0.5 * (u + 1) + (u * std::asin(u) + std::sqrt(1 - u * u) - 0.5 * pi) / pi) + std::max(s - stroke, 0.0);
}

double exposed(const Machine& machine, const std::string& name)
{
    for (const MeshPart& p : machine.parts) {
        if (p.name == name) {
            return p.exposed_area - p.exterior_area;
        }
    }
    return 0;
}

}  // namespace

TEST_CASE("a slider covers its guide by the share of time: constant speed gives a trapezoid")
{
    const Machine machine = build(slider_on_guide(along_y(uniform(8))));
    const Contact& contact = machine.interfaces[0];
    // the slider stays on the guide: the mean area is that of its face, whatever the stops
    const double whole = (top - bottom) * width;
    CHECK(contact.area == near(whole, 1e-12));
    CHECK(contact.drawn_area == near(whole, 1e-12));
    CHECK(contact.least_area == near(whole, 1e-12));
    CHECK(contact.stroke == near(stroke * 7 / 8, 1e-12));
    CHECK(contact.coverage() == near(1, 1e-12));
    double sum = 0;
    for (const ContactPoint& point : contact.points) {
        sum += point.weight;
    }
    CHECK(sum == near(contact.area, 1e-12));
    CHECK(exposed(machine, "slider") == near(-whole, 1e-12));  // what is covered on one side is on the other
    CHECK(exposed(machine, "guide") == near(-whole, 1e-12));
    CHECK(contact.max_gap < 1e-15);

    // The stops replace a ramp of the profile by steps: a cumulative error of (stroke / N)^2 / 8 by stroke, at most.
    const auto bound = [&](int count) { return 1.01 * stroke / (8.0 * count * count) / (top - bottom); };
    CHECK(profile_error(machine, integral_uniform) < bound(8));
    CHECK(profile_error(build(slider_on_guide(along_y(uniform(32)))), integral_uniform) < bound(32));
    CHECK(profile_error(build(slider_on_guide({})), integral_uniform) > 0.2);  // where it stands: 30 % too low
}

TEST_CASE("a slider in harmonic motion covers its guide by the arcsine profile, and eight stops are enough")
{
    const auto error = [](int count) {
        return profile_error(build(slider_on_guide(along_y(harmonic(count)))), integral_harmonic);
    };
    const double four = error(4), eight = error(8), sixteen = error(16), fine = error(64);
    MESSAGE("error of the covered share: " << four << ", " << eight << ", " << sixteen << ", " << fine);
    CHECK(eight < 2e-3);  // of the heat on the wrong side of a line
    CHECK(eight < 0.5 * four);
    CHECK(sixteen < 0.5 * eight);
    CHECK(fine < 5e-5);
}

TEST_CASE("points that meet lie where their bodies are drawn")
{
    const auto positions = uniform(5);
    const Machine machine = build(slider_on_guide(along_y(positions)));
    const Contact& contact = machine.interfaces[0];
    for (const ContactPoint& point : contact.points) {
        CHECK(point.position_a[1] > bottom - 1e-12);
        CHECK(point.position_a[1] < top + 1e-12);
        const double apart = point.position_b[1] - point.position_a[1];
        const auto is_stop = [&](double s) { return std::abs(apart - s) < 1e-12; };
        CHECK(std::any_of(positions.begin(), positions.end(), is_stop));
    }
    // fits and what else belongs to bottom dead point take the contact as drawn
    for (const ContactPoint& point : contact.points_as_drawn()) {
        CHECK(std::abs(point.position_b[1] - point.position_a[1]) < 1e-12);
    }
    CHECK(contact.points_as_drawn().size() == build(slider_on_guide({})).interfaces[0].points.size());

    // The travel is that of a body, whichever side it has: here the guide, shorter than the slide, is side a.
    MachineDescription other = slider_on_guide(along_y({0.02}));
    other.parts[0].body = "frame";
    other.parts[1].body = "slide";
    const Machine guide_slides = build(other);
    for (const ContactPoint& point : guide_slides.interfaces[0].points) {
        CHECK(std::abs(point.position_b[1] - point.position_a[1] + 0.02) < 1e-12);
    }
    // ... and one of other bodies moves nothing here
    other.parts[1].body = "ring";
    CHECK(build(other).interfaces[0].stroke == 0);
}

TEST_CASE("a stroke of nothing is the contact as drawn, bit by bit")
{
    const Machine machine = build(slider_on_guide({}));
    const Machine same = build(slider_on_guide(along_y({0.0})));
    const Contact& one = machine.interfaces[0];
    const Contact& other = same.interfaces[0];
    REQUIRE(one.points.size() == other.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i) {
        CHECK(one.points[i].position_a == other.points[i].position_a);
        CHECK(one.points[i].position_b == other.points[i].position_b);
        CHECK(one.points[i].weight == other.points[i].weight);
    }
    CHECK(one.area == other.area);
    CHECK(one.drawn_points.empty());
    CHECK(machine.exposed_fraction == same.exposed_fraction);
}

TEST_CASE("a slide that leaves its guide on the way is reported, and must be on it as drawn")
{
    const auto short_guide = [](double end, const Travel& travel) {
        MachineDescription description = slider_on_guide(travel);
        std::get<std::vector<Shape>>(description.parts[1].source)[0].form =
            BoxShape{{-0.04, -0.05, -0.01}, {0, end, 0.11}};
        return description;
    };
    // 50 mm beyond the guide's end at the second stop: 150 of 200 mm; the third only counts for the least
    Travel travel = along_y({0, 0.05});
    travel.stops.push_back({{0, 0.08, 0}, 0});
    Log log;
    const Machine machine = machine::build_machine(short_guide(top, travel), log);
    const Contact& contact = machine.interfaces[0];
    CHECK(contact.area == near(0.5 * (0.2 + 0.15) * width, 1e-12));
    CHECK(contact.least_coverage() == near(0.6, 1e-12));
    CHECK(contact.coverage() == near(1, 1e-12));
    CHECK(contact.stroke == near(0.08, 1e-12));
    CHECK(log.warnings.empty());
    REQUIRE(log.infos.size() == 1);
    CHECK(contains(log.infos[0], "interface 'guide.face'"));
    CHECK(contains(log.infos[0], "60.0 %"));
    CHECK(contains(log.infos[0], "87.5 %"));

    travel.stops.back().offset[1] = 0.11;  // 90 of 200 mm
    (void)machine::build_machine(short_guide(top, travel), log);
    REQUIRE(log.warnings.size() == 1);
    CHECK(contains(log.warnings[0], "45.0 %"));

    CHECK(contains(complaint(short_guide(0.28, travel)), "90.0 %"));  // 180 of 200 mm as drawn
}

TEST_CASE("a surface that does not lie along the travel is refused")
{
    Travel travel = along_y({0, 0.05});
    travel.stops[1].offset = {0.001, 0.05, 0};
    const std::string text = complaint(slider_on_guide(travel));
    CHECK(contains(text, "interface 'guide.face'"));
    CHECK(contains(text, "does not lie along the travel"));
}

TEST_CASE("a pillar slides along its bush")
{
    MachineDescription description;
    description.parts = {part("bush", "slide", {add(cylinder(Axis::y, {0.02, 0.01}, 0.09, 0, 0.06, 0.05))}, 0.013),
                         part("pillar", "frame", {add(cylinder(Axis::y, {0.02, 0.01}, 0.05, -0.03, 0.2))}, 0.011)};
    InterfaceDescription interface;
    interface.name = "pillar.bush";
    interface.a = on_cylinder("bush", {0.02, 0.01}, 0.05, Axis::y);
    interface.b = on_cylinder("pillar", {0.02, 0.01}, 0.05, Axis::y);
    interface.travel = along_y({0, 0.1});
    description.interfaces = {interface};
    const Machine machine = build(description);
    const Contact& contact = machine.interfaces[0];
    CHECK(contact.area == near(pi * 0.05 * 0.06, 1e-9));  // nodes of circles lie on them to rounding
    double mean = 0;
    for (const ContactPoint& point : contact.points) {
        mean += point.weight * point.position_b[1] / contact.area;
    }
    CHECK(mean == near(0.03 + 0.05, 1e-9));
    interface.travel.stops[1].offset = {0.001, 0.1, 0};
    description.interfaces = {interface};
    CHECK(contains(complaint(description), "bore of diameter 50 mm"));
}
