#include "deadpoint/report/run/accuracy_text.hpp"

#include "deadpoint/casefile/describe/accuracy.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/press/result/accuracy.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::report {
namespace {

using press::AccuracyReport;

struct Unit {
    std::string name;
    double factor;
};

Unit unit_of(const AccuracyReport& accuracy)
{
    return accuracy.wanted.of == casefile::Accuracy::Of::gap ? Unit{"um", micrometre} : Unit{"K", 1};
}

std::string figure_of(const AccuracyReport& accuracy)
{
    return accuracy.wanted.of == casefile::Accuracy::Of::gap ? "E_SW" : "largest rise";
}

// The parts with the largest shares, largest first.
std::vector<const press::AccuracyPart*> worst_parts(const AccuracyReport& accuracy)
{
    std::vector<const press::AccuracyPart*> parts;
    for (const auto& part : accuracy.parts)
        parts.push_back(&part);
    std::ranges::stable_sort(parts, std::ranges::greater(), &press::AccuracyPart::share);
    return parts;
}

std::string shown(double value, const Unit& unit) { return significant(unit.factor * value, 2); }

std::string parts_text(const AccuracyReport& accuracy)
{
    constexpr std::size_t listed = 5;
    const auto unit = unit_of(accuracy);
    std::string text;
    std::size_t finer = 0;
    for (const auto& part : accuracy.parts)
        finer += part.size < part.first_size ? 1 : 0;
    const auto parts = worst_parts(accuracy);
    text += fmt::format("  {} of {} parts became finer; largest shares left:", finer, parts.size());
    for (std::size_t i = 0; i < std::min(listed, parts.size()); ++i)
        text += fmt::format("{} {} {} {} ({} from {} mm)", i ? "," : "", parts[i]->name, shown(parts[i]->share, unit),
                            unit.name, significant(1e3 * parts[i]->size), significant(1e3 * parts[i]->first_size));
    return text + "\n";
}

}  // namespace

std::string accuracy_line(const AccuracyReport& accuracy)
{
    const auto unit = unit_of(accuracy);
    const auto& last = accuracy.rounds.back();
    const auto change = last.change ? fmt::format("change {} {}", shown(*last.change, unit), unit.name)
                                    : std::string("no second mesh to compare with");
    const auto wanted = fmt::format("{} {}", significant(unit.factor * accuracy.wanted.tolerance), unit.name);
    const auto found =
        fmt::format("{}, estimate {} {}, time steps {} {} at {} cells", change, shown(last.estimate, unit), unit.name,
                    shown(accuracy.time_change, unit), unit.name, last.cells);
    if (accuracy.reached)
        return fmt::format("accuracy of {} reached: {}", wanted, found);
    return fmt::format("accuracy of {} not reached: {}; largest share part '{}' ({})", wanted, found, last.worst_part,
                       accuracy.why_not);
}

std::string accuracy_text(const AccuracyReport& accuracy)
{
    const auto unit = unit_of(accuracy);
    TextTable table({"mesh", "cells", "finer parts", fmt::format("{} [{}]", figure_of(accuracy), unit.name),
                     fmt::format("change [{}]", unit.name), fmt::format("estimate [{}]", unit.name), "worst part",
                     "time"});
    for (std::size_t i = 0; i < accuracy.rounds.size(); ++i) {
        const auto& round = accuracy.rounds[i];
        table.add_row({std::to_string(i + 1), std::to_string(round.cells), i == 0 ? "" : std::to_string(round.refined),
                       fmt::format("{:.3f}", unit.factor * round.value), round.change ? shown(*round.change, unit) : "",
                       shown(round.estimate, unit), round.worst_part, duration_text(round.seconds)});
    }
    return fmt::format("  {}\n\n{}{}  time steps: time_tolerance = \"{}\", max_step = \"{}\"; {} in all\n",
                       accuracy_line(accuracy), table.text(), parts_text(accuracy),
                       format_quantity(accuracy.time_tolerance, Dimension::temperature_difference),
                       format_quantity(accuracy.max_step, Dimension::time), duration_text(accuracy.seconds));
}

nlohmann::ordered_json accuracy_json(const AccuracyReport& accuracy)
{
    const auto unit = unit_of(accuracy);
    const auto number = [&](double value) { return unit.factor * value; };
    nlohmann::ordered_json json;
    json["of"] = accuracy.wanted.of == casefile::Accuracy::Of::gap ? "E_SW" : "probe_rises";
    json["unit"] = unit.name;
    json["wanted"] = number(accuracy.wanted.tolerance);
    json["reached"] = accuracy.reached;
    if (!accuracy.reached)
        json["why_not"] = accuracy.why_not;
    for (const auto& round : accuracy.rounds)
        json["meshes"].push_back({{"cells", round.cells},
                                  {"finer_parts", round.refined},
                                  {"value", number(round.value)},
                                  {"change", round.change ? nlohmann::ordered_json(number(*round.change)) : nullptr},
                                  {"estimate", number(round.estimate)},
                                  {"worst_part", round.worst_part},
                                  {"seconds", round.seconds}});
    json["time_steps"] = {{"time_tolerance_K", accuracy.time_tolerance},
                          {"max_step_s", accuracy.max_step},
                          {"change_by_halving", number(accuracy.time_change)},
                          {"seconds", accuracy.time_seconds}};
    for (const auto& part : accuracy.parts)
        json["parts"][part.name] = {{"size_mm", 1e3 * part.size},
                                    {"first_size_mm", 1e3 * part.first_size},
                                    {"cells", part.cells},
                                    {"estimate", number(part.share)}};
    json["seconds"] = accuracy.seconds;
    return json;
}

void write_accuracy_files(const std::filesystem::path& folder, const AccuracyReport& accuracy,
                          std::span<const std::string> comments)
{
    const auto unit = unit_of(accuracy);
    std::vector<double> cells, finer, value, change, estimate, seconds;
    std::vector<std::string> worst;
    for (const auto& round : accuracy.rounds) {
        cells.push_back(static_cast<double>(round.cells));
        finer.push_back(round.refined);
        value.push_back(unit.factor * round.value);
        change.push_back(round.change ? unit.factor * *round.change : std::numeric_limits<double>::quiet_NaN());
        estimate.push_back(unit.factor * round.estimate);
        worst.push_back(round.worst_part);
        seconds.push_back(round.seconds);
    }
    auto lines = std::vector<std::string>(comments.begin(), comments.end());
    lines.push_back(accuracy_line(accuracy));
    namespace table = schema::accuracy;
    const std::vector<CsvColumn> columns{csv_column(table::cells, cells),
                                         csv_column(table::finer, finer),
                                         csv_column(table::figure, value, figure_of(accuracy), unit.name),
                                         csv_column(table::change, change, {}, unit.name),
                                         csv_column(table::estimate, estimate, {}, unit.name),
                                         csv_column(table::worst, worst),
                                         csv_column(table::seconds, seconds)};
    write_table(folder / "accuracy.csv", lines, columns);
    std::string sizes;
    for (const auto& line : lines)
        sizes += "# " + one_line(line) + "\n";
    for (const auto& part : accuracy.parts)
        if (!part.fixed)
            sizes +=
                fmt::format("[parts.{}]\nsize = \"{}\"\n", part.name, format_quantity(part.size, Dimension::length));
    write_file(folder / "sizes.toml", [&](std::ostream& out) { out << sizes; });
}

}  // namespace deadpoint::report
