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
    // 16.6 GB for one rank and 3.75 GB for each further one
    CHECK(fem::rank_count(2400000, 8, 16.6e9 + 2.5 * 3.75e9) == 3);
    // 2.6 and 0.3 GB
    CHECK(fem::rank_count(100000, 8, 2.6e9 + 1.5 * 0.3e9) == 2);
}
