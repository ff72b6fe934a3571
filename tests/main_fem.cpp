#define DOCTEST_CONFIG_IMPLEMENT
#include "deadpoint/fem/algebra/session.hpp"

#include <doctest/doctest.h>

// For tests that solve: MPI and PETSc stay open while they run.
int main(int argc, char** argv)
{
    int none = 0;
    char** nothing = nullptr;
    const deadpoint::fem::Session session(none, nothing);
    return doctest::Context(argc, argv).run();
}
