#pragma once

#include <string>

namespace deadpoint::fem {

/// An MPI communicator by its Fortran handle (MPI_Comm_c2f), which needs no header of MPI.
struct FortranCommunicator {
    int handle = 0;
};

/// Keeps MPI and PETSc open for the life of the program; make one in main() before using anything
/// else of this folder. It closes only what it opened: MPI or PETSc that ran before stay open. All
/// of this folder works on the ranks of PETSC_COMM_WORLD. Works without mpirun too (one rank).
class Session {
public:
    /// On all ranks, or on those of a PETSc that already runs; with choose_product_kernels().
    /// @throws InputError if the limit of memory leaves no room for the smallest case
    Session(int& argc, char**& argv);
    /// The same without a command line, for a program that is not ours: its products may run meanwhile, and keep their
    /// kernels.
    Session();
    /// On the ranks of a communicator. @throws InputError if MPI does not run, if there is no such communicator, or if
    /// PETSc already runs on other ranks; as above
    explicit Session(FortranCommunicator communicator);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;
    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }

private:
    void start_mpi(int* argc, char*** argv);
    void start_petsc();
    void count_ranks();

    int rank_ = 0;
    int size_ = 1;
    bool closes_mpi_ = false;
    bool closes_petsc_ = false;
};

/// @throws InputError if a limit of memory or of open files (ulimit -v, -n) leaves no room for MPI and the smallest
/// case; both would fail with messages of their own
void require_room();
/// From now on this process computes on one thread: with several ranks, each core has a process.
void use_one_thread();

/// True if MPI and PETSc are open.
bool is_open();

/// This process's number among the ranks, and their count. 0 and 1 before a Session exists.
int rank();
int ranks();

/// The text of rank 0, on all ranks; before a Session exists, this process's. Collective.
std::string from_first_rank(std::string text);
/// Ends all ranks at once, for an error that only this rank has found.
[[noreturn]] void abort_ranks(int exit_code);

/// Largest resident memory so far, summed over the ranks; memory that processes share counts once [byte]. Collective.
double peak_memory();

}  // namespace deadpoint::fem
