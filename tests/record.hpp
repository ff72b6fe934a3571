#pragma once

#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <string>
#include <vector>

/// A figure held against its figure. With DEADPOINT_RECORD=FILE in the environment each becomes a row of that file, of
/// which scripts/validate.py makes docs/validation/verification.md.
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

/// An error, or the difference between one run and the next finer one, at a size of cells or of time steps.
struct ErrorAt {
    double size;  ///< relative to any other of the series
    double error;
};

/// Holds the order at which an error falls from the first to the last of its sizes against a figure. With
/// DEADPOINT_RECORD the errors go to FILE.orders, which scripts/validate.py draws.
/// @param unit  of the errors
inline void record_order(const Figure& figure, const std::string& unit, const std::vector<ErrorAt>& errors)
{
    const auto &first = errors.front(), &last = errors.back();
    record(figure, std::log(first.error / last.error) / std::log(first.size / last.size));
    const char* file = std::getenv("DEADPOINT_RECORD");
    if (!file)
        return;
    static std::ofstream out(std::string(file) + ".orders");
    out.precision(9);
    out << figure.requirement << '\t' << figure.expected << '\t' << unit;
    for (const auto& at : errors)
        out << '\t' << at.size << '\t' << at.error;
    out << std::endl;
}
