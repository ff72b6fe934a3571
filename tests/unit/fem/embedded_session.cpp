/// Requirement: who has opened MPI and PETSc keeps them, and a communicator of some ranks is all that is worked on.
#include "deadpoint/error.hpp"
#include "deadpoint/fem/algebra/session.hpp"

#include <doctest/doctest.h>
#include <petscsys.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

using namespace deadpoint;

namespace {

bool mpi_is_over()
{
    int finished = 0;
    MPI_Finalized(&finished);
    return finished != 0;
}

/// MPI and PETSc open once in a process, and the tests hold them open: so this runs by itself, as
/// `test_unit_fem --embed NAME`, before anything is opened. @return 0 if all is as it must be, else a number
int communicator_of_the_host()
{
    MPI_Init(nullptr, nullptr);
    MPI_Comm own = MPI_COMM_NULL;
    MPI_Comm_dup(MPI_COMM_SELF, &own);
    {
        const fem::Session session(fem::FortranCommunicator{MPI_Comm_c2f(own)});
        if (PETSC_COMM_WORLD != own || session.size() != 1 || !fem::is_open() || fem::ranks() != 1)
            return 1;
    }
    if (fem::is_open() || mpi_is_over())
        return 2;  // it closes its PETSc, not our MPI
    MPI_Finalize();
    return 0;
}

int petsc_of_the_host()
{
    PetscInitializeNoArguments();
    {
        const fem::Session session;
        if (session.rank() != 0 || session.size() != 1)
            return 1;
    }
    if (!fem::is_open() || mpi_is_over())
        return 2;
    PetscFinalize();
    return 0;
}

int no_mpi_for_a_communicator()
{
    try {
        const fem::Session session(fem::FortranCommunicator{0});
    } catch (const InputError& error) {
        return std::string(error.what()).find("MPI is not open") != std::string::npos ? 0 : 1;
    }
    return 2;
}

}  // namespace

int embedded(const std::string& name)
{
    if (name == "communicator")
        return communicator_of_the_host();
    if (name == "petsc")
        return petsc_of_the_host();
    return name == "without-mpi" ? no_mpi_for_a_communicator() : 99;
}

TEST_CASE("a session beside another one shares it and leaves it open")
{
    {
        const fem::Session session;
        CHECK(session.size() == fem::ranks());
        CHECK_NOTHROW(fem::Session(fem::FortranCommunicator{MPI_Comm_c2f(MPI_COMM_WORLD)}));
    }
    CHECK(fem::is_open());
    CHECK_FALSE(mpi_is_over());
}

TEST_CASE("a communicator that is none is refused")
{
    CHECK_THROWS_WITH_AS(fem::Session(fem::FortranCommunicator{MPI_Comm_c2f(MPI_COMM_NULL)}),
                         doctest::Contains("not the Fortran handle"), InputError);
}
