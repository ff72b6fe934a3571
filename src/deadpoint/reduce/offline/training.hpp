#pragma once

#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/online/box.hpp"

#include <memory>
#include <optional>
#include <vector>

namespace deadpoint {
class Observer;
}

/// The second stage of a build: the states that occur in warm-ups.
namespace deadpoint::reduce {

struct BuildOptions;
struct PreparedTerms;
class Ranks;

/// Second moments of states, over all training runs.
struct Training {
    Moments states;  ///< of the runs, after each step
    Moments duals;   ///< of the dual problems of E_SW and of the probes; zero where there are none
};

/// Computes the training runs of the large model, shared out over ranks and threads. Collective.
/// @param points  of operation, with constant convection coefficients
/// @return nothing after Observer::cancelled()
std::optional<Training> train(const std::shared_ptr<const PreparedTerms>& large, const std::vector<HeatProblem>& points,
                              const Box& box, const BuildOptions& options, const Ranks& ranks, Observer& observer);

/// A problem with values drawn from the box, at one of the points of operation: half of them with a pause of half an
/// hour.
HeatProblem drawn_problem(const std::vector<HeatProblem>& points, const Box& box, Draws& draws);
/// Several of them. The same seed draws the same ones.
std::vector<HeatProblem> drawn_problems(const std::vector<HeatProblem>& points, const Box& box, unsigned long long seed,
                                        int count);

}  // namespace deadpoint::reduce
