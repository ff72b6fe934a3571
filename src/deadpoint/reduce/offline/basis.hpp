#pragma once

#include "deadpoint/reduce/online/box.hpp"

#include <optional>
#include <vector>

namespace deadpoint {
class Observer;
}

/// The first stage of a build: the basis of the large model.
namespace deadpoint::reduce {

class BuildCheckpoint;
class FullModel;
struct FieldChoice;
struct BuildOptions;

/// Adds the fields (shift M + K)^-1 load to the basis: sets of coefficients drawn from the box, the first ones those of
/// the problem itself; shifts between 1e-7 and 0.5 1/s; one load after the other from a shuffled list of all, and that
/// of E_SW in each set. Sets that were kept are not solved again.
/// @return weight of each field of the basis where the large model's are chosen; nothing after Observer::cancelled()
std::optional<std::vector<double>> add_fields(FullModel& full, const HeatProblem& base, const Box& box,
                                              const BuildOptions& options, const BuildCheckpoint& kept,
                                              Observer& observer);

/// Makes the basis orthonormal in M. Its first field is uniform; the choice says which of the others are dropped.
void orthonormalise(FullModel& full, const FieldChoice& choice, const BuildCheckpoint& kept);

}  // namespace deadpoint::reduce
