#pragma once

#include "deadpoint/casefile/case.hpp"
#include "deadpoint/core/observer.hpp"
#include "deadpoint/exchange/machine.hpp"

namespace deadpoint::study {

/// Meshes a case's machine and settles which surface each exterior face belongs to.
///
/// A face answers to one condition (film, temperature, flux or insulation). One that a surface names by place (plane,
/// cylinder, box, group) is taken from the surfaces that select whatever is "exposed".
///
/// @throws InputError as build_machine(), or where two surfaces claim a face with equal right
Machine prepare_machine(const casefile::Case& input, double size_scale, Observer& observer);

}  // namespace deadpoint::study
