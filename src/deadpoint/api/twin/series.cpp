#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/result.hpp"

#include <algorithm>
#include <array>

namespace deadpoint {
namespace {

constexpr std::array kind_names{
    std::string_view("probe"),     std::string_view("interface"), std::string_view("joint"),
    std::string_view("part"),      std::string_view("source"),    std::string_view("heat source"),
    std::string_view("oil"),       std::string_view("enclosure"), std::string_view("whole"),
    std::string_view("dimension"), std::string_view("corner"),    std::string_view("clearance"),
    std::string_view("force"),     std::string_view("slide"),     std::string_view("drive")};

std::string joined(const std::vector<std::string>& names)
{
    std::string text;
    for (const auto& name : names)
        text += (text.empty() ? "'" : ", '") + name + "'";
    return text;
}

/// The most similar name or quantity, or a list of all.
std::string remedy(std::string_view asked, const std::vector<std::string>& names)
{
    if (names.empty())
        return {};
    const auto meant = closest_name(asked, names);
    return "\n  help: " + (meant.empty() ? "there are " + joined(names) : "did you mean '" + meant + "'?");
}

/// Linear interpolation between the times; at a time that occurs twice, the later value.
double between(const std::vector<double>& times, const std::vector<double>& values, double at)
{
    const auto next = std::ranges::upper_bound(times, at);
    if (next == times.begin())
        return values.front();
    if (next == times.end())
        return values.back();
    const auto k = static_cast<std::size_t>(next - times.begin());
    const double share = (at - times[k - 1]) / (times[k] - times[k - 1]);
    return (1 - share) * values[k - 1] + share * values[k];
}

}  // namespace

std::string_view kind_name(SeriesKind kind) { return kind_names.at(static_cast<std::size_t>(kind)); }

const NamedSeries* SeriesTable::find(SeriesKind kind, std::string_view name, std::string_view quantity) const
{
    const auto found = std::ranges::find_if(series_, [&](const NamedSeries& series) {
        return series.kind == kind && series.name == name && series.quantity == quantity;
    });
    return found == series_.end() ? nullptr : &*found;
}

const NamedSeries& SeriesTable::at(SeriesKind kind, std::string_view name, std::string_view quantity) const
{
    if (const auto* found = find(kind, name, quantity))
        return *found;
    const std::string of(kind_name(kind));
    const auto known = names(kind);
    if (std::ranges::find(known, name) == known.end())
        throw InputError("the result has no " + of + " '" + std::string(name) + "'" + remedy(name, known));
    std::vector<std::string> quantities;
    for (const auto& series : series_)
        if (series.kind == kind && series.name == name)
            quantities.push_back(series.quantity);
    throw InputError("the result has no " + std::string(quantity) + " of " + of + " '" + std::string(name) + "'" +
                     remedy(quantity, quantities));
}

std::vector<std::string> SeriesTable::names(SeriesKind kind) const
{
    std::vector<std::string> result;
    for (const auto& series : series_)
        if (series.kind == kind && std::ranges::find(result, series.name) == result.end())
            result.push_back(series.name);
    return result;
}

double SeriesTable::value(const NamedSeries& series, double time) const
{
    if (series.rates.empty())
        return between(time_, series.values, time);
    return interpolate(time_, {series.values, series.rates}, time);
}

const NamedSeries& RunResult::probe(std::string_view name) const { return at(SeriesKind::probe, name, "temperature"); }

const NamedSeries& RunResult::joint_temperature(std::string_view name) const
{
    return at(SeriesKind::joint, name, "temperature");
}

const NamedSeries& RunResult::joint_heat(std::string_view name) const { return at(SeriesKind::joint, name, "heat"); }

const NamedSeries& RunResult::part_temperature(std::string_view name) const
{
    return at(SeriesKind::part, name, "temperature");
}

const NamedSeries& RunResult::gap() const
{
    const auto* found = find(SeriesKind::dimension, "E_SW", "change");
    if (!found)
        throw InputError("the result has no gap: the case has no dimension chain\n  help: add [chain]");
    return *found;
}

}  // namespace deadpoint
