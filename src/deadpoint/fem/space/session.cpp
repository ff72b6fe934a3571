#include "deadpoint/fem/space/session.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/fem/space/large_pages.hpp"
#include "deadpoint/fem/space/petsc.hpp"

#include <cstddef>
#include <cstdlib>
#include <fmt/format.h>
#include <petscblaslapack.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <vector>

namespace deadpoint::fem {

namespace {

/// Of addresses, beyond the program itself, for MPI, the workspace of products and a small case [byte].
constexpr std::size_t least_room = std::size_t{512} << 20;

/// @throws InputError where a limit (ulimit -v) leaves less, with which MPI fails in words of its own
void require_room()
{
    void* room = mmap(nullptr, least_room, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (room == MAP_FAILED) {
        rlimit limit{};
        getrlimit(RLIMIT_AS, &limit);
        throw InputError(
            fmt::format("the memory that this program may address is limited to {:.2f} GB, which leaves less "
                        "than the {:.2f} GB that the smallest case needs\n  help: raise the limit (ulimit -v "
                        "unlimited)",
                        1e-9 * static_cast<double>(limit.rlim_cur), 1e-9 * least_room));
    }
    munmap(room, least_room);
}

/// OpenBLAS asks for its workspace (some 128 MiB of addresses) at the first large product, and where there is none it
/// asks again for ever, deaf to a polite end. So it gets the workspace now, and keeps it.
void take_workspace_of_products()
{
    constexpr PetscBLASInt size = 256;  // too large for the kernels that need none
    constexpr PetscScalar one = 1;
    const std::vector<PetscScalar> factor(static_cast<std::size_t>(size) * size, one);
    std::vector<PetscScalar> product(factor);
    BLASgemm_("N", "N", &size, &size, &size, &one, factor.data(), &size, factor.data(), &size, &one, product.data(),
              &size);
}

}  // namespace

Session::Session(int& argc, char**& argv)
{
    require_room();
    take_workspace_of_products();
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
