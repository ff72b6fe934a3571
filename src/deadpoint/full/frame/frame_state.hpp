#pragma once

#include "deadpoint/exchange/deformation.hpp"
#include "deadpoint/fem/space/fields.hpp"
#include "deadpoint/press/result/frame_result.hpp"

#include <optional>
#include <string>
#include <vector>

namespace deadpoint::casefile {
struct Foundation;
}

namespace deadpoint {

struct PartStress;
struct Machine;
}  // namespace deadpoint
namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::fem {
class Model;
}

/// Supports, weights and preload of the machine, and their results: forces of rods, closed bonds,
/// stress.
namespace deadpoint::full {

/// True if the case requests results of the deformation that need no dimension chain.
bool has_frame_state(const casefile::Case& input);

/// The supports of the feet.
Foundation describe_foundation(const casefile::Case& input, const Machine& machine);

/// Gauges of a machine with preload: its rods, and the bonds that they close.
struct FrameGauges {
    std::vector<ForceGauge> rods, bonds;
    std::vector<double> wanted;  ///< preload of each rod [N]
    press::FrameResult start;    ///< names and stated values of each
};

/// @throws CaseError for all preloads without a rod, rods that are preloaded twice and pairs that are not bonded
FrameGauges frame_gauges(const casefile::Case& input, const Machine& machine);

/// The machine under weights and preload, and its recorded forces. Collective, as fem::Model.
class FrameState {
public:
    /// @throws InputError for rods without supports, pairs that are not bonded, or weights without
    /// support
    FrameState(const casefile::Case& input, const Machine& machine, fem::Model& model);

    /// Adjoints of rods, then of closed bonds.
    [[nodiscard]] const std::vector<fem::Adjoint>& adjoints() const { return adjoints_; }
    /// Forces at the start of a run.
    [[nodiscard]] press::FrameResult start() const { return gauges_.start; }
    /// Adds stress and openings at one time; returns the data for the field file.
    std::vector<fem::PointData> add_time(const casefile::Case& input, double time, const fem::Field& temperature,
                                         const fem::Displacement& displacement, press::FrameResult& result) const;

private:
    [[nodiscard]] int finer_part(int bond) const;
    [[nodiscard]] std::vector<int> stressed_parts(const casefile::Case& input) const;
    [[nodiscard]] press::Opening opening(int bond, const PartStress& stress, double time) const;

    const Machine& machine_;
    fem::Model& model_;
    FrameGauges gauges_;
    RestLoads loads_;
    std::optional<fem::Displacement> at_rest_;
    std::vector<fem::Adjoint> adjoints_;
};

}  // namespace deadpoint::full
