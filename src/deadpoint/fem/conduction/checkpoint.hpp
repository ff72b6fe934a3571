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
/// functionals are computed again. A checkpoint belongs to one case, mesh and start. Any number of
/// ranks can write it and continue from it: with the same number the results are equal bit by bit,
/// with another number to the tolerance of the linear solver.
namespace deadpoint::fem {

/// A field that was passed to FieldCallback, this rank's share: exactly or rounded.
struct HandedField {
    double time = 0;  ///< [s]
    std::variant<std::span<const double>, std::span<const float>> owned;
};

struct CheckpointPlan {
    std::string file;       ///< of the checkpoint; its folder must exist
    std::string case_hash;  ///< of the case, casefile/files/write
    double interval = 600;  ///< least wall time from one to the next [s]; 0: after each step; infinite: never write
    bool resume = false;    ///< continue from the file
    /// All fields passed on so far, in order. A resumed run passes them on again.
    std::function<std::vector<HandedField>()> handed_on;
};

/// Head of a checkpoint.
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
