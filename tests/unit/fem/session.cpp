/// Requirement: where memory is short, what computes ends with an error instead of asking for memory for ever.
#include "deadpoint/fem/algebra/petsc.hpp"

#include <cstddef>
#include <doctest/doctest.h>
#include <fstream>
#include <petscblaslapack.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace {

/// A product of two matrices with almost no addresses left; ends the process.
[[noreturn]] void multiply_without_room()
{
    constexpr PetscBLASInt size = 300;
    constexpr PetscScalar one = 1;
    constexpr rlim_t left = rlim_t{16} << 20;
    const std::vector<PetscScalar> factor(static_cast<std::size_t>(size) * size, one);
    std::vector<PetscScalar> product(factor);
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit limit{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + left, RLIM_INFINITY};
    setrlimit(RLIMIT_AS, &limit);
    alarm(60);
    BLASgemm_("N", "N", &size, &size, &size, &one, factor.data(), &size, factor.data(), &size, &one, product.data(),
              &size);
    _exit(product.front() == size + 1 ? 0 : 1);
}

}  // namespace

TEST_CASE("a large product finds its workspace when memory has run out")
{
    const pid_t child = fork();
    if (child == 0)
        multiply_without_room();
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));  // a signal: it asked for memory until the alarm
    CHECK(WEXITSTATUS(status) == 0);
}
