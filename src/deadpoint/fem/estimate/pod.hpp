#pragma once

#include "deadpoint/fem/space/fields.hpp"

#include <cstddef>
#include <vector>

namespace deadpoint::fem {

/// Temperature fields of several times as few fields: T(t_j) = base + sum over k of coefficient[k][j] mode[k].
struct Pod {
    Field base;                ///< of the first time [K]
    std::vector<Field> modes;  ///< [K], strongest first
    std::vector<std::vector<double>> coefficients;
    std::vector<double>
        residual_energy;      ///< rms, over unknowns and times, of what the modes before k miss, over that of the rise
    double largest_rise = 0;  ///< of any unknown against the first time, either sign [K]
    double error = 0;         ///< largest difference to any of the fields anywhere [K]
};

/// Proper orthogonal decomposition by the method of snapshots (Sirovich 1987): modes are the
/// eigenvectors of the fields' inner products. The function keeps as many modes as bring the error
/// below `tolerance` times the largest rise, but at most `at_most`. Fields that depend linearly on
/// the temperature, such as the deformation, have the same coefficients.
///
/// Collective.
/// @param snapshots  this rank's share of each field [K], at least one
/// @throws InputError if there are none or they differ in length
Pod pod(const std::vector<std::vector<float>>& snapshots, double tolerance, std::size_t at_most);

}  // namespace deadpoint::fem
