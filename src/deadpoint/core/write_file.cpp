#include "deadpoint/core/write_file.hpp"

#include "deadpoint/core/error.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>
#include <system_error>
#include <unistd.h>

namespace deadpoint {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& reason)
{
    throw IoError(fmt::format("cannot write '{}': {}\n  help: check that the folder exists, that you may write to it, "
                              "and that the disk has room",
                              path.string(), reason));
}

std::string system_reason() { return errno != 0 ? std::strerror(errno) : "the output stream failed"; }

/// Removes an unfinished file unless told that it was handed over.
struct Unfinished {
    fs::path path;
    bool kept = false;
    ~Unfinished()
    {
        std::error_code ignored;
        if (!kept) {
            fs::remove(path, ignored);
        }
    }
};

}  // namespace

bool sync_to_disk(const fs::path& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool done = file >= 0 && fsync(file) == 0;
    if (file >= 0) {
        close(file);
    }
    return done;
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& fill, Durability durability)
{
    fs::path part = path;
    part += ".part";
    errno = 0;
    std::ofstream out(part, std::ios::binary | std::ios::trunc);
    if (!out) {
        fail(path, system_reason());
    }
    Unfinished unfinished{part};
    fill(out);
    out.close();
    if (!out || (durability == Durability::synced && !sync_to_disk(part))) {
        fail(path, system_reason());
    }
    std::error_code error;
    fs::rename(part, path, error);
    if (error) {
        fail(path, error.message());
    }
    unfinished.kept = true;
    if (durability == Durability::synced) {
        sync_to_disk(path.has_parent_path() ? path.parent_path() : fs::path("."));  // the name
    }
}

void write_file(const fs::path& path, std::string_view text)
{
    write_file(path, [&](std::ostream& out) { out << text; });
}

}  // namespace deadpoint
