#pragma once

#include <string>

namespace deadpoint::fem {

/// Holds MPI and PETSc open for the life of the program; make one in main() before anything else of this folder.
/// Works without mpirun too (one rank).
class Session {
public:
    /// @throws InputError if the limit of memory leaves no room for the smallest case
    Session(int& argc, char**& argv);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }

private:
    int rank_ = 0;
    int size_ = 1;
};

/// This process's number among the ranks, and their count. 0 and 1 before a Session exists.
int rank();
int ranks();

/// The text of rank 0, on all ranks. Collective.
std::string from_first_rank(std::string text);
/// Ends all ranks at once; for an error that only this one has met.
[[noreturn]] void abort_ranks(int exit_code);

/// Largest resident memory so far, summed over the ranks [byte]. Collective.
double peak_memory();

}  // namespace deadpoint::fem
