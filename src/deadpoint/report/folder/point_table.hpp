#pragma once

#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/twin/map/sweep_plan.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

/// points.csv: a row for each point of a study that ended, written as it ends.
namespace deadpoint::report {

/// A point that ended.
struct PointRow {
    std::string point;  ///< its name
    std::string mark;   ///< of what it sets: a table is continued for points of the same mark
    twin::PointOutcome outcome;
    std::optional<press::RunRecord> record;  ///< of a point that is done: brief()
};

/// What tables and charts over points read of a run: the rows in which E_SW is largest and the last one, the heat of
/// all joints together, and the peak forces of bearings. So ten thousand of them take little memory.
press::RunRecord brief(const press::RunRecord& record);

/// Writes the table. A row is handed to the system at once, so a study that is killed keeps whole rows, and perhaps a
/// part of the last one. Columns follow from the first point that is done; rows before it wait for them.
class PointTable {
public:
    /// Replaces the table that is there, in one step, by rows that are known already.
    /// @param study  a mark of what all points have in common
    /// @throws IoError if it cannot be written
    PointTable(std::filesystem::path file, const std::string& study, const std::vector<PointRow>& known = {});
    /// @throws IoError
    void add(const PointRow& row);
    /// Replaces the table, in one step, by all rows in another order. @throws IoError
    void replace(const std::vector<PointRow>& rows);

private:
    std::filesystem::path file_;
    std::string study_;
    std::vector<std::string> probes_, bearings_;
    std::vector<PointRow> waiting_;
    std::ofstream out_;
};

/// The last cell of a row: of the study, the line of headings and the row, both without this cell.
std::string checksum_of_row(const std::string& study, const std::string& headings, const std::string& row);

/// The whole rows of a table, or none if there is no file.
/// @param study  the mark with which it was written
/// @throws InputError if it belongs to another study, or with the line of a row that was changed; IoError if it cannot
///         be read
std::vector<PointRow> read_points(const std::filesystem::path& file, const std::string& study);

}  // namespace deadpoint::report
