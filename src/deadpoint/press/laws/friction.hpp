#pragma once

#include "deadpoint/exchange/laws/operating_point.hpp"
#include "deadpoint/press/loads/loads_key.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace deadpoint::casefile {
struct CalibratedFriction;
}
namespace deadpoint::press {
struct LoadsResult;
}

namespace deadpoint {
class LawTable;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
struct Friction;
struct Segment;
}  // namespace deadpoint::casefile

/// Friction heat of a case: its friction laws with the duties of the joints over the turn.
namespace deadpoint::press {

class LoadsCache;
struct CalibratedAt;
struct FrictionHeat;
struct FrictionSummary;
struct KeptFriction;
struct LoadDuty;
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
    /// @param shared   loads and laws that other cases of this machine share; may be null
    /// All of them must outlive this.
    FrictionLaws(const casefile::Case& input, const Machine* machine, const LoadsResult* known,
                 LoadsCache* shared = nullptr);
    ~FrictionLaws();

    /// @throws InputError naming the friction law, if it needs loads and the case has no linkage,
    ///         or a size is missing or outside the law; as compute_loads
    const FrictionHeat& heat(const std::string& row, const casefile::Segment& segment);
    /// Its `heat` as a table, to the tolerance of LawTableRange; no law while the press stands still. @throws as heat()
    LawTable table(const std::string& row, const casefile::Segment& segment);

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
    [[nodiscard]] LoadsKey reference_key(const casefile::CalibratedFriction& friction) const;
    const LoadsResult& reference(const casefile::CalibratedFriction& friction);
    const LoadsResult& compute(const LoadsKey& key, const std::function<casefile::Case()>& input);
    void keep_warnings(const LoadsResult& loads, bool at_reference);
    [[nodiscard]] std::vector<RubbingJoint> rubbing_joints(const std::string& row, const LoadsResult& loads) const;
    [[nodiscard]] std::string inputs_of(const std::string& row, casefile::Friction friction) const;
    FrictionHeat computed_heat(const std::string& row, const casefile::Segment& segment);
    LoadDuty load_duty(const std::string& row, const std::string& inputs, const LoadsKey& key,
                       const LoadsResult& loads);
    std::optional<double> load_ratio(const std::string& row, const casefile::Segment& segment,
                                     const casefile::CalibratedFriction& friction);
    const CalibratedAt& calibrated_at(const std::string& row, const casefile::Segment& segment);
    LawTable calibrated_table(const std::string& row, const casefile::Segment& segment);
    FrictionHeat calibrated(const std::string& row, const casefile::Segment& segment);
    FrictionHeat physical(const std::string& row, const casefile::Segment& segment);
    LawTable physical_table(const std::string& row, const casefile::Segment& segment);
    std::shared_ptr<const FrictionHeat> unscaled_heat(const std::string& row, const casefile::Segment& segment);
    void contrast_bearings(FrictionSummary& result, const LoadsResult& loads);

    const casefile::Case& input_;
    const Machine* machine_;
    const LoadsResult* known_;
    LoadsCache* shared_;
    std::shared_ptr<KeptFriction> kept_;  ///< of this case, or of all with its loads
    using LawAt = std::pair<std::string, OperatingPoint>;
    std::map<LawAt, FrictionHeat> heats_;
    std::map<LawAt, CalibratedAt> calibrated_;
    std::map<LoadsKey, std::shared_ptr<const LoadsResult>> computed_;
    std::set<std::string> heard_;  ///< Warning::about of the loads' warnings so far
    std::vector<std::string> warnings_;
};

}  // namespace deadpoint::press
