#include "ranks.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/fem/space/session.hpp"
#include "errors.hpp"
#include "interrupt.hpp"
#include "output.hpp"

using namespace deadpoint;
using report::ResultFolder;

int on_ranks(Console::Options options, const std::function<int(const OnRanks&)>& work)
{
    int argc = 0;
    char** argv = nullptr;
    const fem::Session session(argc, argv);
    catch_interrupts();  // after MPI, which installs its own handlers
    const bool first = session.rank() == 0;
    options.silent = !first;
    Console console(options);
    bool agree = true;
    try {
        const int exit_code = work({console, first, agree});
        flush_out();
        return exit_code;
    } catch (const Error& error) {
        if (session.size() == 1 || (agree && first)) {
            throw;
        }
        if (agree) {
            return error.exit_code();
        }
        console.finish();
        print_error(error);
        fem::abort_ranks(error.exit_code());
    }
}

void on_first_rank(bool first, const std::function<void()>& work)
{
    std::string error;
    if (first) {
        try {
            work();
        } catch (const IoError& reason) {
            error = reason.what();
        }
    }
    error = fem::from_first_rank(error);
    if (!error.empty()) {
        throw IoError(error);
    }
}

std::string start_folder(bool first, const std::function<std::unique_ptr<ResultFolder>()>& start,
                         std::unique_ptr<ResultFolder>& folder)
{
    on_first_rank(first, [&] { folder = start(); });
    return fem::from_first_rank(folder ? folder->path().string() : std::string{});
}
