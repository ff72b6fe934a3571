#pragma once

#include "deadpoint/press/drift/drift_summary.hpp"
#include "deadpoint/press/run/run_record.hpp"

#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
struct DriftSeries;
}
namespace deadpoint::press {
struct RunResult;
}

namespace deadpoint::casefile {
struct Case;
}

/// The main figures of a run.
namespace deadpoint::press {

/// One probe against a published or measured rise.
struct ProbeComparison {
    std::string probe;
    double rise = 0;       ///< at the reference's time, or at the end of a shorter run [K]
    double reference = 0;  ///< [K]
};

/// The main figures of a run.
struct RunSummary {
    std::vector<ProbeComparison> comparison;
    double rms_residual = 0;  ///< of the comparison [K]
    double rms_null = 0;      ///< of predicting no rise at all [K]
    double largest_gap = 0;   ///< E_SW of largest magnitude [m]
    double largest_gap_time = 0;
    double final_gap = 0;
    std::optional<double> warm_up_time;        ///< |dE_SW/dt| stays below the case's limit from here on [s]
    std::vector<double> time_to_95;            ///< per probe: reaches 95 % of its own change for good [s]
    std::optional<CourseSummary> gap_course;   ///< of E_SW [m]
    std::vector<CourseSummary> probe_courses;  ///< [K]
};
RunSummary summarise(const casefile::Case& input, const RunResult& result);

/// Those of E_SW alone that a record keeps.
GapFigures gap_figures(const casefile::Case& input, const DriftSeries& drift);

/// Rise of a probe above the start of the case [K]. @param probe  index into RunResult::probes
double rise_at(const casefile::Case& input, const RunResult& result, std::size_t probe, double time);

}  // namespace deadpoint::press
