#pragma once

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/observer.hpp"

#include <doctest/doctest.h>
#include <string>
#include <vector>

/// The starter's press on a coarse mesh, reduced once for all tests.
namespace starter_press {

/// A short operation with two speeds, and oil on the pins.
inline std::vector<std::string> settings(std::vector<std::string> more = {})
{
    std::vector<std::string> all{"operation.0.duration=1 h", "oil.pins=300 W/m^2/K", "output.fields=false"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

inline deadpoint::casefile::Case input(std::vector<std::string> more = {})
{
    return deadpoint::casefile::read_case(std::string(DEADPOINT_SOURCE_DIR) + "/cases/starter/case.toml",
                                          settings(std::move(more)))
        .value;
}

/// Small on purpose: tests compare it with itself, not with the full model.
inline const deadpoint::twin::ReducedPress& press()
{
    static const auto built = [] {
        deadpoint::Observer quiet;
        const auto of = input();
        deadpoint::full::Press whole(of, 3);
        auto options = deadpoint::full::reduce_options(of);
        options.build.sets = 10;
        options.build.training_runs = 10;
        options.build.test_runs = 2;
        options.build.largest = 30;
        options.build.temperature = 10;
        options.build.gap = 1e-3;
        auto reduction = whole.reduce(options, quiet);
        REQUIRE(reduction.has_value());
        return std::move(reduction->small);
    }();
    return built;
}

}  // namespace starter_press
