#pragma once

#include "deadpoint/crankshaft/shaft/matrix.hpp"

/// A load that repeats every turn, the readings of its response, and the method of solution.
namespace deadpoint::crankshaft {

/// F(t) = sum over channels of pattern(:, channel) history(t, channel); linear between times evenly spaced over the
/// period, the first at 0, and periodic.
struct PeriodicLoad {
    double period = 0;  ///< [s]
    Matrix patterns;    ///< unknowns x channels
    Matrix histories;   ///< times x channels
};

/// Readings of the motion: y = D q + V q'.
struct Readings {
    Matrix displacement;  ///< readings x unknowns
    Matrix velocity;      ///< readings x unknowns
};

enum class PeriodicMethod { modal, harmonic_balance, newmark };

struct PeriodicSettings {
    PeriodicMethod method = PeriodicMethod::modal;
    int harmonics = 400;           ///< harmonic balance: of the turn
    int steps_per_sample = 4;      ///< Newmark
    int longest_run = 400;         ///< Newmark: turns until it must repeat
    double newmark_repeat = 1e-7;  ///< Newmark: change of the readings from turn to turn, relative to their largest
};

}  // namespace deadpoint::crankshaft
