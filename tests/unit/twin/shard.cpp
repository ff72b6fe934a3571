#include "deadpoint/twin/map/shard.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <numeric>

using namespace deadpoint;
using twin::Shard;

TEST_CASE("shards have each point once, and as many as the others or one less")
{
    for (const std::size_t points : {0U, 1U, 7U, 12U, 1000U})
        for (const int count : {1, 2, 5, 13}) {
            CAPTURE(points);
            CAPTURE(count);
            std::vector<std::size_t> order(points), all;
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::reverse(order.begin(), order.end());
            for (int number = 1; number <= count; ++number) {
                const auto own = twin::points_of({number, count}, order);
                CHECK(own.size() >= points / static_cast<std::size_t>(count));
                CHECK(own.size() <= points / static_cast<std::size_t>(count) + 1);
                CHECK(std::ranges::is_sorted(own));
                all.insert(all.end(), own.begin(), own.end());
            }
            std::ranges::sort(all);
            std::ranges::sort(order);
            CHECK(all == order);
        }
}

TEST_CASE("a shard is a number of a count")
{
    const auto shard = twin::read_shard("2/4");
    CHECK(shard.number == 2);
    CHECK(shard.count == 4);
    for (const char* wrong : {"", "2", "2/", "/4", "0/4", "5/4", "-1/4", "2/0", "2/4x", "2:4", "1/100001"})
        CHECK_THROWS_AS((void)twin::read_shard(wrong), InputError);
    CHECK_THROWS_WITH_AS((void)twin::read_shard("5/4"), doctest::Contains("shares count from 1: 1/4 to 4/4"),
                         InputError);
}

TEST_CASE("points of one model are neighbours in the order that is cut into shards")
{
    casefile::Case fine, coarse;
    coarse.numerics.size = 2 * fine.numerics.size;
    CHECK(twin::order_by_model({fine, coarse, fine, coarse, fine}) == std::vector<std::size_t>{0, 2, 4, 1, 3});
}
