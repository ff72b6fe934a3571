#pragma once

#include <memory>

namespace deadpoint {

/// Keeps MPI and PETSc open, which the time steps need. Make one before the first Press::run() and
/// keep it to the end of main(). MPI or PETSc that the program opened itself stays open. MPI that a
/// Session opened cannot be opened again after the Session. Works without mpirun too (one rank).
class Session {
public:
    /// Uses all ranks of the program, or those of a PETSc that already runs.
    /// @throws InputError if the limit of memory (ulimit -v) leaves no room for the smallest case
    Session();
    /// Uses the ranks of a communicator of the program's own MPI, which must be open.
    /// @param communicator  its Fortran handle: MPI_Comm_c2f(comm), in Python comm.py2f()
    /// @throws InputError if MPI is not open, or PETSc already runs on other ranks
    explicit Session(int communicator);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// This process's number among the ranks, from 0.
    [[nodiscard]] int rank() const noexcept;
    [[nodiscard]] int size() const noexcept;

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace deadpoint
