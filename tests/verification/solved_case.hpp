#pragma once

#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// A case file of tests/verification/cases taken through the pipeline as the command line does it.
namespace verification {

namespace casefile = deadpoint::casefile;
using deadpoint::casefile::Case;
using Change = std::function<void(Case&)>;

inline constexpr double zero_celsius = 273.15;

inline Case read(const std::string& name, const std::vector<std::string>& overrides = {})
{
    return deadpoint::casefile::read_case(std::string(DEADPOINT_VERIFICATION_CASES) + "/" + name + ".toml", overrides)
        .value;
}

/// A run that writes its temperatures at the end, and one that begins with them.
inline deadpoint::full::RunOptions ending_in(const std::filesystem::path& file)
{
    deadpoint::full::RunOptions options;
    options.state_file = file.string();
    return options;
}
inline deadpoint::full::RunOptions beginning_at(const std::filesystem::path& file)
{
    deadpoint::full::RunOptions options;
    options.start_from = file.string();
    return options;
}

struct SolvedCase {
    Case input;
    deadpoint::Machine machine;
    deadpoint::press::RunResult result;

    [[nodiscard]] const deadpoint::ThermalHistory& history() const { return result.thermal; }
    /// Temperature of a probe at a time, or at the end [degC].
    [[nodiscard]] double probe(const std::string& name, double time = 1e300) const
    {
        const auto* found = deadpoint::press::find(result.probes, name);
        REQUIRE(found);
        return at(*found, time);
    }
    /// Mean temperature of either side of an interface [degC].
    [[nodiscard]] double side_a(double time = 1e300, std::size_t interface = 0) const
    {
        return at(history().interface_a.at(interface), time);
    }
    [[nodiscard]] double side_b(double time = 1e300, std::size_t interface = 0) const
    {
        return at(history().interface_b.at(interface), time);
    }

private:
    [[nodiscard]] double at(const deadpoint::Series& series, double time) const
    {
        return deadpoint::interpolate(history().time, series, time) - zero_celsius;
    }
};

/// Solves a case; every run must close its energy balance.
inline SolvedCase solve(Case input, double size_scale = 1)
{
    deadpoint::Observer silent;
    deadpoint::full::Press press(std::move(input), size_scale);
    SolvedCase solved;
    solved.result = press.run({}, silent);
    solved.machine = press.machine(silent);
    solved.input = press.input();
    CHECK(solved.history().energy.mismatch() < 1e-6);
    return solved;
}

inline SolvedCase solve(const std::string& name, const std::vector<std::string>& overrides = {}, double size_scale = 1)
{
    CAPTURE(name);
    return solve(read(name, overrides), size_scale);
}

/// Largest difference of probes and interface sides of two runs over times they share [K].
inline double largest_difference(const SolvedCase& one, const SolvedCase& other, double other_time_scale = 1)
{
    double largest = 0;
    const double end = one.history().time.back();
    const auto compare = [&](const std::vector<deadpoint::Series>& a, const std::vector<deadpoint::Series>& b) {
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i)
            for (const double share : {0.05, 0.2, 0.5, 0.8, 1.0})
                largest = std::max(largest, std::abs(deadpoint::interpolate(one.history().time, a[i], share * end) -
                                                     deadpoint::interpolate(other.history().time, b[i],
                                                                            share * end * other_time_scale)));
    };
    compare(one.history().probes, other.history().probes);
    compare(one.history().interface_a, other.history().interface_a);
    compare(one.history().interface_b, other.history().interface_b);
    return largest;
}

/// Largest rise above the start among probes and interface sides, to compare differences with [K].
inline double largest_rise(const SolvedCase& solved)
{
    double largest = 0;
    for (const auto* group : {&solved.history().probes, &solved.history().interface_a, &solved.history().interface_b})
        for (const auto& series : *group)
            largest = std::max(largest, std::abs(series.value.back() - solved.input.machine.initial_temperature));
    return largest;
}

/// The same machine with its axes exchanged: what lay along axis i lies along axis to[i]. Boxes and planes only.
inline Case with_axes(Case input, const std::array<std::size_t, 3>& to)
{
    const auto moved = [&](const deadpoint::Vec3& v) {
        deadpoint::Vec3 result{};
        for (std::size_t i = 0; i < 3; ++i)
            result[to[i]] = v[i];
        return result;
    };
    for (auto& [name, part] : input.parts)
        for (auto& shape : part.shapes) {
            auto& box = std::get<deadpoint::BoxShape>(shape.form);
            box = {moved(box.min), moved(box.max)};
        }
    for (auto& [name, surface] : input.surfaces)
        if (surface.select == deadpoint::casefile::Surface::Select::plane)
            surface.axis = static_cast<deadpoint::Axis>(to[static_cast<std::size_t>(*surface.axis)]);
    for (auto& [name, probe] : input.probes)
        probe.position = moved(probe.position);
    return input;
}

}  // namespace verification
