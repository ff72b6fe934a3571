#include "deadpoint/press/check/plausibility.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace deadpoint;

namespace {

/// A contact on a regular prism with `sides` sides in a cylinder of 100 mm about z.
Machine prism(int sides)
{
    Contact contact;
    contact.name = "pivot.pin";
    contact.geometry = CylinderGeometry{{0.2, 0.1, 0}, {0, 0, 1}, 0.05, true};
    const double step = 2 * std::numbers::pi / sides;
    for (int i = 0; i < sides; ++i) {
        const double angle = (i + 0.5) * step;
        const double radius = 0.05 * std::cos(0.5 * step);  // the middle of a side
        ContactPoint point;
        point.position_a = {0.2 + radius * std::cos(angle), 0.1 + radius * std::sin(angle), 0.3};
        contact.points.push_back(point);
    }
    Machine machine;
    machine.geometries = {contact.geometry, PlaneGeometry{{0, 0, 1}, 0.3}};
    machine.faces.resize(2);
    machine.faces[1].geometry = 1;
    machine.interfaces = {contact};
    return machine;
}

}  // namespace

TEST_CASE("contacts with a handful of cells around are questioned, with the distance of their facets")
{
    const casefile::Case nothing;
    // A hexagon: 50 mm (1 - cos 30 degrees) = 6.7 mm; of ten sides: 4.9 % of the radius.
    const auto found = press::question_machine(nothing, prism(6), 1);
    REQUIRE(found.size() == 1);
    CHECK(found[0].message.find("pivot.pin (facets 6.7 mm off its cylinder of 100 mm)") != std::string::npos);
    // The bottom of a blind hole is not a facet of its cylinder.
    auto blind = prism(24);
    ContactPoint bottom;
    bottom.face_a = 1;
    bottom.position_a = {0.2, 0.1, 0.3};
    blind.interfaces[0].points.push_back(bottom);
    CHECK(press::question_machine(nothing, blind, 1).empty());
    CHECK(press::question_machine(nothing, prism(9), 1).size() == 1);
    CHECK(press::question_machine(nothing, prism(10), 1).empty());
}
