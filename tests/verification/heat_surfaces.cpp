#include "../record.hpp"
#include "deadpoint/error.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <numbers>

// Areas: contacts that overlap in part, and what faceted circles lose.

using namespace verification;

namespace {

/// Two lumps: heat P into the first, a conductance G between them, films f_1 and f_2 to air. Rises [K].
std::array<double, 2> two_lumps(double power, double between, double film_1, double film_2)
{
    const double second = power / (film_1 * (film_2 + between) / between + film_2);
    return {second * (film_2 + between) / between, second};
}

}  // namespace

TEST_CASE("an interface that overlaps in part conducts where it does, and the rest is in air")
{
    const double overlap = (0.060 - 0.023) * 0.029, bottom = 0.06 * 0.04;
    const double sides_lower = 2 * 0.03 * (0.06 + 0.04), sides_upper = 2 * 0.03 * (0.07 + 0.04);
    const auto expected = two_lumps(10000 * bottom, overlap / 5e-3, 20 * (sides_lower + bottom - overlap),
                                    20 * (sides_upper + 2 * 0.07 * 0.04 - overlap));
    for (const auto& overrides :
         {std::vector<std::string>{},
          {"joints.contact.interfaces.0.a=bottom_of_upper", "joints.contact.interfaces.0.b=top_of_lower"},
          {"parts.lower.tetrahedra=true", "parts.upper.order=2"}}) {
        const auto solved = solve("shifted-blocks", overrides);
        const auto& contact = solved.machine.interfaces[0];
        CHECK(contact.area == near(overlap, 1e-9));
        const bool swapped = solved.machine.parts[contact.part_a].name == "upper";
        const std::array<double, 2> rises{(swapped ? solved.side_b() : solved.side_a()) - 20,
                                          (swapped ? solved.side_a() : solved.side_b()) - 20};
        const char* names[] = {"lower", "upper"};
        for (std::size_t i = 0; i < 2; ++i)
            // What is left is conduction in the blocks: 10 kW/m2 over 30 mm at 1e6 W/m/K are 3e-4 K of 70 K.
            record({std::string("contact with partial overlap, ") + names[i] + " block's rise", "two lumps", "K",
                    expected[i], 2e-5 * expected[i], "conductivity of 1e6 W/m/K instead of none"},
                   rises[i]);
    }
}

TEST_CASE("an interface that overlaps in part is refused unless the case says so")
{
    auto input = read("shifted-blocks", {"joints.contact.interfaces.0.partial=false"});
    deadpoint::Observer silent;
    CHECK_THROWS_WITH_AS(deadpoint::full::prepare_machine(input, 1, silent), doctest::Contains("partial = true"),
                         deadpoint::InputError);
}

namespace {

deadpoint::Machine meshed(const std::string& name, const std::string& override_)
{
    deadpoint::Observer silent;
    return deadpoint::full::prepare_machine(read(name, {override_}), 1, silent);
}

/// Into how many chords the circle of this radius and height is divided.
auto chords(const deadpoint::Machine& machine, double radius, double height)
{
    return std::ranges::count_if(machine.nodes, [&](const deadpoint::Vec3& x) {
        return std::abs(std::hypot(x[0], x[1]) - radius) < 1e-9 && std::abs(x[2] - height) < 1e-9;
    });
}

double observed_order(const std::array<double, 2>& loss, const std::array<double, 2>& count)
{
    return std::log(loss[0] / loss[1]) / std::log(count[1] / count[0]);
}

}  // namespace

TEST_CASE("faceted circles: a contact keeps its area, a surface in air loses at second order")
{
    std::array<double, 2> loss{};
    std::array<double, 2> count{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto machine = meshed("two-rings", std::string("parts.outer_ring.size=") + (i == 0 ? "5 mm" : "2 mm"));
        // The other side's facets are other ones: both count as the cylinder between them.
        CHECK(machine.interfaces[0].area == near(2 * std::numbers::pi * 0.03 * 0.01, 1e-9));
        const auto& outside = *std::ranges::find(machine.surfaces, "outside", &deadpoint::MeshSurface::name);
        loss[i] = 1 - outside.area / (2 * std::numbers::pi * 0.05 * 0.01);
        count[i] = static_cast<double>(chords(machine, 0.05, 0));
    }
    MESSAGE("losses of area " << loss[0] << ", " << loss[1]);
    CHECK(loss[0] > 1e-4);
    record({"faceted circle, order of the loss of area in air", "chord and arc", "", 2, 0.01, "terms of fourth order"},
           observed_order(loss, count));
}

TEST_CASE("faceted circles: a full cylinder loses volume at second order")
{
    std::array<double, 2> loss{};
    std::array<double, 2> count{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto machine = meshed("shaft-in-block", std::string("parts.shaft.size=") + (i == 0 ? "10 mm" : "4 mm"));
        const auto& shaft = *std::ranges::find(machine.parts, "shaft", &deadpoint::MeshPart::name);
        loss[i] = 1 - shaft.volume / (std::numbers::pi * 0.025 * 0.025 * 0.08);
        count[i] = static_cast<double>(chords(machine, 0.025, -0.02));
    }
    MESSAGE("losses of volume " << loss[0] << ", " << loss[1]);
    CHECK(loss[0] > 1e-3);
    record({"faceted circle, order of the loss of volume", "chord and arc", "", 2, 0.01, "terms of fourth order"},
           observed_order(loss, count));
}

TEST_CASE("faceted circles: a journal conducts h A of the true cylinder on any mesh")
{
    // 100 W into the inner ring, all of which must cross the film: h A times the mean jump, on any two meshes.
    const double exact = 100 / (5000 * 2 * std::numbers::pi * 0.03 * 0.01);
    for (const char* size : {"12 mm", "5 mm", "2.9 mm"})
        for (const char* shape : {"parts.outer_ring.tetrahedra=false", "parts.outer_ring.tetrahedra=true"}) {
            auto input = read("two-rings", {std::string("parts.outer_ring.size=") + size, shape});
            input.surfaces.erase("bore");
            deadpoint::casefile::HeatInput heater;
            heater.parts = {"inner_ring"};
            heater.power = deadpoint::casefile::Course{100, {}, {}};
            heater.at_rest = true;
            input.heat_sources["heater"] = heater;
            const auto solved = solve(input);
            record({std::string("journal, temperature jump of 100 W, outer cells of ") + size, "H / (h A)", "K", exact,
                    1e-8 * exact, "exact; solver"},
                   solved.side_a() - solved.side_b());
        }
}
