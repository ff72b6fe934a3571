#pragma once

#include "deadpoint/casefile/case.hpp"
#include "deadpoint/exchange/laws.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/study/friction_physics.hpp"
#include "deadpoint/study/loads.hpp"

#include <map>
#include <memory>
#include <optional>
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

/// Power over the turn [W].
struct PowerBalance {
    double drive = 0;     ///< mean of the drive, of the linkage without friction
    double process = 0;   ///< mean of the process
    double friction = 0;  ///< all rows at `temperature`: what the motor gives besides
    double temperature = 0;
};

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

/// The friction laws of a case. Loads are computed once for each operating point and reference that they ask for.
///
/// The duty of a row is that of all its joints with their images: of the driver's joint, where there is a [crankshaft],
/// that of its bearings by the shaft model of the case; else the joint's force, shared evenly by its elements; on a
/// slide with gib preload P the sum of both faces, max(2 P, |F|). Left out: moments on guides.
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

    /// Loads at a segment's speed (not zero) and force.
    const LoadsResult& loads(const casefile::Segment& segment);

private:
    const LoadsResult& reference(const casefile::Friction& friction);
    const LoadsResult& compute(const std::string& key, const casefile::Case& input);
    [[nodiscard]] std::vector<RubbingJoint> rubbing_joints(const std::string& row, const LoadsResult& loads) const;
    FrictionHeat calibrated(const std::string& row, const casefile::Segment& segment);
    FrictionHeat physical(const std::string& row, const casefile::Segment& segment);
    void contrast_bearings(FrictionSummary& result, const LoadsResult& loads);

    const casefile::Case& input_;
    const Machine* machine_;
    const LoadsResult* known_;
    std::map<std::string, std::unique_ptr<LoadsResult>> computed_;
};

/// Warnings about rows whose joints carry no load at their reference, and so follow the speed only.
std::vector<std::string> friction_warnings(const std::vector<FrictionHeat>& rows);

}  // namespace deadpoint::study
