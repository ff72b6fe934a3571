/// Requirement: surfaces share the faces between their boxes, and what is exposed gets the rest.
#include "deadpoint/full/model/prepare.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

constexpr double everywhere = 1000;

/// A block of 100 mm with cells of 50 mm, in air, whose top is heated left of `from` and held right of `to`.
casefile::Case block(double from, double to)
{
    casefile::Case input;
    input.numerics.size = 0.05;
    input.bodies["frame"].ground = true;
    auto& part = input.parts["block"];
    part.body = "frame";
    part.material = "steel";
    input.materials["steel"].density = 7850;
    part.shapes = {{Shape::Operation::add, BoxShape{{0, 0, 0}, {0.1, 0.1, 0.1}}}};
    auto& top = input.surfaces["heated"];
    top.select = casefile::Surface::Select::plane;
    top.axis = Axis::y;
    top.position = 0.1;
    top.heat_flux = casefile::Course{1000, {}, {}};
    top.within = BoxShape{{-everywhere, -everywhere, -everywhere}, {from, everywhere, everywhere}};
    auto& other = input.surfaces["held"] = top;
    other.heat_flux.reset();
    other.temperature = casefile::Course{300, {}, {}};
    other.within = BoxShape{{to, -everywhere, -everywhere}, {everywhere, everywhere, everywhere}};
    auto& air = input.surfaces["air"];
    air.select = casefile::Surface::Select::exposed;
    air.film = casefile::Film{};
    air.film->law = casefile::FilmCoefficient{5};
    return input;
}

double area_of(const Machine& machine, const std::string& name)
{
    return std::ranges::find(machine.surfaces, name, &MeshSurface::name)->area;
}

}  // namespace

TEST_CASE("two boxes share the faces that they cut, and the air gets what they leave")
{
    Observer quiet;
    const auto machine = full::prepare_machine(block(0.03, 0.03), 1, quiet);
    CHECK(area_of(machine, "heated") == near(0.03 * 0.1, 1e-9));
    CHECK(area_of(machine, "held") == near(0.07 * 0.1, 1e-9));
    CHECK(area_of(machine, "air") == near(0.05, 1e-9));
    const auto apart = full::prepare_machine(block(0.03, 0.07), 1, quiet);
    CHECK(area_of(apart, "air") == near(0.05 + 0.04 * 0.1, 1e-9));
}

TEST_CASE("boxes that overlap on a face are refused")
{
    Observer quiet;
    CHECK_THROWS_WITH_AS(full::prepare_machine(block(0.04, 0.03), 1, quiet),
                         "surfaces.held: surfaces.heated and surfaces.held both claim a face of part 'block'\n"
                         "  help: narrow one of them with 'within' or 'parts'",
                         InputError);
}

TEST_CASE("a flux takes a box within one cell; a temperature needs the middle of a face and names both areas")
{
    struct Listener : Observer {
        std::vector<std::string> warnings;
        void warn(std::string_view text) override { warnings.emplace_back(text); }
    };
    Listener listener;
    const auto machine = full::prepare_machine(block(0.02, 0.03), 1, listener);
    CHECK(area_of(machine, "heated") == near(0.02 * 0.1, 1e-9));
    REQUIRE(listener.warnings.size() == 1);  // cells of 50 mm: the nodes of x = 50 mm to 100 mm are held
    CHECK(listener.warnings.front() ==
          "surfaces.held: the temperature is prescribed on whole faces, 50 cm2, but the box has 70 cm2; end the box "
          "where cells end, or make the cells smaller");
    CHECK_THROWS_WITH_AS(full::prepare_machine(block(0.02, 0.09), 1, listener),
                         "surfaces.held: no face has its centre in the box, and a condition at nodes applies to whole "
                         "faces\n  help: correct the box, or make the cells there smaller",
                         InputError);
}
