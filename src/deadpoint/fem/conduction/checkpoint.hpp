#pragma once

#include "deadpoint/io/binary_file.hpp"

#include <functional>
#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

/// What a run in time keeps of itself on disk, so that another process can go on from there.
///
/// A checkpoint holds all that the time steps have made: the field and its slopes, the scalars of every step, the
/// history, and the fields that were handed on. Mesh, matrices and the weights of functionals are computed again. It
/// belongs to one case, mesh and start, and any number of ranks can write it and go on from it: with the number that
/// wrote it the results are the same bit by bit, with another to the tolerance of the linear solver.
namespace deadpoint::fem {

/// A field that was handed to FieldCallback, this rank's share: exactly or rounded.
struct HandedField {
    double time = 0;  ///< [s]
    std::variant<std::span<const double>, std::span<const float>> owned;
};

struct CheckpointPlan {
    std::string file;       ///< of the checkpoint; its folder must exist
    std::string case_hash;  ///< of the case, casefile/files/write
    double interval = 600;  ///< least wall time from one to the next [s]; 0: after each step; infinite: never write
    bool resume = false;    ///< go on from the file
    /// All fields that were handed on so far, in order. They are handed on again when a run is resumed.
    std::function<std::vector<HandedField>()> handed_on;
};

/// What a checkpoint says of itself.
struct CheckpointHead {
    std::string version;    ///< of the program
    std::string case_hash;  ///< of the case, casefile/files/write
    std::string mesh;       ///< file_order's mesh_text()
    std::string start;      ///< hash of the temperatures from which the run started
    double time = 0;        ///< reached [s]
};
constexpr auto members(const CheckpointHead*)
{
    return std::tuple{&CheckpointHead::version, &CheckpointHead::case_hash, &CheckpointHead::mesh,
                      &CheckpointHead::start, &CheckpointHead::time};
}

/// Opens a checkpoint and reads its head.
/// @throws IoError if it cannot be read or is broken; InputError if another version or case wrote it
BinaryReader open_checkpoint(const std::string& file, const std::string& case_hash, CheckpointHead& head);

}  // namespace deadpoint::fem
