#pragma once

#include "deadpoint/casefile/describe/case_films.hpp"

#include <optional>
#include <string>
#include <vector>

/// The part of a case about heating and cooling other than friction and room air.
namespace deadpoint::casefile {

/// Heat of a motor, a clutch or a belt.
struct HeatInput {
    std::vector<std::string> parts;  ///< uniform over their volume
    std::string surface;             ///< or over this surface
    std::optional<Course> power;     ///< of the whole press, time counted from the start of the run [W]
    bool at_rest = false;            ///< also while the press stands
};

/// Air inside the machine, which surfaces face instead of the room.
struct Enclosure {
    std::vector<std::string> surfaces;
    std::optional<double> volume;         ///< of the air, of the whole press [m3]
    std::optional<double> heat_capacity;  ///< instead of `volume`, of the whole press [J/K]
    std::optional<double> exchange;       ///< with the room, of the whole press [W/K]
    std::optional<double> air_changes;    ///< instead of `exchange`, per hour
    std::optional<double> temperature;    ///< at the start; else the machine's [K]
    std::optional<Course> power;          ///< into the air, of the whole press [W]
    bool at_rest = false;                 ///< also while the press stands
};

/// Circulating oil that flows through joints one after the other.
struct OilCircuit {
    std::vector<std::string> joints;  ///< in the order of the oil
    double flow = 0;                  ///< of the whole press [m3/s]
    std::string lubricant;
    double heat_capacity = 1900;              ///< [J/kg/K]
    std::optional<double> inlet_temperature;  ///< after a cooler; else the oil has the temperature of the sump [K]
    double sump_volume = 0;                   ///< oil in the sump; 0: its temperature follows at once [m3]
    double sump_loss = 0;                     ///< to the ambient [W/K]
    std::optional<double> sump_temperature;   ///< at the start; else the machine's [K]
    bool at_rest = false;                     ///< also flows while the press stands
};

}  // namespace deadpoint::casefile
