#pragma once

#include <complex>
#include <span>
#include <vector>

/// Forced vibration of the shaft at one frequency.
namespace deadpoint::crankshaft {

struct Shaft;
struct ShaftSystem;

/// Amplitude q of the response Re(q e^(i Omega t)) to a load Re(F e^(i Omega t)), Omega in [rad/s], any sign.
/// @throws InputError if sizes do not fit; DomainError at an undamped resonance
std::vector<std::complex<double>> harmonic_response(const ShaftSystem& system, double speed, double omega,
                                                    std::span<const std::complex<double>> force);

struct UnbalanceResponse {
    double speed = 0;  ///< [rad/s]
    std::vector<std::complex<double>>
        x;  ///< amplitude per node: x(t) = Re(x e^(i theta)), theta the throw's direction [m]
    std::vector<std::complex<double>> y;
    std::vector<std::complex<double>> bearing_x;  ///< force on every bearing by the shaft, with its damping [N]
    std::vector<std::complex<double>> bearing_y;
};

/// Response to the unbalance of disks and throw, m e omega^2 [cos, sin](theta + angle), at every speed.
/// @throws InputError as check_shaft; DomainError at an undamped critical speed
std::vector<UnbalanceResponse> unbalance_response(const Shaft& shaft, std::span<const double> speeds);

}  // namespace deadpoint::crankshaft
