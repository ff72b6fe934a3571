#pragma once

#include "deadpoint/exchange/machine.hpp"

#include <string>

/// Parts and surfaces of a machine by name, and how much of the press it models.
namespace deadpoint::press {

/// Share of the press that is modelled.
inline double modelled_share(const Machine& machine) { return machine.half_model ? 0.5 : 1.0; }

/// Index of a part by name, or -1.
int part_index(const Machine& machine, const std::string& name);
/// Index of a surface by name, or -1.
int surface_index(const Machine& machine, const std::string& name);

}  // namespace deadpoint::press
