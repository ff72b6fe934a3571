#pragma once

#include "deadpoint/core/error.hpp"

namespace deadpoint::heat {

/// A linear solve in which a value became infinite or not a number, or whose matrix holds such values.
struct NotFinite : ConvergenceError {
    using ConvergenceError::ConvergenceError;
};

}  // namespace deadpoint::heat
