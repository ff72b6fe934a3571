#include "deadpoint/fem/algebra/session.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/huge_pages.hpp"
#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/algebra/product_kernels.hpp"

#include <cstddef>
#include <cstdlib>
#include <dlfcn.h>
#include <fmt/format.h>
#include <fstream>
#include <petscblaslapack.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <vector>

namespace deadpoint::fem {

namespace {

/// Addresses that MPI, the workspace of products and a small case take, beyond the program itself [byte].
constexpr std::size_t least_room = std::size_t{512} << 20;

/// Files that are open at a time: those of MPI, of a mesher's process and of the results [-].
constexpr rlim_t least_files = 48;

/// Raises the number of files that may be open at a time as far as the user may. @throws InputError if that is too low
void require_files()
{
    rlimit limit{};
    if (getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= least_files)
        return;
    limit.rlim_cur = limit.rlim_max;
    if (limit.rlim_max < least_files || setrlimit(RLIMIT_NOFILE, &limit) != 0)
        throw InputError(fmt::format("the number of files that this program may have open at a time is limited to {}, "
                                     "fewer than the {} that the smallest case needs\n  help: raise the limit (ulimit "
                                     "-n 1024)",
                                     limit.rlim_max, least_files));
}

/// OpenBLAS requests its workspace (some 128 MiB of addresses) at the first large product. If it gets none, it repeats
/// the request for ever and ignores interrupts. So it gets the workspace now, and keeps it.
void take_workspace_of_products()
{
    constexpr PetscBLASInt size = 256;  // too large for the kernels that work without a buffer
    constexpr PetscScalar one = 1;
    const std::vector<PetscScalar> factor(static_cast<std::size_t>(size) * size, one);
    std::vector<PetscScalar> product(factor);
    BLASgemm_("N", "N", &size, &size, &size, &one, factor.data(), &size, factor.data(), &size, &one, product.data(),
              &size);
}

/// What of the resident memory counts for other processes, if pages that are shared count for each in equal parts
/// [byte].
double shared_memory()
{
    double resident = 0, proportional = 0;
    std::ifstream in("/proc/self/smaps_rollup");
    for (std::string key; in >> key;) {
        if (key == "Rss:")
            in >> resident;
        if (key == "Pss:")
            in >> proportional;
    }
    return 1024 * (resident - proportional);
}

bool mpi_runs()
{
    int started = 0, finished = 0;
    MPI_Initialized(&started);
    MPI_Finalized(&finished);
    return started && !finished;
}

/// PETSc's communicator, or all ranks if PETSc does not run yet.
MPI_Comm communicator() { return is_open() ? PETSC_COMM_WORLD : MPI_COMM_WORLD; }

/// @throws InputError if the handle is not a communicator
MPI_Comm communicator_of(FortranCommunicator handle)
{
    if (!mpi_runs())
        throw InputError("a communicator was given, but MPI is not open\n  help: call MPI_Init before");
    const MPI_Comm result = MPI_Comm_f2c(handle.handle);
    if (result == MPI_COMM_NULL)
        throw InputError(fmt::format("{} is not the Fortran handle of a communicator\n  help: give what MPI_Comm_c2f "
                                     "returns, in Python comm.py2f()",
                                     handle.handle));
    return result;
}

/// @throws InputError if PETSc runs on other ranks
void require_same_ranks(MPI_Comm wanted)
{
    int alike = MPI_UNEQUAL;
    MPI_Comm_compare(wanted, PETSC_COMM_WORLD, &alike);
    if (alike != MPI_IDENT && alike != MPI_CONGRUENT)
        throw InputError("PETSc already runs on other ranks than those of the communicator\n  help: set "
                         "PETSC_COMM_WORLD before PETSc starts, or let the session start it");
}

}  // namespace

Session::Session(int& argc, char**& argv)
{
    choose_product_kernels();
    start_mpi(&argc, &argv);
    start_petsc();
    count_ranks();
}

Session::Session()
{
    start_mpi(nullptr, nullptr);
    start_petsc();
    count_ranks();
}

Session::Session(FortranCommunicator handle)
{
    const MPI_Comm wanted = communicator_of(handle);
    if (is_open())
        require_same_ranks(wanted);
    else
        PETSC_COMM_WORLD = wanted;
    start_mpi(nullptr, nullptr);
    start_petsc();
    count_ranks();
}

void Session::start_mpi(int* argc, char*** argv)
{
    require_room();
    take_workspace_of_products();
    if (mpi_runs())
        return;
    MPI_Init(argc, argv);
    closes_mpi_ = true;
}

void Session::start_petsc()
{
    if (is_open())
        return;
    ask_for_large_pages();
    // PETSc must neither read our command line nor catch our signals.
    DEADPOINT_PETSC(PetscInitializeNoArguments());
    PetscPopSignalHandler();
    closes_petsc_ = true;
}

void Session::count_ranks()
{
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank_);
    MPI_Comm_size(PETSC_COMM_WORLD, &size_);
}

Session::~Session()
{
    if (closes_petsc_)
        PetscFinalize();
    if (closes_mpi_ && mpi_runs())
        MPI_Finalize();
}

void require_room()
{
    require_files();
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

void use_one_thread()
{
    for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads"})
        if (void* function = dlsym(RTLD_DEFAULT, name))
            reinterpret_cast<void (*)(int)>(function)(1);
}

bool is_open()
{
    PetscBool started = PETSC_FALSE;
    PetscInitialized(&started);
    return started == PETSC_TRUE;
}

int rank()
{
    int value = 0;
    if (mpi_runs())
        MPI_Comm_rank(communicator(), &value);
    return value;
}

int ranks()
{
    int value = 1;
    if (mpi_runs())
        MPI_Comm_size(communicator(), &value);
    return value;
}

std::string from_first_rank(std::string text)
{
    if (ranks() == 1)
        return text;
    unsigned long long size = text.size();
    MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, communicator());
    text.resize(size);
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, communicator());
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
    if (ranks() == 1)
        return bytes;
    bytes -= shared_memory();
    MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_DOUBLE, MPI_SUM, communicator());
    return bytes;
}

}  // namespace deadpoint::fem
