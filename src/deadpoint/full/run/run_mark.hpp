#pragma once

#include "deadpoint/fem/conduction/checkpoint.hpp"

namespace deadpoint::casefile {
struct Case;
}

/// When a run may continue another one.
namespace deadpoint::full {

/// The mark of a case's run. Two runs agree apart from their operation if one may be the beginning of the other: same
/// case, and the same first segment in which the press runs, whose loads place guides and load zones.
fem::RunMark run_mark(const casefile::Case& input);

}  // namespace deadpoint::full
