#pragma once

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/drift/chain_figures.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "deadpoint/press/result/frame_result.hpp"
#include "deadpoint/press/result/reduced_result.hpp"
#include "deadpoint/reduce/online/box.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}
namespace deadpoint::reduce {
struct PreparedTerms;
}

/// A press as a reduced model: all that runs need, without a mesh.
namespace deadpoint::twin {

/// First line of the file of a reduced press.
inline constexpr std::string_view reduced_kind = "deadpoint reduced press 3\n";

/// The dimension chain and the gaps, whose functionals the terms have.
struct ReducedChain {
    press::ChainFigures figures;
    press::GapModel gaps;       ///< without its functionals
    std::size_t first_gap = 0;  ///< index of the first functional of a gap
};

struct ReducedPress {
    std::string version;     ///< of deadpoint, that built it
    std::string name;        ///< of the case
    std::string case_hash;   ///< of the case that was reduced
    std::string fixed_part;  ///< of that case: fixed_part()
    std::string large_file;  ///< name of the file beside this one with the large model; empty in that file itself
    Machine machine;         ///< without its mesh
    double size_scale = 1;   ///< on all cell sizes of the case
    std::size_t cells = 0;
    std::size_t unknowns = 0;
    std::size_t adjoints = 0;  ///< observed functionals that runs record with slopes
    double reference = 0;      ///< temperature without deformation [K]
    std::optional<ReducedChain> chain;
    std::optional<press::FrameResult> frame;
    std::size_t first_frame = 0;  ///< index of the first functional of the frame
    reduce::Box box;
    std::vector<press::StatedError> errors;
    std::vector<press::ErrorOfSize> sizes;  ///< that were tried
    std::size_t states = 0;
    std::shared_ptr<const reduce::PreparedTerms> terms;
};

/// What a reduced model cannot change of a case, as text: its bodies, parts, materials, contacts, surfaces, probes and
/// chain, other heat. Operating points, loads, friction, oil, conductances and convection may differ. STEP and mesh
/// files are in it by name and content. @throws IoError if such a file cannot be read
std::string fixed_part(const casefile::Case& input);
/// The same as a case, whose files are told by their paths.
casefile::Case fixed_case(const casefile::Case& input);

/// The file beside that of a reduced press with the fields of its states: press.rom, press.fields.rom.
std::filesystem::path fields_file(const std::filesystem::path& file);

/// Writes a reduced press (docs/rom-file.md). @throws IoError
void write_reduced(const std::filesystem::path& file, const ReducedPress& press);
/// @throws IoError if the file cannot be read, is of another format, was cut short or changed, or says with a right
///         checksum what does not fit: sizes, indices, numbers that are not finite, a large model elsewhere
ReducedPress read_reduced(const std::filesystem::path& file);
/// The same for a run or two, without what many runs share: that of a large model takes half a gigabyte.
ReducedPress read_reduced_for_few_runs(const std::filesystem::path& file);

}  // namespace deadpoint::twin
