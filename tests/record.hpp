#pragma once

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <string>

/// A figure held against its figure. With DEADPOINT_RECORD=FILE in the environment each becomes a row of that file, of
/// which scripts/validate makes docs/validation/verification.md.
struct Figure {
    std::string requirement;
    std::string source;
    std::string unit;
    double expected = 0;
    double tolerance = 0;  ///< absolute
    std::string reason;    ///< for that tolerance
};

inline void record(const Figure& figure, double got)
{
    CAPTURE(figure.requirement);
    CAPTURE(got);
    CAPTURE(figure.expected);
    CHECK(std::abs(got - figure.expected) <= figure.tolerance);
    const char* file = std::getenv("DEADPOINT_RECORD");
    if (!file)
        return;
    static std::ofstream out(file);  // anew in each run
    out.precision(9);
    out << figure.requirement << '\t' << figure.source << '\t' << figure.unit << '\t' << figure.expected << '\t' << got
        << '\t' << figure.tolerance << '\t' << figure.reason << std::endl;
}
