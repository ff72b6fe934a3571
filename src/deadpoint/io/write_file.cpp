#include "deadpoint/io/write_file.hpp"

#include "deadpoint/core/names/unique_name.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/rename.hpp"

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

[[noreturn]] void fail_writing(const fs::path& path, const std::string& reason)
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

/// A new, empty file beside `path`. @throws IoError
fs::path make_part(const fs::path& path)
{
    for (;;) {
        const fs::path part = unique_name(part_prefix(path));
        const int file = open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file >= 0) {
            close(file);
            return part;
        }
        if (errno != EEXIST) {
            fail_writing(path, system_reason());
        }
    }
}

void name_it(const fs::path& part, const fs::path& path, IfThere if_there)
{
    std::error_code error;
    if (if_there == IfThere::refuse) {
        error = rename_to_new(part, path);
    } else {
        fs::rename(part, path, error);
    }
    if (error == std::errc::file_exists) {
        throw IoError(fmt::format("'{}' exists already and is not overwritten\n  help: give another name, or move it "
                                  "away",
                                  path.string()));
    }
    if (error) {
        fail_writing(path, error.message());
    }
}

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

}  // namespace

std::string part_prefix(const fs::path& path) { return path.string() + ".part-"; }

bool sync_to_disk(const fs::path& path)
{
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    bool done = file >= 0 && fsync(file) == 0;
    const int reason = errno;
    done = done || (file >= 0 && reason == EINVAL);  // a file system that does not need this call
    if (file >= 0) {
        close(file);
    }
    errno = reason;
    return done;
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& fill, Durability durability,
                IfThere if_there)
{
    Unfinished unfinished{make_part(path)};
    errno = 0;
    std::ofstream out(unfinished.path, std::ios::binary | std::ios::trunc);
    if (!out) {
        fail_writing(path, system_reason());
    }
    fill(out);
    out.close();
    if (!out || (durability == Durability::synced && !sync_to_disk(unfinished.path))) {
        fail_writing(path, system_reason());
    }
    name_it(unfinished.path, path, if_there);
    unfinished.kept = true;
    if (durability == Durability::synced && !sync_to_disk(folder_of(path))) {
        fail_writing(path, system_reason());
    }
}

void write_file(const fs::path& path, std::string_view text, IfThere if_there)
{
    write_file(
        path, [&](std::ostream& out) { out << text; }, Durability::usual, if_there);
}

}  // namespace deadpoint
