#pragma once

#include "console.hpp"
#include "deadpoint/io/resources.hpp"
#include "deadpoint/report/folder/result_folder.hpp"

#include <CLI/CLI.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

class Places;
class RankProcesses;

namespace deadpoint::fem {
class Session;
}

/// How many ranks the user wants; 0: as many as help, of the cores that other programs leave free.
struct RankOptions {
    int count = 0;
};

/// Adds --ranks.
void add_rank_options(CLI::App& command, RankOptions& options);

/// The ranks that do the work of a command together, one process each. If mpirun has started this program, they are all
/// there from the beginning. Else this process does alone what comes before the fields (it reads, checks, claims the
/// folder and meshes); spread() then forks the ranks from it, and they share that memory.
class Ranks {
public:
    /// @throws InputError if mpirun has started other than the wanted ranks, or if memory is limited too far
    Ranks(const RankOptions& wanted, Console& console);
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    Console& console;   ///< silent on all ranks but the first
    bool first = true;  ///< rank 0, or the only process yet
    /// True if all ranks find the same errors from here on. Work sets it to false where a single
    /// rank may find an error.
    bool agree = true;

    /// From here on all ranks run the program, each with MPI and PETSc open. Returns at once where they do already.
    /// Where no ranks can be started, this process goes on alone.
    /// @param cells  of the mesh, which decide how many ranks help; called only where that is to be decided
    void spread(const std::function<std::size_t()>& cells);
    /// Instead of spread(): this process works alone unless the user wants more ranks.
    void spread_if_wanted();
    /// Before spread(), which then starts no other ranks.
    /// @param what  needs one process: "a certificate" @throws InputError if the user wants more
    void stay_alone(const std::string& what);

    /// @throws InputError if mpirun has started several ranks
    /// @param command  that uses threads: "optimise"
    void require_one(const std::string& command) const;

    /// Shows an error that ended the work of this rank. @return the exit code, unless all ranks end here
    int explain_failure();

private:
    void open();
    void spread_to(int count);
    [[nodiscard]] int helpful(const std::function<std::size_t()>& cells) const;
    [[nodiscard]] bool start(int count);
    void begin_as_rank(int place, int count);

    RankOptions wanted_;
    deadpoint::OtherLoad others_;
    std::unique_ptr<Places> places_;            ///< in ranks that this program has started
    std::unique_ptr<RankProcesses> processes_;  ///< in ranks that this program has started
    std::unique_ptr<deadpoint::fem::Session> session_;
};

/// Lets work run on the ranks and returns its exit code. The first rank shows an error that all ranks find. An error
/// that a single rank may have found ends all ranks, since the others would wait forever.
int on_ranks(const RankOptions& wanted, const Console::Options& options, const std::function<int(Ranks&)>& work);

/// Work that only the first rank does, with files. Its IoError becomes that of all ranks.
void on_first_rank(bool first, const std::function<void()>& work);

/// Starts a result folder on the first rank. All ranks get its path, or the same error.
std::string start_folder(bool first, const std::function<std::unique_ptr<deadpoint::report::ResultFolder>()>& start,
                         std::unique_ptr<deadpoint::report::ResultFolder>& folder);

/// After spread(): a folder that was started before belongs to the first rank alone.
void leave_to_first(const Ranks& ranks, std::unique_ptr<deadpoint::report::ResultFolder>& folder);
