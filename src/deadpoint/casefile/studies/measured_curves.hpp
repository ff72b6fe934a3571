#pragma once

#include "deadpoint/casefile/studies/calibration_file.hpp"

#include <functional>
#include <string>
#include <vector>

/// What the files of a calibration's run measured. Internal to casefile/.
namespace deadpoint::casefile {

/// Told of each mistake: key of the run, code, message, help.
using RunReport = std::function<void(const std::string& key, const std::string& code, const std::string& message,
                                     const std::string& help)>;

/// Probes and dimensions that a case has.
std::vector<std::string> outputs_of(const Case& input);
/// True for a dimension of the chain.
bool is_dimension(const std::string& output);

/// The sensor for a column, and what it measures; the first whose patterns match.
struct MatchedSensor {
    std::size_t sensor = 0;
    std::string output;
};
std::optional<MatchedSensor> sensor_of(const std::vector<CalibrationSensor>& sensors, const std::string& column);

/// Reads the files of a run whose case is known. Curves that are longer than most_values_of_curve are thinned.
/// @param notes  what is not used, and why
std::vector<MeasuredCurve> measured_curves(const CalibrationRun& run, const std::vector<CalibrationSensor>& sensors,
                                           const RunReport& report, std::vector<std::string>& notes);

/// Planned curves of a run: times at its interval, no values.
std::vector<MeasuredCurve> planned_curves(const std::vector<std::string>& outputs, const CalibrationRun& run,
                                          const std::vector<CalibrationSensor>& sensors, const RunReport& report);

}  // namespace deadpoint::casefile
