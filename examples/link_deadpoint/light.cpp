// How far does the press drift at another speed, and what does the drift depend on? Opens a reduced press (the file of
// `deadpoint reduce`) and runs its case in milliseconds; links no Gmsh, PETSc or MPI.
#include <cstdio>
#include <deadpoint/error.hpp>
#include <deadpoint/reduced_press.hpp>
#include <string>

int main(int argc, char** argv)
{
    if (argc != 4) {
        std::fprintf(stderr, "usage: light PRESS.rom CASE SPEED\n");
        return 2;
    }
    try {
        const auto press = deadpoint::ReducedPress::open(argv[1]);
        deadpoint::ReadOptions options;
        options.overrides = {std::string("operation.0.speed=") + argv[3]};
        const auto run = press.run(argv[2], options);
        for (const auto& warning : run.warnings)
            std::fprintf(stderr, "%s\n", warning.c_str());
        std::printf("gap at the end: %+.3f um\n", 1e6 * run.gap().values.back());
        for (const auto& of : press.derivatives(argv[2], options))
            std::printf("%-40s %+.4f um per %s\n", of.key.c_str(), 1e6 * of.gap,
                        of.unit.empty() ? "unit of its factor" : of.unit.c_str());
        return 0;
    } catch (const deadpoint::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return error.exit_code();
    }
}
