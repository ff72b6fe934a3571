#pragma once

#include "deadpoint/diagnostic.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/read_options.hpp"
#include "deadpoint/result.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// A press: read from a case file and meshed once, it computes loads, heat and drift.
///
/// All functions throw the errors of error.hpp: InputError if the case, its geometry or an argument
/// is wrong, DomainError if a law leaves its valid range, ConvergenceError if a solver fails,
/// IoError for files. Messages state the error, its place and its remedy. An observer may be null;
/// warnings are then in the results only.
namespace deadpoint {

/// Where a run starts, and where it writes files.
struct RunOptions {
    std::filesystem::path folder = {};      ///< new folder for all files of `deadpoint run`; empty: none
    bool replace = false;                   ///< an existing folder that deadpoint wrote may be replaced
    std::filesystem::path start_from = {};  ///< a result folder whose final temperatures are the start; empty: the case
};

/// A press that was read. It can be moved but not copied. Only one thread at a time may use it.
class Press {
public:
    /// Reads and checks a case file.
    /// @throws CaseError with all mistakes; IoError if the file cannot be read
    static Press read(const std::filesystem::path& file, const ReadOptions& options = {});
    /// All mistakes and warnings of a case that `deadpoint check` prints; empty if there are none. Reads and meshes the
    /// case, and checks its loads, laws and dimension chain.
    /// @throws IoError if a file cannot be read
    static std::vector<Diagnostic> check(const std::filesystem::path& file, const ReadOptions& options = {});

    ~Press();
    Press(Press&&) noexcept;
    Press& operator=(Press&&) noexcept;

    /// The case's own name (machine.name).
    [[nodiscard]] const std::string& name() const;
    /// Warnings of reading.
    [[nodiscard]] const std::vector<Diagnostic>& warnings() const;
    /// The case as TOML, with overrides and shipped materials included.
    [[nodiscard]] std::string case_text() const;

    /// Meshes the parts and checks the mesh. Later calls return at once.
    MeshFigures mesh(Observer* observer = nullptr);
    /// Motion, joint forces and crankshaft loads over a turn.
    /// @param segment  of the operation, from 0; -1: the first in which the press runs
    /// @throws InputError if the press runs in no segment, or there is no such segment
    LoadsResult loads(int segment = -1, Observer* observer = nullptr);
    /// Friction heat, contact conductances and convection coefficients.
    /// @param segment as for loads(), or the first one if the press never runs
    HeatTables heat_tables(int segment = -1, Observer* observer = nullptr);
    /// Computes temperatures and drift over the operation, on the present mesh; numerics.accuracy
    /// is ignored (see refine() in study.hpp). A second run starts at the time steps. Collective
    /// over the ranks of the Session, which must be open.
    /// @throws InputError if there is no Session
    RunResult run(const RunOptions& options = {}, Observer* observer = nullptr);

    struct Implementation;
    /// For deadpoint itself.
    explicit Press(std::unique_ptr<Implementation> implementation);
    [[nodiscard]] const Implementation& implementation() const { return *implementation_; }

private:
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace deadpoint
