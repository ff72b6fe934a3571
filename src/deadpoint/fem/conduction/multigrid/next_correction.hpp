#pragma once

/// Internal to fem/: when a solve of the heat may end.
namespace deadpoint::fem {

/// Expected norm of the next correction, B times the residual, before its cycle is run: it falls nearly as the residual
/// does (docs/theory.md, "Linear solves").
/// @param correction  norm of the last one
/// @param residual    norm of the present residual
/// @param before      norm of the residual that the last correction was made of, not 0
inline double next_correction(double correction, double residual, double before)
{
    constexpr double caution = 1.2;
    return caution * correction * residual / before;
}

}  // namespace deadpoint::fem
