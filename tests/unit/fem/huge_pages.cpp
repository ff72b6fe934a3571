#include "deadpoint/fem/algebra/huge_pages.hpp"

#include <algorithm>
#include <cstdint>
#include <doctest/doctest.h>
#include <numeric>
#include <span>

using namespace deadpoint::fem;

namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

std::span<std::uint32_t> numbers(void* array, std::size_t bytes)
{
    return {static_cast<std::uint32_t*>(array), bytes / sizeof(std::uint32_t)};
}

bool counts(std::span<const std::uint32_t> values)
{
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] != i)
            return false;
    return true;
}

}  // namespace

TEST_CASE("arrays keep what is in them as they grow into large pages and shrink out of them")
{
    void* array = allocate_array(5 * mebibyte + 12);
    REQUIRE(array);
    auto values = numbers(array, 5 * mebibyte + 12);
    std::iota(values.begin(), values.end(), 0U);
    for (const std::size_t size : {40 * mebibyte + 4, 90 * mebibyte, 33 * mebibyte + 8, 6 * mebibyte}) {
        array = resize_array(array, size);
        REQUIRE(array);
        CHECK(counts(numbers(array, std::min(size, 5 * mebibyte + 12))));
        values = numbers(array, size);  // all of it can be written to
        std::iota(values.begin(), values.end(), 0U);
    }
    CHECK(resize_array(array, 0) == nullptr);
}

TEST_CASE("a large array begins at a large page and is zero; there is none of no bytes")
{
    void* large = allocate_array(50 * mebibyte + 1);
    REQUIRE(large);
    CHECK(reinterpret_cast<std::uintptr_t>(large) % (2 * mebibyte) == 0);
    CHECK(static_cast<const char*>(large)[0] == 0);
    CHECK(static_cast<const char*>(large)[50 * mebibyte] == 0);
    void* small = allocate_array(100);
    REQUIRE(small);
    CHECK(reinterpret_cast<std::uintptr_t>(small) % 64 == 0);  // a line of the cache
    release_array(small);
    release_array(large);
    release_array(nullptr);
    CHECK(allocate_array(0) == nullptr);
    CHECK(allocate_array(std::size_t{1} << 62) == nullptr);
}
