#pragma once

#include "deadpoint/diagnostic.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/result.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// A press: read from a case file, meshed once, asked for loads, heat and drift.
///
/// All functions throw the errors of error.hpp: InputError where the case, its geometry or an argument is at fault,
/// DomainError where a law leaves its meaning, ConvergenceError where a solver fails, IoError for files. Messages say
/// what is wrong, where, and what to do about it. An observer may be null: then warnings are found in results only.
namespace deadpoint {

/// How a case file is read.
struct ReadOptions {
    std::vector<std::string> overrides = {};  ///< "path=value", as --set: "operation.0.speed=400 rpm"
    double size_scale = 1;                    ///< on all cell sizes, 0.01..100: 2 is coarser and faster
    bool allow_outside = false;               ///< the case may name files outside its own folder
};

/// What a run leaves besides its result.
struct RunOptions {
    std::filesystem::path folder = {};      ///< for result files, as of `deadpoint run`; it must not exist. Empty: none
    bool replace = false;                   ///< an existing folder that deadpoint wrote may be replaced
    std::filesystem::path start_from = {};  ///< a result folder whose final temperatures are the start; empty: the case
};

/// A press that was read. It can be moved, not copied; one thread at a time may use it.
class Press {
public:
    /// Reads and checks a case file.
    /// @throws CaseError with all that is wrong; IoError if the file cannot be read
    static Press read(const std::filesystem::path& file, const ReadOptions& options = {});
    /// What is wrong with a case file, warnings included; empty: nothing. Geometry is not looked at.
    /// @throws IoError if the file cannot be read
    static std::vector<Diagnostic> check(const std::filesystem::path& file, const ReadOptions& options = {});

    ~Press();
    Press(Press&&) noexcept;
    Press& operator=(Press&&) noexcept;

    /// The case's own name (machine.name).
    [[nodiscard]] const std::string& name() const;
    /// Warnings of reading.
    [[nodiscard]] const std::vector<Diagnostic>& warnings() const;
    /// The case as it is used, as TOML: overrides and shipped materials included.
    [[nodiscard]] std::string case_text() const;

    /// Meshes the parts and checks what only the mesh can tell; later calls return at once.
    MeshFigures mesh(Observer* observer = nullptr);
    /// Motion, joint forces and crankshaft loads over a turn.
    /// @param segment  of the operation, from 0; -1: the first in which the press runs
    /// @throws InputError if the press runs in no segment, or there is no such segment
    LoadsResult loads(int segment = -1, Observer* observer = nullptr);
    /// Friction heat, conductances and film coefficients.
    /// @param segment  as for loads(), or the first one where the press never runs
    HeatTables heat_tables(int segment = -1, Observer* observer = nullptr);
    /// Computes temperatures and drift over the operation, on the mesh at hand whatever accuracy the case asks for
    /// (study.hpp: refine). A second run starts at the time steps. Collective over the ranks of the Session, which
    /// must be open.
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
