#include "deadpoint/report/run/reduce_text.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/twin/model/reduction.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

std::string error_line(const press::StatedError& error)
{
    return fmt::format("  {:.3f} K, {:.3f} um: {}\n", error.temperature, micrometre * error.gap, error.of);
}

// When a press is reduced, no case has stated the play of its bearings yet.
constexpr const char* without_play = "the gap without the play of the crank's bearings";

std::string certified_text(const press::Certified& certified)
{
    if (!certified.refused.empty())
        return fmt::format("  no certified bound: {}\n", certified.refused);
    double largest = 0;
    for (const auto& [name, bound] : certified.probes)
        largest = std::max(largest, bound);
    const auto gap = certified.gap ? fmt::format("{:.2g} um of the gap, ", micrometre * *certified.gap) : std::string{};
    return fmt::format("  at most {}{:.2g} K of probes at the end of the run: certified\n", gap, largest);
}

}  // namespace

std::string reduce_text(const twin::Reduction& reduction)
{
    const auto& small = reduction.small;
    const auto free = std::ranges::count_if(small.box, [](const auto& one) { return one.from < one.to; });
    std::string text = fmt::format("\n{}\n\n{} unknowns became {} states; {} coefficients are free\n\n", small.name,
                                   small.unknowns, small.states, free);
    text += fmt::format("largest error after the first minute, of probes and sides of joints, and of {}:\n",
                        small.chain ? without_play : "the gap");
    for (const auto& error : small.errors)
        text += error_line(error);
    text += "by number of states, anywhere in the ranges:\n";
    for (const auto& [states, temperature, gap] : small.sizes)
        text += error_line({fmt::format("{} states", states), temperature, gap});
    return text;
}

std::string reduced_run_text(const press::ReducedResult& reduced)
{
    std::string text =
        fmt::format("computed on a reduced model of {} states; its error, after the first minute:\n", reduced.states);
    if (reduced.full_run)
        text += error_line(*reduced.full_run);
    if (reduced.estimate)
        text += error_line(*reduced.estimate);
    if (reduced.certified)
        text += certified_text(*reduced.certified);
    if (!reduced.errors.empty())
        text += fmt::format("measured when it was built, {}:\n", without_play);
    for (const auto& error : reduced.errors)
        text += error_line(error);
    for (const auto& outside : reduced.outside)
        text += fmt::format("  outside its range: {}\n", outside);
    return text;
}

}  // namespace deadpoint::report
