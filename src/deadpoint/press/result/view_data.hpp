#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/decimated_surface.hpp"

#include <vector>

/// The machine over time, small enough for a page.
namespace deadpoint::press {

/// A quantity at vertices and times: base + sum over k of ViewData::coefficients[k] modes[k].
template <class Value>
struct ModalField {
    std::vector<Value> base;
    std::vector<std::vector<Value>> modes;  ///< the first of the modes, perhaps not all
};

struct ViewData {
    DecimatedSurface surface;
    std::vector<double> time;        ///< [s]
    double reference = 0;            ///< initial temperature [K]
    ModalField<double> temperature;  ///< [K]
    ModalField<Vec3> displacement;   ///< with the linkage closed [m]; empty where the case has no dimension chain
    std::vector<std::vector<double>> coefficients;  ///< [mode][time]
    double largest_rise = 0;                        ///< against the first time, either sign, in the whole machine [K]
    double error = 0;                               ///< largest, anywhere in the machine, by the modes left out [K]
};

}  // namespace deadpoint::press
