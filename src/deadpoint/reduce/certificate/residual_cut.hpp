#pragma once

namespace deadpoint::reduce {

/// What certificates keep of the terms (reduce/certificate/directions.hpp).
struct ResidualCut {
    double kept = 1e-9;      ///< eigenvalues of a term, of its largest, whose vectors may be vectors of the full system
    double further = 1e-12;  ///< the same for products with the states
    double left = 1e-8;      ///< share of the heat in typical states that is in no vector of the full system
};

}  // namespace deadpoint::reduce
