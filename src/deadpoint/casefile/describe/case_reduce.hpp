#pragma once

#include <array>

/// The reduced model of a case.
namespace deadpoint::casefile {

/// Ranges over which coefficients of a reduced model are free: factors on those of the case and, for temperatures,
/// differences to them. From 1 to 1, or from 0 to 0, holds them.
struct Reduce {
    std::array<double, 2> film{0.2, 5};
    std::array<double, 2> conductance{0.1, 10};
    std::array<double, 2> oil{0, 5};
    std::array<double, 2> friction{0.3, 3};
    std::array<double, 2> speed{1, 1};
    std::array<double, 2> force{1, 1};
    std::array<double, 2> oil_temperature{-10, 20};  ///< [K]
    std::array<double, 2> ambient{-10, 10};          ///< [K]
    bool together = false;      ///< films of a surface and conductances of an interface change together
    double temperature = 0.15;  ///< wanted error against the large model, after the first minute [K]
    double gap = 5e-8;          ///< the same of E_SW [m]
    int states = 300;           ///< at most
};

}  // namespace deadpoint::casefile
