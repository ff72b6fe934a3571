#include "deadpoint/fem/session.hpp"

#include "deadpoint/fem/large_pages.hpp"
#include "deadpoint/fem/petsc.hpp"

#include <cstdlib>
#include <sys/resource.h>

namespace deadpoint::fem {

Session::Session(int& argc, char**& argv)
{
    int started = 0;
    MPI_Initialized(&started);
    if (!started)
        MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    ask_for_large_pages();
    // PETSc must neither read our command line nor catch our signals.
    PetscInitializeNoArguments();
    PetscPopSignalHandler();
}

Session::~Session()
{
    PetscFinalize();
    int finished = 0;
    MPI_Finalized(&finished);
    if (!finished)
        MPI_Finalize();
}

int rank()
{
    int started = 0, value = 0;
    MPI_Initialized(&started);
    if (started)
        MPI_Comm_rank(MPI_COMM_WORLD, &value);
    return value;
}

int ranks()
{
    int started = 0, value = 1;
    MPI_Initialized(&started);
    if (started)
        MPI_Comm_size(MPI_COMM_WORLD, &value);
    return value;
}

std::string from_first_rank(std::string text)
{
    unsigned long long size = text.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, MPI_COMM_WORLD);
    text.resize(size);
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
    return text;
}

void abort_ranks(int exit_code)
{
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();
}

double peak_memory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    double bytes = 1024.0 * static_cast<double>(usage.ru_maxrss);
    MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    return bytes;
}

}  // namespace deadpoint::fem
