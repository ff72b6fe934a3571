#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/laws.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/exchange/operating_point.hpp"
#include "deadpoint/study/laws/friction_physics.hpp"
#include "deadpoint/study/pipeline/loads.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// Friction heat of a case: its friction laws with the duties of the joints over the turn.
namespace deadpoint::study {

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

/// Conditions for which loads are computed.
struct LoadsKey {
    OperatingPoint at;
    bool at_reference = false;  ///< of a calibrated law: with the flexible crankshaft
    double stiffness = 0;       ///< of its bearings at the reference [N/m]; 0: as the case has them
    auto operator<=>(const LoadsKey&) const = default;
};

/// The friction laws of a case. Loads are computed once for each operating point and reference that
/// they need. The duty of a law is that of all its joints with their images. The driver's joint has
/// the duties of its bearings by the shaft model of the case, if there is a [crankshaft]. Other
/// joints share their force equally among their elements; a slide has the sum of its faces' normal
/// forces (tribology::guide_normal_force).
///
/// A calibrated law with a reference force scales its load part with the sum of mean(F^1.33 |w|)
/// (rolling) or mean(F |w|) divided by that at the reference (reference speed and force, flexible
/// crankshaft, reference stiffness), and its viscous part with the speed. Without reference force,
/// both depend on the speed only.
class FrictionLaws {
public:
    /// @param machine  for masses that the case does not state; may be null where loads_need_machine() is false
    /// @param known    loads already computed, used at their speed and force; may be null
    /// All three must outlive this.
    FrictionLaws(const casefile::Case& input, const Machine* machine, const LoadsResult* known);

    /// @throws InputError naming the friction law, if it needs loads and the case has no linkage,
    ///         or a size is missing or outside the law; as compute_loads
    FrictionHeat heat(const std::string& row, const casefile::Segment& segment);

    /// All friction laws in a segment in which the press runs.
    FrictionSummary summary(const casefile::Segment& segment);

    /// summary() of every speed and force at which the press runs in the operation, in its order.
    std::vector<FrictionSummary> summaries();

    /// Warnings of the loads computed here and not `known`, each once and with its speed and force;
    /// then those of the summaries: laws whose joints carry no load at their reference, powers that
    /// do not agree, a motor that is too weak.
    [[nodiscard]] std::vector<std::string> warnings(const std::vector<FrictionSummary>& summaries) const;

    /// Loads at a segment's speed (not zero) and force.
    const LoadsResult& loads(const casefile::Segment& segment);

private:
    const LoadsResult& reference(const casefile::CalibratedFriction& friction);
    const LoadsResult& compute(const LoadsKey& key, const casefile::Case& input);
    void keep_warnings(const LoadsResult& loads, bool at_reference);
    [[nodiscard]] std::vector<RubbingJoint> rubbing_joints(const std::string& row, const LoadsResult& loads) const;
    FrictionHeat calibrated(const std::string& row, const casefile::Segment& segment);
    FrictionHeat physical(const std::string& row, const casefile::Segment& segment);
    void contrast_bearings(FrictionSummary& result, const LoadsResult& loads);

    const casefile::Case& input_;
    const Machine* machine_;
    const LoadsResult* known_;
    std::map<LoadsKey, std::unique_ptr<LoadsResult>> computed_;
    std::set<std::string> heard_;  ///< Warning::about of the loads' warnings so far
    std::vector<std::string> warnings_;
};

}  // namespace deadpoint::study
