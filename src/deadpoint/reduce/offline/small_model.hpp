#pragma once

#include "deadpoint/reduce/offline/difference.hpp"
#include "deadpoint/reduce/online/box.hpp"

#include <Eigen/Dense>
#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace deadpoint {
class Observer;
}

/// The third stage of a build: the number of states.
namespace deadpoint::reduce {

struct BuildOptions;
struct PreparedTerms;
struct TypicalHeat;
class Ranks;

struct SmallModel {
    std::shared_ptr<const PreparedTerms> terms;
    Eigen::MatrixXd combinations;   ///< of states of the large model that are its states
    RunDifference at_base, in_box;  ///< to the large model: at the problem's own values, anywhere
    std::vector<std::pair<std::size_t, RunDifference>> by_size;  ///< number of states, largest difference in the box
};

/// The smallest of a series of sizes that is accurate enough in warm-ups that were not used for training, else the
/// largest. Collective. @return nothing after Observer::cancelled()
/// @param combinations  of states of the large model, most important first, a column for each
/// @param typical  by what the terms are cut
/// @param points  of operation, the case's own first
std::optional<SmallModel> choose_small(const std::shared_ptr<const PreparedTerms>& large,
                                       const Eigen::MatrixXd& combinations, const TypicalHeat& typical,
                                       const std::vector<HeatProblem>& points, const Box& box,
                                       const BuildOptions& options, const Ranks& ranks, Observer& observer);

}  // namespace deadpoint::reduce
