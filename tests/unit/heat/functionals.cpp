/// Requirement: each functional has a place of its own, and loads are the transposed of values.
#include "deadpoint/heat/functionals.hpp"

#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <set>

using namespace deadpoint::heat;

TEST_CASE("each functional has a number of its own, none is left out")
{
    for (const FunctionalLayout& layout :
         {FunctionalLayout{3, 4, 2, 5, 6}, FunctionalLayout{0, 1, 0, 0, 0}, FunctionalLayout{1, 0, 0, 0, 2},
          FunctionalLayout{0, 0, 7, 1, 0}, FunctionalLayout{}}) {
        std::set<std::size_t> seen;
        std::size_t visited = 0;
        const auto visit = [&](std::size_t number) {
            seen.insert(number);
            ++visited;
        };
        for (std::size_t i = 0; i < layout.interfaces; ++i)
            for (const bool side_b : {false, true}) {
                visit(layout.mean(i, side_b));
                visit(layout.zone(i, side_b));
            }
        for (std::size_t p = 0; p < layout.parts; ++p)
            visit(layout.part(p));
        for (std::size_t s = 0; s < layout.surfaces; ++s)
            visit(layout.surface(s));
        for (std::size_t b = 0; b < layout.bodies; ++b)
            visit(layout.body(b));
        for (std::size_t p = 0; p < layout.probes; ++p)
            visit(layout.probe(p));
        CHECK(seen.size() == visited);
        CHECK(layout.count() == visited);
        if (!seen.empty())
            CHECK(*seen.rbegin() == layout.count() - 1);
    }
}

TEST_CASE("probes come last, so that another list of probes leaves all other numbers as they are")
{
    FunctionalLayout layout{3, 4, 2, 5, 0};
    const auto body = layout.body(4);
    layout.probes = 9;
    CHECK(layout.body(4) == body);
    CHECK(layout.probe(0) == body + 1);
}

TEST_CASE("loads are the transposed of values: watts . values is the same either way")
{
    const Loads loads{{0, 0.5}, {3, -2}, {0, 0.25}, {2, 7}};  // a functional may stand twice
    const std::vector<double> values{300, 310, 320, 330};
    std::vector<double> watts(4, 0.0);
    add_watts(watts, loads, 40);
    double work = 0;
    for (std::size_t k = 0; k < 4; ++k)
        work += watts[k] * values[k];
    CHECK(work == near(40 * value_of(loads, values), 1e-14));
    CHECK(watts[1] == 0);
    CHECK(watts[0] == near(30, 1e-15));
    add_watts(watts, loads, -40);
    for (const double w : watts)
        CHECK(std::abs(w) < 1e-12);  // of 280 W: rounding
    CHECK(value_of({}, values) == 0);
}
