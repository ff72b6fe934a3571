#pragma once

#include <cmath>
#include <doctest/doctest.h>

/// A value that a computed one must be close to: `CHECK(gap == near(-32.8e-6, 1e-3))`.
///
/// |computed - value| <= max(relative |value|, absolute). Nothing is added to the scale (doctest's Approx adds 1), so
/// that micrometres in metres are held as closely as hundreds of kelvin. A value of zero needs an absolute tolerance,
/// in the value's unit. NaN is close to nothing; an infinity only to itself.
struct Near {
    double value;
    double relative;
    double absolute;

    friend bool operator==(double computed, const Near& near)
    {
        return computed == near.value ||
               std::abs(computed - near.value) <= std::fmax(near.relative * std::abs(near.value), near.absolute);
    }
    friend bool operator!=(double computed, const Near& near) { return !(computed == near); }
};

inline Near near(double value, double relative, double absolute = 0) { return {value, relative, absolute}; }

namespace doctest {

template <>
struct StringMaker<Near> {
    static String convert(const Near& near)
    {
        return toString(near.value) + " +- " + toString(std::fmax(near.relative * std::abs(near.value), near.absolute));
    }
};

}  // namespace doctest
