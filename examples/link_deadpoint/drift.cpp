// How far does a press drift? Reads a case, runs it small, prints the gap at bottom dead point.
#include <cstdio>
#include <deadpoint/press.hpp>
#include <deadpoint/session.hpp>

int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: drift CASE\n");
        return 2;
    }
    try {
        const deadpoint::Session session;  // opens MPI and PETSc
        deadpoint::ReadOptions options;
        options.overrides = {"operation.0.duration=30 min", "numerics.time_tolerance=0.1 K"};
        options.size_scale = 3;  // coarse: some seconds
        auto press = deadpoint::Press::read(argv[1], options);
        const auto result = press.run();
        for (const double minutes : {5.0, 10.0, 20.0, 30.0})
            std::printf("gap after %2.0f min: %+.2f um\n", minutes, 1e6 * result.value(result.gap(), 60 * minutes));
        return 0;
    } catch (const deadpoint::CaseError& error) {
        for (const auto& mistake : error.diagnostics())
            std::fprintf(stderr, "line %d: %s: %s\n", mistake.place.line, mistake.path.c_str(),
                         mistake.message.c_str());
        return error.exit_code();
    } catch (const deadpoint::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return error.exit_code();
    }
}
