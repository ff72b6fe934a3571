#include "deadpoint/io/read_file.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace deadpoint {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_reading(const fs::path& path, const std::string& reason)
{
    throw IoError(fmt::format("cannot read '{}': {}\n  help: check that it is a file and that you may read it",
                              path.string(), reason));
}

/// A regular file that is open for reading.
class OpenFile {
public:
    explicit OpenFile(const fs::path& path) : path_(path)
    {
        // Without O_NONBLOCK, opening a pipe would wait for a writer.
        file_ = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
        if (file_ < 0) {
            fail_reading(path_, std::strerror(errno));
        }
        struct stat status {};
        const bool known = fstat(file_, &status) == 0;
        if (!known || !S_ISREG(status.st_mode)) {
            close(file_);
            fail_reading(path_, known ? "it is not a regular file" : std::strerror(errno));
        }
        size_ = static_cast<std::uintmax_t>(status.st_size);
    }
    ~OpenFile() { close(file_); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    [[nodiscard]] std::uintmax_t size() const { return size_; }

    /// Reads as many bytes as possible into the buffer. @return bytes read; 0 at the end of the file
    std::size_t read_some(char* room, std::size_t count)
    {
        ssize_t here = 0;
        do {
            here = read(file_, room, count);
        } while (here < 0 && errno == EINTR);
        if (here < 0) {
            fail_reading(path_, fmt::format("{} after {} of {} bytes", std::strerror(errno), done_, size_));
        }
        done_ += static_cast<std::uintmax_t>(here);
        return static_cast<std::size_t>(here);
    }

    /// Checks that the file ends where its size says.
    void require_all() const
    {
        if (done_ != size_) {
            fail_reading(path_, fmt::format("{} bytes came of {}; the file changes while it is read, or its disk fails",
                                            done_, size_));
        }
    }

private:
    fs::path path_;
    int file_ = -1;
    std::uintmax_t size_ = 0;
    std::uintmax_t done_ = 0;
};

}  // namespace

std::optional<std::string> read_file(const fs::path& path, std::uintmax_t largest)
{
    std::error_code error;
    if (!fs::exists(path, error) && !error) {
        return std::nullopt;
    }
    OpenFile file(path);
    if (file.size() > largest) {
        throw InputError(fmt::format("{}: the file is larger than {} MiB, the most that is read\n  help: check that "
                                     "it is the file that is meant",
                                     path.string(), largest >> 20U));
    }
    std::string text(static_cast<std::size_t>(file.size()) + 1, '\0');  // one byte more, to detect a file that grows
    std::size_t done = 0;
    for (std::size_t here = 1; here > 0 && done < text.size(); done += here) {
        here = file.read_some(text.data() + done, text.size() - done);
    }
    file.require_all();
    text.pop_back();
    return text;
}

std::uintmax_t read_pieces(const fs::path& path, const std::function<void(std::string_view)>& take)
{
    OpenFile file(path);
    std::string piece(1U << 20U, '\0');
    for (std::size_t here = 1; here > 0;) {
        here = file.read_some(piece.data(), piece.size());
        take({piece.data(), here});
    }
    file.require_all();
    return file.size();
}

}  // namespace deadpoint
