#pragma once

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <string>

/// A figure held against its target. With DEADPOINT_RECORD=FILE in the environment each becomes a row of that file, of
/// which scripts/validate makes docs/validation/verification.md.
struct Target {
    std::string requirement;
    std::string source;
    std::string unit;
    double expected = 0;
    double tolerance = 0;  ///< absolute
    std::string reason;    ///< for that tolerance
};

inline void record(const Target& target, double got)
{
    CAPTURE(target.requirement);
    CAPTURE(got);
    CAPTURE(target.expected);
    CHECK(std::abs(got - target.expected) <= target.tolerance);
    const char* file = std::getenv("DEADPOINT_RECORD");
    if (!file)
        return;
    static std::ofstream out(file);  // anew in each run
    out.precision(9);
    out << target.requirement << '\t' << target.source << '\t' << target.unit << '\t' << target.expected << '\t' << got
        << '\t' << target.tolerance << '\t' << target.reason << std::endl;
}
