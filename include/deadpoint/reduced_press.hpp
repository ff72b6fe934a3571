#pragma once

#include "deadpoint/observer.hpp"
#include "deadpoint/read_options.hpp"
#include "deadpoint/result.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

/// A reduced press: the file of `deadpoint reduce`, on which a case runs in milliseconds, without meshes, Gmsh, PETSc
/// or MPI (target deadpoint::twin).
///
/// All functions throw the errors of error.hpp, as those of press.hpp. An observer may be null.
namespace deadpoint {

/// A coefficient that a reduced press leaves free, with the range for which it was trained.
struct FreeRange {
    std::string key;  ///< of the case: "surfaces.frame_air.coefficient"
    double from = 1;  ///< factor on the value of the case, or difference [K] of temperatures
    double to = 1;
};

/// How far a reduced press was off when it was built.
struct StatedAccuracy {
    std::string of;          ///< what was compared with what
    double temperature = 0;  ///< largest difference of a probe [K]
    double gap = 0;          ///< largest difference of E_SW [m]
};

/// How the end of a run depends on a coefficient.
struct Derivative {
    std::string key;                                           ///< of the case
    double value = 0;                                          ///< in the first segment; 1 for a factor [unit]
    std::string unit;                                          ///< of the value; empty: a factor
    double gap = 0;                                            ///< of E_SW [m per unit]; 0 without a dimension chain
    std::vector<std::pair<std::string, double>> temperatures;  ///< of each probe [K per unit]
};

/// Can be moved but not copied. Any number of threads may use it, and share what their runs have in common.
class ReducedPress {
public:
    /// @throws IoError if the file cannot be read or is broken
    static ReducedPress open(const std::filesystem::path& file);

    ~ReducedPress();
    ReducedPress(ReducedPress&&) noexcept;
    ReducedPress& operator=(ReducedPress&&) noexcept;

    /// Name of the case that was reduced.
    [[nodiscard]] const std::string& name() const;
    /// Number of states in place of the temperatures of the mesh.
    [[nodiscard]] std::size_t states() const;
    [[nodiscard]] std::vector<FreeRange> ranges() const;
    [[nodiscard]] std::vector<StatedAccuracy> accuracy() const;

    /// Computes temperatures and drift of a case of this press. The case may differ from the one that was reduced in
    /// operation, loads, friction, oil, conductances and convection; a warning names what leaves the ranges.
    /// @throws CaseError with all mistakes of the case; InputError if it is another press
    RunResult run(const std::filesystem::path& case_file, const ReadOptions& options = {},
                  Observer* observer = nullptr) const;
    /// How the end of that run depends on each free coefficient, on speed and on process force; the strongest first.
    /// @throws as run()
    [[nodiscard]] std::vector<Derivative> derivatives(const std::filesystem::path& case_file,
                                                      const ReadOptions& options = {},
                                                      Observer* observer = nullptr) const;

private:
    struct Implementation;
    explicit ReducedPress(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace deadpoint
