#pragma once

#include "deadpoint/report/schema/column.hpp"

#include <array>

/// The columns of every table, for writers and readers.
namespace deadpoint::report::schema {

inline constexpr Column time{"time", "time", "s", "time since the start of the run"};
inline constexpr Column gap{"gap", "E_SW", "um", "change of the gap between slide and table; above zero it opens"};

namespace history {
inline constexpr Column probe{"probe_temperature", "{probe}", "degC", "temperature of the probe"};
inline constexpr Column joint_temperature{"joint_temperature", "{joint} temperature", "degC",
                                          "mean temperature of both sides of all its contact surfaces"};
inline constexpr Column joint_heat{"joint_heat", "{joint} heat", "W", "friction heat of the joint"};
inline constexpr Column to_air{"heat_to_air", "heat to air", "W", "heat from all surfaces to the air"};
inline constexpr Column to_oil{"heat_to_oil", "heat to oil", "W", "heat from all joints to the oil"};
inline constexpr Column source{"source_heat", "source {source} heat", "W", "heat of a motor, clutch or similar source"};
inline constexpr Column bond_heat{
    "bond_heat", "{bond} heat flow", "W",
    "heat that crosses a bond with a conductance, from the first part of its pair to the second"};
inline constexpr Column oil_inlet{"oil_inlet", "oil {circuit} inlet", "degC",
                                  "temperature of the oil at the first joint"};
inline constexpr Column oil_outlet{"oil_outlet", "oil {circuit} outlet", "degC",
                                   "temperature of the oil after the last joint"};
inline constexpr Column oil_sump{"oil_sump", "oil {circuit} sump", "degC", "temperature of the oil in the sump"};
inline constexpr Column oil_heat{"oil_heat", "oil {circuit} heat", "W", "heat that the oil of the circuit takes up"};
inline constexpr Column oil_cooler{"oil_cooler", "oil {circuit} cooler", "W",
                                   "heat that the cooler removes; below zero a heater adds it"};
inline constexpr Column air{"enclosed_air", "air {enclosure} temperature", "degC", "temperature of the enclosed air"};
inline constexpr Column air_from_surfaces{"enclosed_air_from_surfaces", "air {enclosure} heat from surfaces", "W",
                                          "heat from its surfaces to the enclosed air"};
inline constexpr Column air_power{"enclosed_air_power", "air {enclosure} power", "W",
                                  "heat generated in the enclosure"};
inline constexpr Column air_to_room{"enclosed_air_to_room", "air {enclosure} heat to room", "W",
                                    "heat from the enclosed air to the room"};
inline constexpr Column dimension{"dimension", "{dimension}", "um",
                                  "change of a dimension of the chain at bottom dead point"};
inline constexpr Column rod_force{"rod_force", "{part} force", "kN", "force of a preloaded rod, tension above zero"};
inline constexpr Column bond_force{"bond_force", "{bond} force", "kN",
                                   "force across a bond that a preload closes, tension above zero"};
inline constexpr std::array all{time,      probe,       joint_temperature, joint_heat, to_air,
                                to_oil,    source,      bond_heat,         oil_inlet,  oil_outlet,
                                oil_sump,  oil_heat,    oil_cooler,        air,        air_from_surfaces,
                                air_power, air_to_room, dimension,         rod_force,  bond_force};
}  // namespace history

namespace contributions {
inline constexpr Column part{"part_share", "{part}", "um", "contribution of the part's warming to E_SW"};
inline constexpr std::array all{time, gap, part};
}  // namespace contributions

namespace causes {
inline constexpr Column cause{"cause", "cause", "",
                              "friction, heat source, surface, oil, air, start (--from) or remainder"};
inline constexpr Column name{"name", "name", "", "name of the joint, heat source or surface"};
inline constexpr Column share{"share", "share of E_SW after {time} s", "um",
                              "contribution of the heat of this cause to E_SW until that time"};
inline constexpr std::array all{cause, name, share};
}  // namespace causes

namespace sensitivities {
inline constexpr Column coefficient{"coefficient", "coefficient", "",
                                    "free coefficient of the reduced model, or operation.speed or operation.force"};
inline constexpr Column value{"value", "value", "", "its value in the first segment; 1 for a factor on several values"};
inline constexpr Column unit{"unit", "unit", "", "unit of the value; empty: a factor"};
inline constexpr Column change{"change", "change", "",
                               "change to which effects refer: a tenth of the value; 1 K for temperatures"};
inline constexpr Column gap_per_unit{"gap_per_unit", "E_SW per unit", "um",
                                     "derivative of E_SW at the end by the value, per unit of the value"};
inline constexpr Column gap_effect{"gap_effect", "E_SW by change", "um", "that derivative times the change"};
inline constexpr Column probe_per_unit{"probe_per_unit", "{probe} per unit", "K",
                                       "derivative of the probe at the end by the value, per unit of the value"};
inline constexpr Column probe_effect{"probe_effect", "{probe} by change", "K", "that derivative times the change"};
inline constexpr std::array all{coefficient,  value,      unit,           change,
                                gap_per_unit, gap_effect, probe_per_unit, probe_effect};
}  // namespace sensitivities

namespace gaps {
inline constexpr Column corner{"corner_gap", "gap {corner}", "um",
                               "change of the gap at a corner of the slide; above zero it opens"};
inline constexpr Column left_right{"slope_left_to_right", "slope left to right", "um/m",
                                   "slope of the slide against the table; above zero the gap opens to the right"};
inline constexpr Column front_back{"slope_front_to_back", "slope front to back", "um/m",
                                   "the same; above zero the gap opens to the back"};
inline constexpr Column clearance{"clearance", "clearance {clearance}", "um",
                                  "change of a clearance; below zero it closes"};
inline constexpr Column force{"force_change", "force change", "kN", "change of the force at a fixed die height"};
inline constexpr std::array all{time, corner, left_right, front_back, clearance, force};
}  // namespace gaps

namespace stress {
inline constexpr Column part{"part", "part", "", "part to which the stress belongs"};
inline constexpr Column von_mises{"von_mises", "largest von Mises", "MPa", "largest equivalent stress of the part"};
inline constexpr Column first{"first_principal", "first principal there", "MPa", "principal stress at that place"};
inline constexpr Column second{"second_principal", "second principal there", "MPa", "the same"};
inline constexpr Column third{"third_principal", "third principal there", "MPa", "the same"};
inline constexpr Column x{"x", "x", "mm", "of that place"};
inline constexpr Column y{"y", "y", "mm", "of that place"};
inline constexpr Column z{"z", "z", "mm", "of that place"};
inline constexpr Column highest{"highest_principal", "highest principal", "MPa", "of the whole part"};
inline constexpr Column lowest{"lowest_principal", "lowest principal", "MPa", "of the whole part"};
inline constexpr std::array all{time, part, von_mises, first, second, third, x, y, z, highest, lowest};
}  // namespace stress

namespace accuracy {
inline constexpr Column cells{"cells", "cells", "", "number of cells of the mesh"};
inline constexpr Column finer{"finer_parts", "finer parts", "", "parts that were meshed again for this mesh"};
inline constexpr Column figure{"figure", "{figure}", "{unit}", "E_SW [um], or the largest rise of a probe [K]"};
inline constexpr Column change{"change", "change", "{unit}",
                               "largest change from the previous mesh, at any time of the run"};
inline constexpr Column estimate{"estimate", "estimate", "{unit}", "estimated error of this mesh"};
inline constexpr Column worst{"worst_part", "worst part", "", "part with the largest share of the estimate"};
inline constexpr Column seconds{"wall_time", "time", "s", "computing time"};
inline constexpr std::array all{cells, finer, figure, change, estimate, worst, seconds};
}  // namespace accuracy

inline constexpr Column turn_time{"time", "time", "s", "time since bottom dead point"};
inline constexpr Column past_bottom{"crank_angle", "past bottom dead point", "deg",
                                    "crank angle past bottom dead point"};

namespace joints {
inline constexpr Column speed{"crank_speed", "crank speed", "rad/s", "of the driver"};
inline constexpr Column height{"slide_height", "slide height", "m", "above bottom dead point"};
inline constexpr Column slide_speed{"slide_speed", "slide speed", "m/s", "upwards"};
inline constexpr Column acceleration{"slide_acceleration", "slide acceleration", "m/s2", "upwards"};
inline constexpr Column process_force{"process_force", "process force", "N", "on the slide, upwards"};
inline constexpr Column torque{"drive_torque", "drive torque", "N m", "torque of the drive on the crank"};
inline constexpr Column force_x{"joint_force_x", "{joint} x", "N", "force on body_a by body_b, along x"};
inline constexpr Column force_y{"joint_force_y", "{joint} y", "N", "the same, upwards"};
inline constexpr Column moment{"joint_moment", "{joint} moment", "N m", "of a guide on body_a"};
inline constexpr Column turning{"joint_turning_speed", "{joint} sliding", "rad/s",
                                "of one body about the other in a pin"};
inline constexpr Column sliding{"joint_sliding_speed", "{joint} sliding", "m/s",
                                "of one body along the other in a guide"};
inline constexpr std::array all{past_bottom, turn_time, speed,   height, slide_speed, acceleration, process_force,
                                torque,      force_x,   force_y, moment, turning,     sliding};
}  // namespace joints

namespace bearings {
inline constexpr Column rigid_x{"rigid_bearing_force_x", "rigid {bearing} x", "N",
                                "force on the bearing by a rigid shaft, along x"};
inline constexpr Column rigid_y{"rigid_bearing_force_y", "rigid {bearing} y", "N", "the same, upwards"};
inline constexpr Column flexible_x{"flexible_bearing_force_x", "flexible {bearing} x", "N",
                                   "force on the bearing by the flexible shaft, along x"};
inline constexpr Column flexible_y{"flexible_bearing_force_y", "flexible {bearing} y", "N", "the same, upwards"};
inline constexpr Column pin_x{"pin_deflection_x", "pin deflection x", "m", "of the crank pin, along x"};
inline constexpr Column pin_y{"pin_deflection_y", "pin deflection y", "m", "of the crank pin, upwards"};
inline constexpr std::array all{past_bottom, turn_time, rigid_x, rigid_y, flexible_x, flexible_y, pin_x, pin_y};
}  // namespace bearings

namespace campbell {
inline constexpr Column speed{"speed", "speed", "rpm", "of the crankshaft"};
inline constexpr Column mode{"mode", "mode", "", "number of the natural frequency, from 1"};
inline constexpr Column frequency{"frequency", "frequency", "Hz", "natural frequency at this speed"};
inline constexpr Column whirl{"whirl", "whirl", "", "forward or backward"};
inline constexpr Column damping{"damping_ratio", "damping ratio of bearings", "",
                                "damping ratio of the mode by the bearings"};
inline constexpr std::array all{speed, mode, frequency, whirl, damping};
}  // namespace campbell

namespace joint_heat {
inline constexpr Column temperature{"temperature", "temperature", "degC", "of the joints"};
inline constexpr Column heat{"friction_heat", "{friction law}", "W", "heat of all joints with this friction law"};
inline constexpr std::array all{temperature, heat};
}  // namespace joint_heat

namespace conductances {
inline constexpr Column joint{"joint", "joint", "", "joint of the interface; empty: a bond"};
inline constexpr Column interface {
    "interface", "interface", "", "of the joint; of a bond its two parts"
};
inline constexpr Column law{"law", "law", "", "law of the contact conductance"};
inline constexpr Column area{"area", "area", "m2", "contact area, of the modelled half"};
inline constexpr Column pressure{"pressure", "pressure", "Pa", "contact pressure used by the law"};
inline constexpr Column pressure_from{"pressure_from", "pressure from", "", "loads or case"};
inline constexpr Column resistance{"resistance", "resistance", "m2 K/W", "resistance of both sides together"};
inline constexpr Column side_a{"side_a", "side a", "W/m2/K", "conductance from side a to the contact layer"};
inline constexpr Column side_b{"side_b", "side b", "W/m2/K", "conductance from side b to the contact layer"};
inline constexpr Column in_range{"in_range", "in range", "", "no: outside the range in which the law was tested"};
inline constexpr Column notes{"notes", "notes", "", "remarks of the law"};
inline constexpr std::array all{joint,      interface, law,    area,     pressure, pressure_from,
                                resistance, side_a,    side_b, in_range, notes};
}  // namespace conductances

namespace films {
inline constexpr Column surface{"surface", "surface", "", "of the case"};
inline constexpr Column law{"law", "law", "", "law of the convection coefficient"};
inline constexpr Column state{"state", "state", "", "running or at rest"};
inline constexpr Column length{"length", "length", "m", "characteristic length used by the law"};
inline constexpr Column ambient{"ambient", "ambient", "degC", "temperature of the air at the surface"};
inline constexpr Column rise{"rise", "rise", "K", "rise of the surface above the ambient"};
inline constexpr Column speed{"speed", "speed", "rad/s or m/s", "speed of a rotating or moving surface"};
inline constexpr Column convection{"convection", "convection", "W/m2/K", "convection coefficient"};
inline constexpr Column radiation{"radiation", "radiation", "W/m2/K", "the same for radiation"};
inline constexpr Column total{"total", "total", "W/m2/K", "their sum"};
inline constexpr Column in_range{"in_range", "in range", "", "no: outside the range in which the law was tested"};
inline constexpr std::array all{surface, law,        state,     length, ambient, rise,
                                speed,   convection, radiation, total,  in_range};
}  // namespace films

namespace names {
inline constexpr Column kind{"kind", "kind", "", "part, body, surface or interface"};
inline constexpr Column number{"number", "number", "", "number in mesh.vtu and surfaces.vtu"};
inline constexpr Column name{"name", "name", "", "name in the case"};
inline constexpr std::array all{kind, number, name};
}  // namespace names

namespace sweep {
inline constexpr Column set{"set", "set", "", "of the study"};
inline constexpr Column point{"point", "point", "", "folder below points/"};
inline constexpr Column state{"state", "state", "", "done, kept (computed before), failed or left (not computed)"};
inline constexpr Column axis{"axis", "{axis}", "", "step of the axis, as its label"};
inline constexpr Column axis_value{"axis_value", "{axis} value", "{unit}", "the same as a number"};
inline constexpr Column largest{"largest_gap", "largest E_SW", "um", "change of the gap that is largest in magnitude"};
inline constexpr Column largest_time{"time_of_largest_gap", "time of largest E_SW", "s", "time of that value"};
inline constexpr Column end{"gap_at_end", "E_SW at end", "um", "change of the gap at the end"};
inline constexpr Column first_hour{"gap_change_first_hour", "E_SW change in first hour", "um",
                                   "change of the gap over the first hour"};
inline constexpr Column range{"gap_range", "E_SW range", "um", "largest less smallest value of the run"};
inline constexpr Column steady{"steady_from", "steady from", "s",
                               "time from which the gap drifts by less than the limit"};
inline constexpr Column rise{"probe_rise", "{probe} rise", "K", "rise of the probe at the end"};
inline constexpr Column heat{"joint_heat", "joint heat", "W", "friction heat of all joints at the end"};
inline constexpr Column bearing_force{"bearing_peak_force", "peak force {bearing}", "N",
                                      "peak force on a bearing of the crankshaft"};
inline constexpr Column keeps{"keeps_limits", "keeps limits", "", "yes or no"};
inline constexpr Column window{"in_window", "in window", "", "yes: part of the best window of the set"};
inline constexpr Column wall_time{"wall_time", "wall time", "s", "computing time"};
inline constexpr Column reason{"reason", "reason", "", "why there is no result"};
inline constexpr std::array all{set,   point,  state, axis, axis_value,    largest, largest_time, end,       first_hour,
                                range, steady, rise,  heat, bearing_force, keeps,   window,       wall_time, reason};
}  // namespace sweep

/// Some are those of sweep.csv.
namespace points {
inline constexpr Column point{"point", "point", "", "name of the point"};
inline constexpr Column state{"state", "state", "", "done or failed"};
inline constexpr Column mark{"settings_hash", "settings hash", "",
                             "of the keys that the point sets, with their values"};
inline constexpr Column hash{"case_hash", "case hash", "", "of the point's case"};
inline constexpr auto wall_time = sweep::wall_time, largest = sweep::largest, largest_time = sweep::largest_time,
                      end = sweep::end, first_hour = sweep::first_hour, range = sweep::range, steady = sweep::steady,
                      heat = sweep::heat, rise = sweep::rise, bearing_force = sweep::bearing_force,
                      reason = sweep::reason;
inline constexpr Column checksum{"checksum", "checksum", "",
                                 "of the row, its headings and what all points have in common"};
inline constexpr std::array all{point,      state, mark,   hash, wall_time, largest,       largest_time, end,
                                first_hour, range, steady, heat, rise,      bearing_force, reason,       checksum};
}  // namespace points

/// One row for each figure and parameter; those of a screening are the last ones.
namespace indices {
inline constexpr Column output{"output", "output", "", "probe, dimension of the chain or corner"};
inline constexpr Column figure{"figure", "figure", "", "end, a time, or time to warm: 95 % of the change"};
inline constexpr Column parameter{"parameter", "parameter", "", "of the study"};
inline constexpr std::array first{
    Column{"first", "first", "", "Sobol' index of first order: share of the variance that it explains alone"},
    Column{"first_low", "first low", "", "lower end of its band of 90 %"},
    Column{"first_high", "first high", "", "upper end of its band of 90 %"}};
inline constexpr std::array total{Column{"total", "total", "", "total Sobol' index: with all interactions"},
                                  Column{"total_low", "total low", "", "lower end of its band of 90 %"},
                                  Column{"total_high", "total high", "", "upper end of its band of 90 %"}};
inline constexpr Column bound{"bound", "bound of total", "", "upper bound of the total index by derivatives"};
inline constexpr Column unit{"unit", "unit", "", "of the effects in this row"};
inline constexpr std::array strength{
    Column{"strength", "mu*", "", "mean size of the effect over the whole range of the parameter"},
    Column{"strength_low", "mu* low", "", "lower end of its band of 90 %"},
    Column{"strength_high", "mu* high", "", "upper end of its band of 90 %"}};
inline constexpr Column mean{"mean", "mu", "", "mean effect, with its sign"};
inline constexpr Column deviation{"deviation", "sigma", "", "standard deviation of the effect"};
inline constexpr std::array all{output,      figure,      parameter, first[0], first[1], first[2],
                                total[0],    total[1],    total[2],  bound,    unit,     strength[0],
                                strength[1], strength[2], mean,      deviation};
inline constexpr std::array over_time{output,      time,        parameter,   first[0], first[1],
                                      first[2],    total[0],    total[1],    total[2], unit,
                                      strength[0], strength[1], strength[2], mean,     deviation};
}  // namespace indices

namespace samples {
inline constexpr Column parameter{"parameter", "parameter {parameter}", "{unit}",
                                  "factor, shift or value of the parameter"};
inline constexpr Column figure{"figure", "{figure}", "{unit}", "output and figure, as in indices.csv"};
inline constexpr std::array all{parameter, figure};
}  // namespace samples

/// One row for each evaluation of a search for an optimum.
namespace search {
inline constexpr Column start{"start", "start", "", "number of the start; the first one is the case itself"};
inline constexpr Column stage{"stage", "stage", "",
                              "objective: the value is that of the study; else the largest rate over its limit"};
inline constexpr Column value{"value", "value", "", "of what the stage makes least, in the unit of optimise.json"};
inline constexpr Column exceeded{"exceeded", "exceeded", "",
                                 "largest exceeded limit, divided by 10 K, 10 um or the limit itself; 0: all are kept"};
inline constexpr Column variable{"variable", "variable {variable}", "{unit}", "factor, shift or value of the variable"};
inline constexpr std::array all{start, stage, value, exceeded, variable};
}  // namespace search

namespace courses {
inline constexpr Column gap{"gap_of_design", "E_SW, {design}", "um",
                            "change of the gap: before, optimum on the reduced model, optimum in full"};
inline constexpr Column rate{"rate_of_design", "rate of E_SW, {design}", "um/h", "its mean rate since the row before"};
inline constexpr std::array all{time, gap, rate};
}  // namespace courses

}  // namespace deadpoint::report::schema
