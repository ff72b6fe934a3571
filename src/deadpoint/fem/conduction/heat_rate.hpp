#pragma once

#include "deadpoint/fem/space/petsc.hpp"

#include <cstddef>
#include <vector>

/// Internal to fem/: the heat balance at one time, and what is kept of it.
namespace deadpoint::fem {

/// An oil circuit at one time.
struct OilFlow {
    double inlet = 0;            ///< [K]
    double outlet = 0;           ///< [K]
    double sump = 0;             ///< [K]
    double sump_rate = 0;        ///< dT/dt of the sump; 0 if it follows at once [K/s]
    double sump_relaxation = 0;  ///< -d(sump_rate)/d(sump) [1/s]
    double heat = 0;             ///< from the joints [W]
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

/// The scalars of a heat balance: with them the balance is linear in the temperatures. All in the model.
struct StageRecord {
    double time = 0;                      ///< [s]
    std::vector<double> source_heat;      ///< per source, as booked [W]
    std::vector<double> body_heat;        ///< [W]
    std::vector<double> oil_temperature;  ///< per interface, as the solve took it [K]
    std::vector<double> film_mean;        ///< per film of HeatSolver: mean temperature of its surface [K]
    std::vector<double>
        variable_to_air;       ///< per surface condition whose film follows the temperature: all it loses [W]
    std::vector<AirFlow> air;  ///< per enclosure
};

/// Everything that enters the heat balance at one time: the rate vector F(t, T) - K T and its parts.
struct HeatRate : StageRecord {
    OwnedVec vector;                   ///< [W] per unknown
    std::vector<double> source_slope;  ///< of the model's heat by the mean film temperature's solid part [W/K]
    std::vector<double> source_temperature;
    std::vector<double> film;  ///< mean film temperature per interface [K]
    std::vector<OilFlow> oil;  ///< per circuit
    double generated = 0;
    double to_air = 0;
    double to_oil = 0;
    double flux = 0;
    bool in_range = true;
    std::vector<double> films_untested;  ///< per surface condition: area where its law is out of range [m2]
};

/// An accepted step, enough to run it backward.
struct StepRecord {
    std::size_t segment = 0;
    std::size_t row = 0;  ///< of the history that holds its end
    double duration = 0;  ///< [s]
    StageRecord start, middle, end;
};

}  // namespace deadpoint::fem
