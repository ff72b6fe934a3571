#pragma once

#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/core/quantity.hpp"

#include <array>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A calibration file, as `deadpoint calibrate` reads it.
namespace deadpoint::casefile {

struct Case;
class Visitor;

/// An unknown of the case, which drives one key or several.
struct CalibrationParameter {
    enum class Kind { factor, shift };
    std::string name;
    std::vector<std::string> keys;  ///< patterns; after reading: paths of the case
    Kind kind = Kind::factor;
    double factor = 0;         ///< of uncertainty, > 1; for Kind::factor
    std::string sigma;         ///< standard deviation with its unit; for Kind::shift
    std::string lower, upper;  ///< limits of the factor, or of the shift with its unit
    std::string place;         ///< after reading: "file:line"
    double prior = 0;          ///< after reading: standard deviation of ln(factor), or of the shift in SI units
    double least = 0;          ///< after reading: limits of ln(factor), or of the shift in SI units; 0 both: none
    double most = 0;
    Dimension dimension = Dimension::none;  ///< after reading: of the shift
};

/// The errors of one sensor or of several alike.
struct CalibrationSensor {
    std::vector<std::string> columns;   ///< patterns of columns, probes and dimensions
    std::string probe;                  ///< what it measures, where the column has another name
    std::string noise;                  ///< standard deviation with its unit
    std::string bias;                   ///< standard deviation of an unknown constant error with its unit
    std::string model_error;            ///< standard deviation of what the model is off in a slow course, with its unit
    double correlation_time = 0;        ///< [s]
    bool estimate_correlation = false;  ///< from the residuals
    std::optional<double> time_constant;    ///< of the sensor's lag [s]
    double time_constant_factor = 1;        ///< of its uncertainty; 1: known
    double model_sigma = 0;                 ///< after reading [K] or [m]; 0: only the stated error of the reduced model
    double sigma = 0;                       ///< after reading: noise [K] or [m]
    double bias_sigma = 0;                  ///< after reading [K] or [m]; 0: none
    Dimension dimension = Dimension::none;  ///< after reading: temperature difference or length
};

/// What a sensor measured in a run.
struct MeasuredCurve {
    std::string column;      ///< in the file
    std::string output;      ///< probe, or dimension such as "E_SW"
    bool of_gap = false;     ///< a dimension [m], else a temperature [K]
    bool rise = false;       ///< a temperature above that at the start
    std::size_t sensor = 0;  ///< its errors
    std::vector<double> time, value;
    std::string file;  ///< it was read from; empty: planned
};

/// A run of the press, measured or planned.
struct CalibrationRun {
    enum class Shows { temperature, rise };
    enum class Gaps { refuse, leave_out };
    std::string name;
    std::vector<std::string> set;  ///< "key=value", as for --set
    bool hold_out = false;
    std::string reference, point;  ///< a reference file and one of its operating points
    std::string data;              ///< a CSV file with a column for each sensor
    std::string time_column = "time";
    Shows shows = Shows::temperature;
    Gaps gaps = Gaps::refuse;
    std::vector<std::string> ignore;                        ///< patterns of columns that are not used
    std::optional<double> until;                            ///< [s]
    std::optional<double> interval;                         ///< between values that are used [s]
    std::vector<std::string> measure;                       ///< planned: probes and dimensions
    std::shared_ptr<const Case> input;                      ///< after reading
    std::vector<MeasuredCurve> curves;                      ///< after reading
    std::vector<std::shared_ptr<const Case>> alternatives;  ///< after reading: its case in each alternative
};

/// A further sensor or run that could be planned.
struct CalibrationCandidate {
    std::string name;
    std::string run;                    ///< in which the sensors are added; empty: all
    std::vector<std::string> set;       ///< of a new run
    std::vector<std::string> measure;   ///< probes and dimensions; of a new run by default all that are measured
    std::shared_ptr<const Case> input;  ///< after reading: of a new run
    std::vector<std::shared_ptr<const Case>> alternatives;  ///< after reading: the same in each alternative
};

/// Another model of the same press that may be as good. Its difference from the case's model counts as model error.
struct CalibrationAlternative {
    std::string name;
    std::string reduced;           ///< file of its reduced model; empty: that of the calibration
    std::vector<std::string> set;  ///< its differences from the case
    double share = 0;   ///< standard deviation of the error, as a multiple of the difference; 0: by the meshes
    std::string place;  ///< after reading: "file:line"
};

struct CalibrationOptions {
    int starts = 10;
    int samples = 0;
    double level = 0.9;
    double fixed_step = 120;  ///< [s]; 0: steps by accuracy
    bool profiles = true;
    std::string reduced;  ///< file of the reduced model
};

struct CalibrationFile {
    int format = 1;
    std::string name;
    std::string note;
    std::vector<CalibrationParameter> parameters;
    std::vector<CalibrationRun> runs;
    std::vector<CalibrationSensor> sensors;
    std::vector<CalibrationCandidate> candidates;
    std::vector<CalibrationAlternative> alternatives;
    CalibrationOptions options;
    std::vector<std::string> notes;  ///< after reading: what was not used, and why
};

template <>
inline constexpr auto spelling<CalibrationParameter::Kind> = std::array<std::string_view, 2>{"factor", "shift"};
template <>
inline constexpr auto spelling<CalibrationRun::Shows> = std::array<std::string_view, 2>{"temperature", "rise"};
template <>
inline constexpr auto spelling<CalibrationRun::Gaps> = std::array<std::string_view, 2>{"refuse", "leave_out"};

void describe(Visitor& v, CalibrationFile& f);
void describe(Visitor& v, CalibrationParameter& p);
void describe(Visitor& v, CalibrationRun& r);
void describe(Visitor& v, CalibrationSensor& s);
void describe(Visitor& v, CalibrationCandidate& c);
void describe(Visitor& v, CalibrationAlternative& a);
void describe(Visitor& v, CalibrationOptions& o);

/// Values of a curve beyond this number are left out evenly: its covariance is a full matrix.
inline constexpr std::size_t most_values_of_curve = 300;

/// The case that a calibration file is about.
struct CalibratedCase {
    std::filesystem::path path;
    std::vector<std::string> overrides;
    FileAccess files = FileAccess::below;
    /// Paths of the case that patterns name. @throws InputError for one that names none
    std::function<std::vector<std::string>(const Case&, const std::vector<std::string>&)> keys_of;
};

/// Reads and checks a calibration file with everything that it names.
/// @param plan  whether measured values may be missing
/// @throws InputError whose text lists every mistake with file:line:column, the line and a remedy; mistakes of the case
///         and of reference files are listed as for a run and for `compare`
/// @throws IoError if a file cannot be read
CalibrationFile read_calibration(const std::filesystem::path& path, const CalibratedCase& of, bool plan);

}  // namespace deadpoint::casefile
