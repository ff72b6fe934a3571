#pragma once

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

namespace deadpoint::study {

struct HeatTables;
struct LoadsResult;

/// The tables of a case in one segment of its operation, by the same laws as a run.
///
/// Joint heat at 20, 30, ... 70 degC; convection at 5, 10 and 20 K above the ambient at the
/// segment's start, at rest and at the segment's speed.
///
/// @param machine  may be null for a case without parts: then there are friction laws only
/// @param loads    for contact pressures and speeds that the case leaves out; may be null
/// @throws InputError, DomainError as the translations
HeatTables heat_tables(const casefile::Case& input, const Machine* machine, const LoadsResult* loads, int segment);

}  // namespace deadpoint::study
