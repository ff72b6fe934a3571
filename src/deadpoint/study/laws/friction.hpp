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

/// Friction heat of a case: its rows of [friction], driven by what the joints go through over the turn.
namespace deadpoint::study {

/// Friction heat of one row in one segment, of the whole press.
struct FrictionHeat {
    std::string row;
    std::string law;
    std::vector<std::string> joints;   ///< that name the row
    HeatLaw heat;                      ///< [W] over temperature [K]
    std::optional<double> load_part;   ///< share of the heat that does not depend on temperature [W]; SKF has none
    RingHeatLaw ring_heat;             ///< added by the ring temperature difference; may be empty
    std::optional<double> load_ratio;  ///< duty of the load part over that at the reference, with a reference force
    bool unloaded = false;             ///< has a reference force, but there its joints carry no load: speed only
};

/// A bearing of the crankshaft, rigid over flexible shaft: ratio of what the load part follows.
struct BearingContrast {
    std::string bearing;
    double by_mean = 0;  ///< of mean(F^1.33 |w|)
    double by_peak = 0;  ///< of max(F)^1.33 mean(|w|)
};

/// What friction asks of the motor with all joints at one temperature.
struct FrictionPower {
    double temperature = 0;                ///< [K]
    double friction = 0;                   ///< of all rows [W]
    double motor = 0;                      ///< friction and process together [W]
    double torque = 0;                     ///< of friction at the crank, mean: friction over mean speed [N m]
    std::optional<double> share_of_motor;  ///< `motor` over the motor's stated power
};

/// Powers in the mean over the turn [W]. The linkage is computed without friction, so that drive and process must
/// agree: their difference checks the loads, while friction comes on top.
struct PowerBalance {
    double drive = 0;               ///< into the linkage
    double process = 0;             ///< out of it; an elastic die gives back what it takes
    double swing = 0;               ///< of the drive's magnitude: what comes and goes
    double rated = 0;               ///< of the motor, as stated with the belt; 0: not stated
    std::vector<FrictionPower> at;  ///< the case's initial temperature and 40 degC

    [[nodiscard]] double mismatch() const { return swing > 0 ? std::abs(drive - process) / swing : 0; }
};

/// Of PowerBalance::mismatch, above which the loads are warned about: a force that jumps between two crank positions
/// leaves some of it.
constexpr double power_tolerance = 0.01;

/// What friction comes to in one segment, for reports.
struct FrictionSummary {
    double speed = 0;
    double force = 0;
    std::vector<FrictionHeat> rows;
    std::vector<BearingContrast> bearings;
    /// True: both shafts under the loads of this case. False: this rigid case against the flexible shaft at the
    /// reference of the crankshaft's row, with its own course of the process force.
    bool same_loads = true;
    std::optional<PowerBalance> balance;
};

/// What loads are computed for.
struct LoadsKey {
    OperatingPoint at;
    bool at_reference = false;  ///< of a calibrated row: with the flexible crankshaft
    double stiffness = 0;       ///< of its bearings at the reference [N/m]; 0: as the case has them
    auto operator<=>(const LoadsKey&) const = default;
};

/// The friction laws of a case. Loads are computed once for each operating point and reference that they ask for.
///
/// The duty of a row is that of all its joints with their images: of the driver's joint, where there is a [crankshaft],
/// that of its bearings by the shaft model of the case; else the joint's force, shared evenly by its elements; on a
/// slide the sum of its faces' normal forces (tribology::guide_normal_force).
///
/// A calibrated row with a reference force scales its load part with sum of mean(F^1.33 |w|) (rolling) or mean(F |w|)
/// over that at the reference: reference speed and force, flexible crankshaft, reference stiffness; its viscous part
/// with the speed. Without reference force, both go with the speed only.
class FrictionLaws {
public:
    /// @param machine  for masses that the case does not state; may be null where loads_need_machine() is false
    /// @param known    loads already computed, used at their speed and force; may be null
    /// All three must outlive this.
    FrictionLaws(const casefile::Case& input, const Machine* machine, const LoadsResult* known);

    /// @throws InputError naming the row, if its law needs loads and the case has no linkage, or a size is missing or
    ///         outside the law; as compute_loads
    FrictionHeat heat(const std::string& row, const casefile::Segment& segment);

    /// All rows of a segment in which the press runs.
    FrictionSummary summary(const casefile::Segment& segment);

    /// summary() of every speed and force at which the press runs in the operation, in its order.
    std::vector<FrictionSummary> summaries();

    /// Warnings of the loads computed here and not `known`, each once and with its speed and force; then what the
    /// summaries show: rows whose joints carry no load at their reference, powers that do not agree, a motor too weak.
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
    std::set<std::string> heard_;  ///< what the warnings of loads so far were about
    std::vector<std::string> warnings_;
};

}  // namespace deadpoint::study
