#pragma once

#include "deadpoint/core/quantity.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::casefile {
struct ReferenceClaim;
struct ReferenceFile;
struct ResultContents;
}  // namespace deadpoint::casefile

/// Comparison of a result with measured or published values.
namespace deadpoint::press {

struct RunRecord;

/// The list of a reference file that a value stands in.
enum class ValueKind { rises, chain, times, loads };
/// Its key there.
std::string_view name_of(ValueKind kind);

/// One value beside its reference, in SI units and the program's signs.
struct ComparedValue {
    ValueKind kind = ValueKind::rises;
    std::string group;  ///< as the reference file says, else the name of the kind
    std::string name;   ///< "P1 at 3 h"
    Dimension dimension = Dimension::none;
    double reference = 0;
    double computed = 0;
    std::optional<double> baseline;  ///< value of the baseline run
    bool calibrated = false;
    std::string note;
    /// Computed less reference; differences of a relative 1e-12 come from units and count as none.
    [[nodiscard]] double error() const;
    /// Error over the magnitude of the reference; nothing where that is zero.
    [[nodiscard]] std::optional<double> relative_error() const;
};

/// Error figures of a set of values. Errors are computed less reference.
struct ErrorFigures {
    std::size_t count = 0;
    double rms = 0;
    double bias = 0;             ///< mean error
    double largest = 0;          ///< error of largest magnitude, with its sign
    std::size_t largest_at = 0;  ///< its index
    /// Root mean square error of predicting that nothing changes: no rise, no drift. Only if that
    /// is meaningful.
    std::optional<double> rms_nothing;
    /// The same of predicting the mean of the references for each: a baseline that knows their level. Of two or more.
    std::optional<double> rms_mean;
    std::optional<double> rms_baseline;  ///< of the baseline run
};
/// @param nothing value if nothing changes; without it, no baselines
/// @throws DomainError if there are no values, or not one reference for each
ErrorFigures error_figures(const std::vector<double>& computed, const std::vector<double>& reference,
                           std::optional<double> nothing);

/// All values of one kind and group, fitted ones apart from predicted ones.
struct ComparedGroup {
    ValueKind kind = ValueKind::rises;
    std::string group;
    Dimension dimension = Dimension::none;
    bool calibrated = false;
    ErrorFigures figures;
    std::string largest_name;
};

struct ComparedCurve {
    std::string name;
    std::string measures;  ///< as the reference file says
    Dimension dimension = Dimension::none;
    std::vector<double> time;
    std::vector<double> reference;
    std::vector<double> computed;
    std::vector<double> baseline;  ///< empty without a baseline run
    bool calibrated = false;
    std::string note;
    ErrorFigures figures;
};

/// A claim in words and its verdict.
struct Verdict {
    enum class Outcome { holds, fails, unchecked };
    std::string text;
    std::string kind;  ///< as the reference file says
    Outcome outcome = Outcome::unchecked;
    std::string evidence;  ///< the numbers behind it, or why it is not checked
    std::string note;
};

struct Comparison {
    std::string reference;
    std::string source;
    std::string note;
    std::string point;
    std::string baseline;  ///< folder of the baseline run, empty without one
    std::vector<ComparedValue> values;
    std::vector<ComparedGroup> groups;
    std::vector<ComparedCurve> curves;
    std::vector<Verdict> verdicts;
    std::vector<std::string> warnings;
};

/// How well a result agrees with its reference, in one figure.
struct Agreement {
    /// 1 - sqrt(mean of (rms / rms_nothing)^2): 1 if all is as measured, 0 if it is as far off as predicting that
    /// nothing changes, below 0 if it is farther off.
    double value = 0;
    std::size_t sets = 0;     ///< groups and curves that count
    bool calibrated = false;  ///< whether the case was fitted to all of them
};

/// Over all groups and curves for which "nothing changes" is an answer: rises, temperatures and the dimension chain.
///
/// Each counts once, however many values it has, so that a recorded curve does not outweigh ten thermometers; errors
/// are related to the measured change, so that kelvins and micrometres count alike. Fitted values count only where
/// there are no others.
/// @return nothing if no set counts
std::optional<Agreement> agreement(const Comparison& comparison);

/// Contents of this result to which a reference file can refer.
casefile::ResultContents contents(const RunRecord& run);

/// Compares a run with the values of one operating point.
///
/// A value counts as calibrated if the file marks it so, or if it belongs to the unchanged case and
/// the case was fitted to the rise of that probe at that time. Values between two rows of the
/// history are interpolated linearly.
///
/// @param reference  read and checked against contents(run)
/// @param baseline   another run whose errors are also shown. If `run` is another operating point,
/// the base case shows the errors of predicting no change by the operating point. Checked likewise;
/// may be null
Comparison compare(const RunRecord& run, const casefile::ReferenceFile& reference, const std::string& point = "",
                   const RunRecord* baseline = nullptr);

/// The verdict on one claim.
Verdict judge(const RunRecord& run, const casefile::ReferenceClaim& claim);

}  // namespace deadpoint::press
