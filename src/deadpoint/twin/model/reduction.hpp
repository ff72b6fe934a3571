#pragma once

#include "deadpoint/twin/model/reduced_press.hpp"

#include <memory>

namespace deadpoint::reduce {
struct ResidualTerms;
}

/// What the reduction of a case yields.
namespace deadpoint::twin {

/// A reduced model of a case in two sizes. The large one says how far the small one is off.
struct Reduction {
    ReducedPress small, large;
    /// Residual of the large one, if BuildOptions asks for a certificate.
    std::shared_ptr<const reduce::ResidualTerms> residual;
};

}  // namespace deadpoint::twin
