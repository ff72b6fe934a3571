#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/heat.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

/// What foundation, preload and stress of the frame come to.
namespace deadpoint::press {

/// A preloaded rod.
struct RodForce {
    std::string part;
    std::string preload;    ///< name of its table in the case
    double start = 0;       ///< [N]
    Series change;          ///< by warming, at the steps [N]
    double held_share = 0;  ///< of the process force
};

/// Opening at one time of a bond that only preload holds together.
struct Opening {
    double time = 0;
    double largest = 0;  ///< tension [Pa]; negative: pressure everywhere
    Vec3 place{};        ///< of it
    double share = 0;    ///< of the bond's area under tension
};

/// A bond that only preload holds together.
struct ClosedBond {
    std::string name;  ///< "part|part"
    std::string preload;
    double area = 0;                ///< in this model [m2]
    double start = 0;               ///< force across it, tension positive [N]
    Series change;                  ///< by warming, at the steps [N]
    std::vector<Opening> openings;  ///< at the field times
};

/// The largest stress of a part at one time.
struct StressPeak {
    double time = 0;
    std::string part;
    double von_mises = 0;  ///< [Pa]
    Vec3 place{};
    std::array<double, 3> principal{};  ///< at that place, largest first [Pa]
    double highest_principal = 0;       ///< of the part [Pa]
    double lowest_principal = 0;        ///< of the part [Pa]
};

struct FrameResult {
    std::vector<RodForce> rods;
    std::vector<ClosedBond> bonds;
    std::optional<double> support_force;  ///< upwards on the feet, of the whole machine, where weights act [N]
    std::vector<StressPeak> stress;
};

}  // namespace deadpoint::press
