#include "deadpoint/fem/algebra/product_kernels.hpp"

#include <doctest/doctest.h>

using namespace deadpoint::fem;

TEST_CASE("a processor that OpenBLAS does not know gets the kernels of its instructions")
{
    CHECK(better_kernels("Prescott", {true, true}) == "SkylakeX");
    CHECK(better_kernels("Prescott", {true, false}) == "Haswell");
    CHECK(better_kernels("Prescott", {false, false}).empty());  // it is old
    CHECK(better_kernels("Zen", {true, true}).empty());
    CHECK(better_kernels("", {true, true}).empty());  // another BLAS
}

TEST_CASE("a session that has the command line has taken the better kernels")
{
#ifdef __x86_64__
    if (!__builtin_cpu_supports("avx2"))
        return;
#endif
    CHECK(product_kernels() != "Prescott");
}
