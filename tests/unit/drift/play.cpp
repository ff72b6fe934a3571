#include "deadpoint/drift/play.hpp"

#include <doctest/doctest.h>

using deadpoint::drift::BearingPlay;
using enum BearingPlay::Kind;

TEST_CASE("play: what closes further than it goes does not move the crank; what opens does")
{
    const BearingPlay play{limited, 20e-6};
    CHECK(play.taken(-15e-6) == -15e-6);
    CHECK(play.taken(-20e-6) == -20e-6);
    CHECK(play.taken(-37e-6) == -20e-6);
    CHECK(play.taken(9e-6) == 9e-6);
    CHECK(play.slope(-15e-6) == 1);
    CHECK(play.slope(-37e-6) == 0);
    CHECK(play.share(-40e-6) == 0.5);
    CHECK(play.share(0) == 1);
}

TEST_CASE("play: none and whole")
{
    for (const double growth : {-37e-6, 0.0, 5e-6}) {
        CHECK(BearingPlay{none, 0}.taken(growth) == 0);
        CHECK(BearingPlay{none, 0}.share(growth) == 0);
        CHECK(BearingPlay{whole, 0}.taken(growth) == growth);
        CHECK(BearingPlay{whole, 0}.share(growth) == 1);
    }
}
