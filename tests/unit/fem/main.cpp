#define DOCTEST_CONFIG_IMPLEMENT
#include "deadpoint/fem/algebra/session.hpp"

#include <doctest/doctest.h>
#include <string>

/// Defined in embedded_session.cpp.
int embedded(const std::string& name);

// MPI and PETSc stay open while the tests run; what opens them in another way runs in a process of its own.
int main(int argc, char** argv)
{
    if (argc == 3 && std::string(argv[1]) == "--embed")
        return embedded(argv[2]);
    const deadpoint::fem::Session session(argc, argv);
    return doctest::Context(argc, argv).run();
}
