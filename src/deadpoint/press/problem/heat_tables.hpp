#pragma once

#include "deadpoint/press/laws/conductance.hpp"
#include "deadpoint/press/result/friction_summary.hpp"

#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// Values of the laws of a case before any field is solved: friction heat, contact conductances, convection
/// coefficients.
namespace deadpoint::press {

struct LoadsResult;

/// Friction heat of a friction law, of the whole press.
struct JointHeat {
    std::string row;
    std::string law;
    std::string lubricant;
    std::vector<std::string> joints;  ///< that name the friction law
    std::vector<double> heat;         ///< at HeatTables::temperatures [W]
    std::vector<bool> in_range;
};

/// Coefficients of a surface at one rise above the ambient.
struct FilmValue {
    double speed = 0;       ///< of the surface's law [rad/s, or m/s if it moves]
    double rise = 0;        ///< [K]
    double convection = 0;  ///< [W/m2/K]
    double radiation = 0;
    bool in_range = true;
};

struct FilmTable {
    std::string surface;
    std::string law;
    double area = 0;     ///< of the modelled half [m2]
    double length = 0;   ///< of natural convection; 0: none [m]
    double ambient = 0;  ///< for which the values hold [K]
    std::vector<FilmValue> at_rest;
    std::vector<FilmValue> running;  ///< empty where speed changes nothing
};

struct HeatTables {
    int segment = -1;
    double speed = 0;                  ///< of the crank [rad/s]
    std::vector<double> temperatures;  ///< [K]
    std::vector<JointHeat> joints;
    std::vector<FrictionSummary> friction;  ///< at every speed and force of the operation
    std::vector<InterfaceConductance> conductances;
    std::vector<FilmTable> films;
    std::vector<std::string> warnings;
};

/// The tables of a case in one segment of its operation, by the same laws as a run.
///
/// Joint heat at 20, 30, ... 70 degC; convection at 5, 10 and 20 K above the ambient at the
/// segment's start, at rest and at the segment's speed.
///
/// @param machine  may be null for a case without parts: then there are friction laws only
/// @param loads    for contact pressures and speeds that the case leaves out; may be null
/// @throws InputError, DomainError as the translations
HeatTables heat_tables(const casefile::Case& input, const Machine* machine, const LoadsResult* loads, int segment);

}  // namespace deadpoint::press
