#pragma once

#include "deadpoint/study/laws/loads_key.hpp"

#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace deadpoint::casefile {
struct CalibratedFriction;
}
namespace deadpoint::study {
struct LoadsResult;
}

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
struct Segment;
}  // namespace deadpoint::casefile

/// Friction heat of a case: its friction laws with the duties of the joints over the turn.
namespace deadpoint::study {

class LoadsCache;
struct FrictionHeat;
struct KnownLaws;
struct LoadRatio;
struct FrictionSummary;
struct RubbingJoint;

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
    /// @param shared   loads that are computed here and shared with other cases of this machine; may be null
    /// @param laws     loads and laws of other cases of this machine; may be null
    /// All of them must outlive this.
    FrictionLaws(const casefile::Case& input, const Machine* machine, const LoadsResult* known,
                 LoadsCache* shared = nullptr, const KnownLaws* laws = nullptr);

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
    /// All loads computed here so far.
    [[nodiscard]] const std::map<LoadsKey, std::shared_ptr<const LoadsResult>>& computed() const { return computed_; }

private:
    const LoadsResult& reference(const casefile::CalibratedFriction& friction);
    const LoadsResult& compute(const LoadsKey& key, const casefile::Case& input);
    void keep_warnings(const LoadsResult& loads, bool at_reference);
    [[nodiscard]] std::vector<RubbingJoint> rubbing_joints(const std::string& row, const LoadsResult& loads) const;
    FrictionHeat computed_heat(const std::string& row, const casefile::Segment& segment);
    LoadRatio load_ratio(const std::string& row, const casefile::Segment& segment,
                         const casefile::CalibratedFriction& friction);
    FrictionHeat calibrated(const std::string& row, const casefile::Segment& segment);
    FrictionHeat physical(const std::string& row, const casefile::Segment& segment);
    void contrast_bearings(FrictionSummary& result, const LoadsResult& loads);

    const casefile::Case& input_;
    const Machine* machine_;
    const LoadsResult* known_;
    LoadsCache* shared_;
    const KnownLaws* laws_;
    std::map<LoadsKey, std::shared_ptr<const LoadsResult>> computed_;
    std::set<std::string> heard_;  ///< Warning::about of the loads' warnings so far
    std::vector<std::string> warnings_;
};

}  // namespace deadpoint::study
