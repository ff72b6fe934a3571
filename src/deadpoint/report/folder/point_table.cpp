#include "deadpoint/report/folder/point_table.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/csv_table.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/report/schema/column.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/report/tables/drift_columns.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <sstream>
#include <utility>

namespace deadpoint::report {
namespace {

namespace points_table = schema::points;
using State = twin::PointOutcome::State;

constexpr const char* help = "name a new folder, or remove this file to compute all points again";
constexpr std::string_view study_line = "# study ";

std::string bearing_path(const std::string& bearing)
{
    const auto space = bearing.find(' ');
    return fmt::format("crankshaft.{}.seats.{}.peak_N", bearing.substr(0, space), bearing.substr(space + 1));
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

/// The checksums of rows with these columns.
CsvColumn checksums_of(const std::vector<CsvColumn>& columns, const std::string& study)
{
    const auto lines = lines_of(csv_text({}, columns));
    std::vector<std::string> checksums;
    for (std::size_t k = 1; k < lines.size(); ++k)
        checksums.push_back(checksum_of_row(study, lines.front(), lines[k]));
    return csv_column(points_table::checksum, std::move(checksums));
}

/// The columns of rows, of which one at least is done.
std::vector<CsvColumn> columns_of(const std::vector<PointRow>& rows, const std::vector<std::string>& probes,
                                  const std::vector<std::string>& bearings, const std::string& study)
{
    std::vector<CsvColumn> columns;
    std::vector<std::optional<SweepFigures>> figures;
    for (const auto& row : rows)
        figures.push_back(row.record ? std::optional(sweep_figures(*row.record)) : std::nullopt);
    const auto texts = [&](const schema::Column& column, auto&& of) {
        std::vector<std::string> values;
        for (const auto& row : rows)
            values.push_back(of(row));
        columns.push_back(csv_column(column, std::move(values)));
    };
    const auto numbers = [&](const schema::Column& column, auto&& of, const std::string& name = {}) {
        std::vector<double> values;
        for (const auto& found : figures)
            values.push_back(found ? of(*found) : no_value);
        columns.push_back(csv_column(column, std::move(values), name));
    };
    texts(points_table::point, [](const PointRow& row) { return row.point; });
    texts(points_table::state, [](const PointRow& row) { return std::string(state_name(row.outcome.state)); });
    texts(points_table::mark, [](const PointRow& row) { return row.mark; });
    texts(points_table::hash, [](const PointRow& row) { return row.record ? row.record->hash : std::string(); });
    texts(points_table::wall_time, [](const PointRow& row) { return fmt::format("{:.4g}", row.outcome.seconds); });
    for (const auto& [column, value] : drift_columns)
        numbers(column, [of = value](const SweepFigures& f) { return f.drift ? of(*f.drift) : no_value; });
    numbers(points_table::heat, [](const SweepFigures& f) { return f.joint_heat.value_or(no_value); });
    for (const auto& probe : probes)
        numbers(
            points_table::rise,
            [&](const SweepFigures& f) { return f.rises.contains(probe) ? f.rises.at(probe) : no_value; }, probe);
    for (const auto& bearing : bearings)
        numbers(
            points_table::bearing_force,
            [&](const SweepFigures& f) {
                return f.bearing_forces.contains(bearing) ? f.bearing_forces.at(bearing) : no_value;
            },
            bearing);
    texts(points_table::reason, [](const PointRow& row) { return row.outcome.reason; });
    columns.push_back(checksums_of(columns, study));
    return columns;
}

/// Reads the rows back by the headings of their columns.
class RowReader {
public:
    explicit RowReader(const CsvTable& table) : table_(table) {}

    [[nodiscard]] PointRow row(std::size_t index) const
    {
        const auto& cells = table_.rows[index];
        PointRow row;
        row.point = text(cells, points_table::point);
        row.mark = text(cells, points_table::mark);
        row.outcome.seconds = number(cells, points_table::wall_time);
        row.outcome.reason = text(cells, points_table::reason);
        const auto state = text(cells, points_table::state);
        if (state != state_name(State::done) && state != state_name(State::failed))
            throw InputError(fmt::format("{}:{}: '{}' is no state of a point\n  help: {}", table_.file,
                                         table_.lines[index], state, help));
        row.outcome.state = state == state_name(State::done) ? State::done : State::failed;
        if (row.outcome.state == State::done)
            row.record = record(cells);
        return row;
    }

private:
    using Cells = std::vector<std::string>;
    [[nodiscard]] double value(const std::string& cell) const
    {
        if (cell.empty())
            return no_value;
        double number = 0;
        const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
        if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(number))
            throw InputError(fmt::format("{}: '{}' is no number\n  help: {}", table_.file, cell, help));
        return number;
    }
    [[nodiscard]] std::string text(const Cells& cells, const schema::Column& column) const
    {
        return cells[table_.column(column.heading)];
    }
    [[nodiscard]] double number(const Cells& cells, const schema::Column& column) const
    {
        return value(text(cells, column));
    }
    [[nodiscard]] press::RunRecord record(const Cells& cells) const
    {
        press::RunRecord record;
        record.hash = text(cells, points_table::hash);
        record.time = {0, 0};
        if (const double largest = number(cells, points_table::largest); std::isfinite(largest)) {
            record.time[0] = number(cells, points_table::largest_time);
            record.chain["E_SW"] = {largest / micrometre, number(cells, points_table::end) / micrometre};
        }
        if (const double range = number(cells, points_table::range); std::isfinite(range)) {
            const double steady = number(cells, points_table::steady);
            record.gap = press::GapFigures{number(cells, points_table::first_hour) / micrometre, range / micrometre,
                                           std::isfinite(steady) ? std::optional(steady) : std::nullopt};
        }
        if (const double heat = number(cells, points_table::heat); std::isfinite(heat))
            record.joint_heat["all"] = {heat, heat};
        add_named(cells, record);
        return record;
    }
    void add_named(const Cells& cells, press::RunRecord& record) const
    {
        for (std::size_t c = 0; c < cells.size(); ++c) {
            const auto& heading = table_.columns[c].name;
            if (const auto bearing = schema::name_in(points_table::bearing_force.heading, heading); !bearing.empty()) {
                if (const double number = value(cells[c]); std::isfinite(number))
                    record.loads[bearing_path(bearing)] = number;
            } else if (const auto probe = schema::name_in(points_table::rise.heading, heading); !probe.empty()) {
                record.probes.push_back(probe);
                if (const double number = value(cells[c]); std::isfinite(number))
                    record.rises[probe] = {number, number};
            }
        }
    }

    const CsvTable& table_;
};

/// A line without its last cell, which has no comma.
std::string without_checksum(const std::string& line) { return line.substr(0, line.rfind(',')); }

/// Refuses rows that were edited, or that another study wrote.
void require_checksums(const CsvTable& table, const std::vector<std::string>& lines, const std::string& study)
{
    const auto column = table.column(points_table::checksum.heading);
    const auto heads =
        std::ranges::find_if(lines, [](const std::string& line) { return !line.empty() && !line.starts_with('#'); });
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        const auto& row = lines[static_cast<std::size_t>(table.lines[k]) - 1];
        if (table.rows[k][column] != checksum_of_row(study, without_checksum(*heads), without_checksum(row)))
            throw InputError(
                fmt::format("{}:{}: the row of point '{}' was changed after it was written: its checksum "
                            "does not fit\n  help: restore the row, or remove it to compute its point again",
                            table.file, table.lines[k], table.rows[k].front()));
    }
}

}  // namespace

press::RunRecord brief(const press::RunRecord& record)
{
    const auto gap = record.chain.find("E_SW");
    const bool drifts = gap != record.chain.end() && !gap->second.empty();
    const std::size_t last = record.time.size() - 1, row = drifts ? press::largest_gap_row(record) : last;
    auto result = record;
    result.time = {record.time[row], record.time[last]};
    result.chain.clear();
    result.joint_heat.clear();
    result.loads.clear();
    if (drifts)
        result.chain["E_SW"] = {gap->second[row], gap->second[last]};
    for (auto& [probe, rises] : result.rises)
        rises = {rises[row], rises[last]};
    const auto figures = sweep_figures(record);
    if (figures.joint_heat)
        result.joint_heat["all"] = {*figures.joint_heat, *figures.joint_heat};
    for (const auto& [bearing, force] : figures.bearing_forces)
        result.loads[bearing_path(bearing)] = force;
    return result;
}

PointTable::PointTable(std::filesystem::path file, const std::string& study, const std::vector<PointRow>& known)
    : file_(std::move(file)), study_(study)
{
    std::error_code ignored;
    if (known.empty())
        std::filesystem::remove(file_, ignored);
    else
        replace(known);
}

void PointTable::replace(const std::vector<PointRow>& rows)
{
    const auto done = std::ranges::find_if(rows, [](const PointRow& row) { return row.record.has_value(); });
    if (done != rows.end() && probes_.empty() && bearings_.empty()) {
        probes_ = done->record->probes;
        for (const auto& [bearing, force] : sweep_figures(*done->record).bearing_forces)
            bearings_.push_back(bearing);
    }
    const std::vector<std::string> comments{fmt::format("deadpoint {}", version), fmt::format("study {}", study_)};
    out_.close();
    write_table(file_, comments, columns_of(rows, probes_, bearings_, study_));
    out_.open(file_, std::ios::app | std::ios::binary);
}

void PointTable::add(const PointRow& row)
{
    waiting_.push_back(row);
    if (out_.is_open())
        out_ << csv_rows(columns_of(waiting_, probes_, bearings_, study_)) << std::flush;
    else if (row.record)
        replace(waiting_);
    else
        return;
    waiting_.clear();
    if (!out_)
        throw IoError(fmt::format("'{}' cannot be written\n  help: make room on the disk; the same command continues",
                                  file_.string()));
}

std::string checksum_of_row(const std::string& study, const std::string& headings, const std::string& row)
{
    return stable_hash(fmt::format("{}\n{}\n{}", study, headings, row));
}

std::vector<PointRow> read_points(const std::filesystem::path& file, const std::string& study)
{
    auto text = read_file(file, largest_result).value_or("");
    text.resize(text.rfind('\n') == std::string::npos ? 0 : text.rfind('\n') + 1);  // a part of a row may follow
    if (text.empty())
        return {};
    if (text.find(fmt::format("{}{}\n", study_line, study)) == std::string::npos)
        throw InputError(
            fmt::format("'{}' has points of another reduced model or base case\n  help: {}", file.string(), help));
    const auto table = parse_csv(text, file.string());
    require_checksums(table, lines_of(text), study);
    const RowReader reader(table);
    std::vector<PointRow> rows;
    for (std::size_t k = 0; k < table.rows.size(); ++k)
        rows.push_back(reader.row(k));
    return rows;
}

}  // namespace deadpoint::report
