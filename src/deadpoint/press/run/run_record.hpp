#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint::press {

/// Figures of E_SW in summary.json.
struct GapFigures {
    double first_hour_change = 0;       ///< over the first hour, or a shorter run [m]
    double range = 0;                   ///< largest less smallest value of the run [m]
    std::optional<double> steady_from;  ///< time from which it moves more slowly than the case's limit [s]
};

/// The comparable results of a finished run, read from its folder by report/folder/read_result.hpp.
struct RunRecord {
    std::string folder;
    std::string machine;
    std::string hash;
    bool interrupted = false;
    double initial_temperature = 0;  ///< [K]
    std::vector<double> time;        ///< rows of history.csv [s]
    std::vector<std::string> probes;
    std::map<std::string, std::vector<double>> rises;  ///< by probe, at the rows [K]
    std::map<std::string, std::vector<double>> chain;  ///< by dimension ("E_SW"), at the rows [m]; empty without one
    std::map<std::string, std::vector<double>> joint_heat;  ///< by joint, whole press, at the rows [W]
    std::optional<GapFigures> gap;
    bool has_loads = false;
    std::map<std::string, double> loads;  ///< every number of loads.json by its path, in the unit of its name

    /// Keys that were fitted, from the case's [reference] with `calibrated_on`; empty if none.
    std::vector<std::string> calibrated_on;
    double calibrated_time = 0;                  ///< when the rises it was fitted to were read [s]
    std::vector<std::string> calibrated_probes;  ///< whose rises they are
};

/// Value at a time, linear between the rows.
double value_at(const RunRecord& run, const std::vector<double>& values, double time);

/// Row in which E_SW is largest in magnitude.
std::size_t largest_gap_row(const RunRecord& run);

}  // namespace deadpoint::press
