#pragma once

#include "deadpoint/fem/petsc.hpp"

#include <vector>

/// Internal to fem/: the heat balance at one time.
namespace deadpoint::fem {

/// An oil circuit at one time.
struct OilFlow {
    double inlet = 0;   ///< [K]
    double outlet = 0;  ///< [K]
    double sump = 0;    ///< [K]
    double sump_rate = 0;
    double heat = 0;  ///< from the joints [W]
    double cooler = 0;
};

/// The air of an enclosure at one time.
struct AirFlow {
    double temperature = 0;    ///< [K]
    double from_surfaces = 0;  ///< [W]
    double power = 0;          ///< [W]
    double to_room = 0;        ///< [W]
    [[nodiscard]] double kept() const { return from_surfaces + power - to_room; }
};

/// Everything that enters the heat balance at one time: the rate vector F(t, T) - K T and its parts.
struct HeatRate {
    OwnedVec vector;  ///< [W] per unknown
    std::vector<double> source_heat;
    std::vector<double> source_slope;  ///< of the model's heat by the mean film temperature's solid part [W/K]
    std::vector<double> source_temperature;
    std::vector<double> body_heat;
    std::vector<double> film;  ///< mean film temperature per interface [K]
    std::vector<OilFlow> oil;  ///< per circuit
    std::vector<AirFlow> air;  ///< per enclosure
    double generated = 0;
    double to_air = 0;
    double to_oil = 0;
    double flux = 0;
    bool in_range = true;
    std::vector<double> films_untested;  ///< per surface condition: area where its law is out of range [m2]
};

}  // namespace deadpoint::fem
