#pragma once

#include "deadpoint/exchange/laws/laws.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

/// The friction heat of a case at one operating point, by friction law, and the power it takes.
namespace deadpoint::press {

/// Friction heat of one friction law in one segment, of the whole press.
struct FrictionHeat {
    std::string row;
    std::string law;
    std::vector<std::string> joints;   ///< that name the friction law
    HeatLaw heat;                      ///< [W] over temperature [K]
    std::optional<double> load_part;   ///< share of the heat that does not depend on temperature [W]; SKF has none
    RingHeatLaw ring_heat;             ///< added by the ring temperature difference; may be empty
    std::optional<double> load_ratio;  ///< duty of the load part over that at the reference, with a reference force
    bool unloaded = false;  ///< has a reference force, but its joints carry no load there: depends on speed only
};

/// A bearing of the crankshaft: ratio of load duties, rigid over flexible shaft.
struct BearingContrast {
    std::string bearing;
    double by_mean = 0;  ///< of mean(F^1.33 |w|)
    double by_peak = 0;  ///< of max(F)^1.33 mean(|w|)
};

/// Friction and motor power with all joints at one temperature.
struct FrictionPower {
    double temperature = 0;                ///< [K]
    double friction = 0;                   ///< of all friction laws [W]
    double motor = 0;                      ///< friction and process together [W]
    double torque = 0;                     ///< of friction at the crank, mean: friction over mean speed [N m]
    std::optional<double> share_of_motor;  ///< `motor` over the motor's stated power
};

/// Powers in the mean over the turn [W]. The linkage is computed without friction, so drive and
/// process must agree: their difference checks the loads. Friction is added to the power of the
/// motor.
struct PowerBalance {
    double drive = 0;               ///< into the linkage
    double process = 0;             ///< out of it; an elastic die gives back what it takes
    double swing = 0;               ///< mean of the magnitude of the drive's power
    double rated = 0;               ///< of the motor, as stated with the belt; 0: not stated
    std::vector<FrictionPower> at;  ///< the case's initial temperature and 40 degC

    [[nodiscard]] double mismatch() const { return swing > 0 ? std::abs(drive - process) / swing : 0; }
};

/// Limit of PowerBalance::mismatch above which the program warns; a force that jumps between two
/// crank positions causes a part of it.
constexpr double power_tolerance = 0.01;

/// Figures of friction in one segment, for reports.
struct FrictionSummary {
    double speed = 0;
    double force = 0;
    std::vector<FrictionHeat> rows;
    std::vector<BearingContrast> bearings;
    /// True: both shafts under the loads of this case. False: this rigid case compared with the
    /// flexible shaft at the reference of the crankshaft's friction law, with its own course of the
    /// process force.
    bool same_loads = true;
    std::optional<PowerBalance> balance;
};

}  // namespace deadpoint::press
