#pragma once

#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/core/quantity.hpp"

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Measured or published values to compare a result with, as plain data in SI units. The model does
/// not use them.
namespace deadpoint::casefile {

class Visitor;

inline constexpr double same_time = 1e-9;  ///< relative; with it "3 h" is the end of a run of 10800 s

/// Keys that every value and claim of a reference file may have.
struct ReferenceNote {
    std::string point;  ///< operating point it belongs to; empty: the case as it stands
    std::string note;
};

/// Further keys that every value may have.
struct ReferenceValue : ReferenceNote {
    std::string group;  ///< values with the same group form a separate set; empty: values of its list without a group
    bool calibrated = false;  ///< some parameter was fitted to it, even if the case does not say so
};

struct ReferenceRises : ReferenceValue {
    double time = 0;                       ///< [s]
    std::map<std::string, double> values;  ///< by probe [K]
};

struct ReferenceCurve : ReferenceValue {
    enum class Measures { temperature, rise, E_SW, E_BG, E_WG, E_CS, E_BC };
    std::string name;
    std::string file;
    std::string column;
    std::string time_column = "time";
    std::string unit;                  ///< of the column, where its heading has none
    std::string time_unit;             ///< of the times, likewise
    std::optional<Measures> measures;  ///< stated once the file is read
    std::string probe;
    std::optional<double> until;  ///< later rows are left out [s]
    bool opposite_sign = false;   ///< for a dimension: the file has the opposite sign
    std::vector<double> time;     ///< read from the file [s]
    std::vector<double> value;    ///< [K], or [m] in the sign of the program
};

struct ReferenceChain : ReferenceValue {
    enum class At { time, largest, end };
    std::string dimension;  ///< "E_SW", ...
    std::optional<At> at;   ///< stated once the file is read
    std::optional<double> time;
    double value = 0;            ///< in the sign of the source [m]
    bool opposite_sign = false;  ///< the source has the opposite sign
};

struct ReferenceTime : ReferenceValue {
    enum class Of { largest_E_SW, share_of_rise };
    std::optional<Of> of;  ///< stated once the file is read
    std::string probe;
    double share = 0.95;
    double value = 0;  ///< [s]
};

struct ReferenceLoad : ReferenceValue {
    std::string quantity;  ///< path in loads.json: "crankshaft.rigid.seats.B.peak_y_N"
    std::optional<double> force, length, power, number;
};

/// A statement in words, in a form that can be checked.
struct ReferenceClaim : ReferenceNote {
    enum class Kind {
        hottest,
        warmer,
        slower,
        steady,
        share_reached,
        peak_within,
        declines,
        slows,
        closes,
        opens,
        unchecked
    };
    std::string text;
    std::optional<Kind> kind;  ///< stated once the file is read
    std::vector<std::string> probes;
    std::vector<std::string> than;
    std::optional<double> time;
    std::optional<double> at_least;  ///< [s]
    std::optional<double> at_most;   ///< [s]
    std::optional<double> share;
    std::string reason;  ///< why it cannot be checked
};

template <>
inline constexpr auto spelling<ReferenceCurve::Measures> =
    std::array<std::string_view, 7>{"temperature", "rise", "E_SW", "E_BG", "E_WG", "E_CS", "E_BC"};
template <>
inline constexpr auto spelling<ReferenceChain::At> = std::array<std::string_view, 3>{"time", "largest", "end"};
template <>
inline constexpr auto spelling<ReferenceTime::Of> = std::array<std::string_view, 2>{"largest_E_SW", "share_of_rise"};
template <>
inline constexpr auto spelling<ReferenceClaim::Kind> =
    std::array<std::string_view, 11>{"hottest",  "warmer", "slower", "steady", "share_reached", "peak_within",
                                     "declines", "slows",  "closes", "opens",  "unchecked"};

/// Another operating point: what to change in the case.
struct ReferencePoint {
    std::string description;
    std::vector<std::string> set;  ///< "path=value", as for --set
};

struct ReferenceFile {
    int format = 1;
    std::string name;
    std::string source;
    std::string note;
    std::map<std::string, ReferencePoint> points;
    std::vector<ReferenceRises> rises;
    std::vector<ReferenceCurve> curves;
    std::vector<ReferenceChain> chain;
    std::vector<ReferenceTime> times;
    std::vector<ReferenceLoad> loads;
    std::vector<ReferenceClaim> claims;
};

void describe(Visitor& v, ReferenceFile& f);
void describe(Visitor& v, ReferencePoint& p);
void describe(Visitor& v, ReferenceRises& r);
void describe(Visitor& v, ReferenceCurve& c);
void describe(Visitor& v, ReferenceChain& c);
void describe(Visitor& v, ReferenceTime& t);
void describe(Visitor& v, ReferenceLoad& l);
void describe(Visitor& v, ReferenceClaim& c);

/// Contents of a result that can be compared.
struct ResultContents {
    std::vector<std::string> probes;
    std::vector<std::string> dimensions;  ///< of the chain, empty without one
    std::vector<std::string> loads;       ///< paths of all figures in loads.json
    bool has_loads = false;               ///< without loads.json, loads are left out
    double end = 0;                       ///< of the run [s]
    bool interrupted = false;
};

/// Dimension of a figure in loads.json and its factor to SI, by the ending of its path ("_N", "_mm", "_um", "_W").
struct LoadUnit {
    Dimension dimension = Dimension::none;
    double factor = 1;
};
LoadUnit load_unit(std::string_view path);

/// Reads and checks a reference file with its curves, and keeps the values of one operating point.
///
/// @param path    TOML, format = 1
/// @param point   name of one of its points, or empty for values without one
/// @param result  to check that the result has the compared figures; may be null
/// @throws InputError whose text lists every mistake with file:line:column, the line and a remedy
/// @throws IoError if the file cannot be read
ReferenceFile read_reference(const std::filesystem::path& path, const std::string& point = "",
                             const ResultContents* result = nullptr);

/// The operating points of a reference file.
/// @throws InputError, IoError as read_reference, except errors about a result or a curve's file
std::map<std::string, ReferencePoint> reference_points(const std::filesystem::path& path);

}  // namespace deadpoint::casefile
