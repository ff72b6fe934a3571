#pragma once

#include <complex>
#include <span>
#include <vector>

/// Free vibration of the shaft: natural frequencies, whirl and critical speeds.
namespace deadpoint::crankshaft {

struct ShaftSystem;

enum class Whirl { forward, backward, planar };

struct Mode {
    double frequency = 0;      ///< damped, of the oscillation [Hz]
    double damping_ratio = 0;  ///< of bearings and supports alone; negative: unstable
    Whirl whirl = Whirl::planar;
    /// Share of circular motion in the sense of the spin, summed over the nodes: 1 forward circles, 0 a line, -1
    /// backward circles. At speed 0 the sense is that from x to y.
    double circularity = 0;
    std::vector<std::complex<double>> x;  ///< amplitude per node, x(t) = Re(x e^(i 2 pi f t)); largest of all is 1
    std::vector<std::complex<double>> y;
};

/// Modes at a spin `speed` [rad/s], ascending, from lambda^2 M + lambda (C - omega G) + K = 0 without modal damping.
///
/// Solved for 1/lambda in the modes of the resting shaft, which keeps the low frequencies to 1e-11 relative. Modes that
/// do not oscillate are left out, and so are those above 1e6 times the fifth lowest of the resting shaft. `planar`:
/// less than 1e-6 of the motion is circular, or the speed is 0.
/// @param count  at most as many modes
/// @throws InputError if the bearings do not hold the shaft or it buckles under its axial load
std::vector<Mode> modes(const ShaftSystem& system, double speed, int count = 10);

/// modes() at every speed, the frequencies of the Campbell diagram.
///
/// Each in the lowest modes of the resting shaft only, four times `count` or more: doubled until those left out would
/// move no eigenvalue by more than 1e-6 relative (second-order estimate from the forces that they take up).
std::vector<std::vector<Mode>> campbell(const ShaftSystem& system, std::span<const double> speeds, int count = 10);

struct CriticalSpeed {
    double speed = 0;  ///< [rad/s]
    Whirl whirl = Whirl::planar;
};

/// Speeds at which a frequency equals `per_turn` times the speed, ascending: with Omega = per_turn omega the system
/// without damping is a Hermitian eigenproblem, K q = Omega^2 (M + i G / per_turn) q, solved at once and not read off
/// a grid. Damping and the skew part of K (oil film) are left out.
/// @param per_turn  1 for unbalance
/// @throws InputError as modes, or if per_turn is not positive
std::vector<CriticalSpeed> critical_speeds(const ShaftSystem& system, double per_turn = 1, int count = 10);

}  // namespace deadpoint::crankshaft
