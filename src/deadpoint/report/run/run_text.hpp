#pragma once

#include <cstddef>
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

namespace deadpoint::report {

enum class Detail { short_text, all };

/// The text that ends a run. Short: the gap with its causes and its warm-up, and the temperatures
/// of the probes. All: also loads, parts, parallelism, clearances, friction, preload, oil and
/// energy. Heat is that of the whole press.
std::string run_text(const casefile::Case& input, const press::RunResult& result, Detail detail);

/// The parts that move the gap most at the end, largest first.
std::vector<std::size_t> strongest_parts(const DriftSeries& drift);

}  // namespace deadpoint::report
