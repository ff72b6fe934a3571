#include "output.hpp"

#include "deadpoint/error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <iostream>
#include <stdio_ext.h>
#include <unistd.h>

namespace {

int first_failure = 0;  // first error of standard output, as errno

void note_failure(bool failed)
{
    if (failed && first_failure == 0) {
        first_failure = errno != 0 ? errno : EIO;
    }
}

}  // namespace

void write_out(std::string_view text)
{
    errno = 0;
    const auto shown = deadpoint::printable(text);
    note_failure(std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size());
}

void flush_out()
{
    errno = 0;
    if (std::fflush(stdout) != 0) {
        note_failure(true);
        __fpurge(stdout);  // otherwise libraries that flush it at exit fail on the rest
    }
}

void write_err(std::string_view text)
{
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
    std::clearerr(stderr);
}

void require_whole_output()
{
    flush_out();  // also flushes the text that CLI11 wrote to std::cout, which has no buffer of its own
    if (first_failure == 0 && std::ferror(stdout) == 0 && !std::cout.fail()) {
        return;
    }
    throw deadpoint::IoError(
        fmt::format("cannot write to standard output: {}\n  help: text was lost, but result files are not affected; "
                    "redirect standard output to a disk with room, or to a program that reads to the end",
                    first_failure != 0 ? std::strerror(first_failure) : "it failed"));
}

void open_missing_streams()
{
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) < 0 && errno == EBADF) {
            // Gets the lowest free number, which is this one.
            (void)open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}
