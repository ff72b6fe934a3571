#pragma once

#include <functional>
#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

namespace deadpoint {
class BinaryReader;
}

/// The state of a run on disk, from which another process can continue.
///
/// A checkpoint holds all results of the time steps: the field and its slopes, the scalars of every
/// step, the history, and the fields already passed on. Mesh, matrices and the weights of
/// functionals are computed again. A checkpoint belongs to one mesh, start and case; the operation may differ after the
/// time reached, so that a run can be prolonged. Any number of ranks can write it and continue from it: with the same
/// number the results are equal bit by bit, with another number to the tolerance of the linear solver.
namespace deadpoint::fem {

/// A field that was passed to FieldCallback, this rank's share: exactly or rounded.
struct HandedField {
    double time = 0;  ///< [s]
    std::variant<std::span<const double>, std::span<const float>> owned;
};

/// The case of a run and its operation, as far as a run that continues from it must agree.
struct RunMark {
    std::string case_hash;              ///< of the case, casefile/files/write
    std::string apart_from_operation;   ///< hash of the case without its operation and the times of its fields
    std::vector<std::string> segments;  ///< hash of each segment without its duration
    std::vector<double> durations;      ///< of the segments [s]
    [[nodiscard]] double end() const;   ///< [s]
};
constexpr auto members(const RunMark*)
{
    return std::tuple{&RunMark::case_hash, &RunMark::apart_from_operation, &RunMark::segments, &RunMark::durations};
}

/// Times of the fields that a run passes on, ascending [s].
struct PlannedFields {
    std::vector<double> written;  ///< into files
    std::vector<double> viewed;   ///< for the page
};
constexpr auto members(const PlannedFields*) { return std::tuple{&PlannedFields::written, &PlannedFields::viewed}; }

struct CheckpointPlan {
    std::string file;       ///< of the checkpoint; its folder must exist
    RunMark run;            ///< what is computed
    double interval = 600;  ///< least wall time from one to the next [s]; 0: after each step; infinite: never write
    std::string from = {};  ///< the checkpoint to continue from; empty: none
    /// Where the state is kept from which a longer operation continues; empty: nowhere.
    std::string kept_file = {};
    PlannedFields fields = {};
    /// All fields passed on so far, in order. A resumed run passes them on again.
    std::function<std::vector<HandedField>()> handed_on;
};

/// Head of a checkpoint.
struct CheckpointHead {
    std::string version;  ///< of the program
    RunMark run;
    std::string mesh;   ///< file_order's mesh_text()
    std::string start;  ///< hash of the temperatures from which the run started
    double time = 0;    ///< reached [s]
    PlannedFields fields;
};
constexpr auto members(const CheckpointHead*)
{
    return std::tuple{&CheckpointHead::version, &CheckpointHead::run,  &CheckpointHead::mesh,
                      &CheckpointHead::start,   &CheckpointHead::time, &CheckpointHead::fields};
}

/// Opens a checkpoint and reads its head.
/// @throws IoError if it cannot be read or is broken; InputError if another version or case wrote it, or if the
///         operation of the run differs before the time reached
BinaryReader open_checkpoint(const std::string& file, const RunMark& run, CheckpointHead& head);
/// The head alone. @throws as open_checkpoint()
CheckpointHead checkpoint_head(const std::string& file, const RunMark& run);

}  // namespace deadpoint::fem
