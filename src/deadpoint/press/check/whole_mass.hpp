#pragma once

#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// Masses of a machine by its mesh, beside those that the case states.
namespace deadpoint::press {

/// Mass of one body of the whole machine, computed from its mesh.
///
/// In a half model a body that straddles the symmetry plane (one of its parts is cut, or lies
/// wholly on the far side) counts twice; any other body is one of a pair and counts once.
struct WholeMass {
    std::string body;
    int parts = 0;                 ///< modelled
    double computed = 0;           ///< [kg]
    std::optional<double> stated;  ///< in the case file [kg]
    bool partial = false;          ///< exists twice and is cut by the plane of symmetry: less than the body is modelled
    /// Computed over stated, less one; none if no mass is stated or the body is modelled in part
    /// only.
    [[nodiscard]] std::optional<double> deviation() const;
};
std::vector<WholeMass> whole_masses(const casefile::Case& input, const Machine& machine);

}  // namespace deadpoint::press
