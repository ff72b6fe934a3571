#pragma once

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include "deadpoint/machine/geometry/foreign_mesh.hpp"

#include <string>
#include <utility>
#include <vector>

/// The solid of a part as it is meshed: chosen from its file, turned, without small features, cut in half.
namespace deadpoint::machine {

struct StepSolid;

struct SolidRules {
    double omit = 0;                          ///< holes and roundings up to this diameter are left out [m]; 0: none
    bool half = false;                        ///< keep x <= 0 of the machine only
    double position = 0;                      ///< of the solid along x of the machine [m]
    StepLetters letters = StepLetters::utf8;  ///< of the names in the file
};

/// Without types of Open CASCADE, to be handed from process to process.
struct ReadySolid {
    std::string shape;                                    ///< in Open CASCADE's binary form [mm]
    std::vector<std::pair<int, std::string>> face_names;  ///< by the number of the face in the shape
    std::vector<std::string> notes;                       ///< what was left out
};

/// Reads and prepares a solid in confined processes. Where leaving features out takes the kernel longer than a minute,
/// they all stay, and a note says so.
/// @throws IoError, InputError  as read_cad()
ReadySolid ready_solid(const ForeignFile& file, const StepSource& source, const SolidRules& rules,
                       const Waiting& waiting);

/// To be called in a confined process only.
StepSolid unpacked(const ReadySolid& solid);

}  // namespace deadpoint::machine
