#pragma once

#include <utility>
#include <vector>

namespace deadpoint {
struct DriftSeries;
struct Series;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::press {
struct RunResult;
}

/// Courses of a run at the times of its files.
namespace deadpoint::report {

/// Regular times of the history, with the end [s].
std::vector<double> history_times(const casefile::Case& input, const press::RunResult& result);

/// factor value + offset at times, cubic between the steps.
std::vector<double> sampled(const std::vector<double>& steps, const Series& series, const std::vector<double>& times,
                            double factor, double offset);

/// The same of quantities that are known only at the steps, linear between them.
std::vector<double> sampled_linear(const std::vector<double>& steps, const std::vector<double>& values,
                                   const std::vector<double>& times, double factor, double offset);

/// The dimensions of the chain by name, E_SW first.
std::vector<std::pair<const char*, const Series*>> dimensions(const DriftSeries& drift);

}  // namespace deadpoint::report
