#include "deadpoint/fem/space/rank_count.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

constexpr double plenty = 1e15;

TEST_CASE("a mesh that keeps all cores busy gets a rank on each")
{
    CHECK(fem::rank_count(12000, 2, plenty) == 2);
    CHECK(fem::rank_count(2400000, 64, plenty) == 64);
}

TEST_CASE("a small mesh gets no more ranks than it keeps busy")
{
    CHECK(fem::rank_count(0, 16, plenty) == 1);
    CHECK(fem::rank_count(9900, 16, plenty) == 1);
    CHECK(fem::rank_count(94000, 64, plenty) == 18);
}

TEST_CASE("ranks that the memory does not hold are left out")
{
    CHECK(fem::rank_count(2400000, 8, 1e9) == 1);
    // 15.75 GB for one rank and 2.1 GB for each further one
    CHECK(fem::rank_count(2400000, 8, 15.75e9 + 2.5 * 2.1e9) == 3);
    // 3.05 and 0.35 GB
    CHECK(fem::rank_count(100000, 8, 3.05e9 + 1.5 * 0.35e9) == 2);
}
