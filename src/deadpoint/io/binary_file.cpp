#include "deadpoint/io/binary_file.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fmt/format.h>

namespace deadpoint {
namespace {

constexpr std::uint64_t ending = 2 * sizeof(std::uint64_t);  // length and checksum

// The digits at the end of a first line "name-7\n" or "name 7\n"; empty if it is no such line.
std::string_view version_in(std::string_view line)
{
    if (!line.ends_with('\n'))
        return {};
    line.remove_suffix(1);
    const auto digits = line.substr(line.find_last_of("- ") + 1);
    const bool number = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
    return number && digits.size() < line.size() ? digits : std::string_view{};
}

// The version of a file that begins with `head`, if it is of the given kind but for its version; empty otherwise.
std::string_view other_version(std::string_view head, std::string_view kind)
{
    const auto line = head.substr(0, head.find('\n') + 1);
    const auto found = version_in(line), wanted = version_in(kind);
    if (found.empty() || wanted.empty() || found == wanted)
        return {};
    const auto name = [](std::string_view whole, std::string_view version) {
        return whole.substr(0, whole.size() - version.size() - 1);  // with what parts it from its version
    };
    return name(line, found) == name(kind, wanted) ? found : std::string_view{};
}

}  // namespace

BinaryWriter::BinaryWriter(std::ostream& out, std::string_view kind) : out_(out)
{
    put_bytes(kind.data(), kind.size());
}

void BinaryWriter::put_bytes(const void* data, std::size_t size)
{
    const std::string_view bytes(static_cast<const char*>(data), size);
    checksum_.add(bytes);
    out_.write(bytes.data(), static_cast<std::streamsize>(size));
    length_ += size;
}

void BinaryWriter::finish()
{
    put(length_ + ending);
    const auto checksum = checksum_.value();
    put(checksum);
}

BinaryReader::BinaryReader(std::filesystem::path file, std::string_view kind, std::string help)
    : file_(std::move(file)), help_(std::move(help))
{
    std::error_code error;
    if (std::filesystem::exists(file_, error) && !std::filesystem::is_regular_file(file_, error))
        refuse("it is not a file");  // reading a pipe would wait
    errno = 0;
    in_.open(file_, std::ios::binary | std::ios::ate);
    if (!in_)
        throw IoError(fmt::format("cannot read '{}': {}\n  help: {}", file_.string(), std::strerror(errno), help_));
    const auto size = static_cast<std::uint64_t>(in_.tellg());
    in_.seekg(0);
    constexpr std::size_t more_digits = 8;  // of a version longer than this program's
    std::string head(static_cast<std::size_t>(std::min<std::uint64_t>(size, kind.size() + more_digits)), '\0');
    in_.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (const auto version = other_version(head, kind); !version.empty())
        throw IoError(fmt::format("'{}' has version {} of its format; this program reads version {}\n  help: {}",
                                  file_.string(), version, version_in(kind), help_));
    head.resize(std::min(head.size(), kind.size()));
    if (head != kind)
        refuse(fmt::format("it does not begin with '{}'", kind.substr(0, kind.find('\n'))));
    if (size < kind.size() + ending)
        refuse("it is cut short");

    // The length first: it costs nothing, a checksum of a file of many gigabytes does.
    end_ = size - ending;
    in_.seekg(static_cast<std::streamoff>(end_));
    left_ = ending;
    std::uint64_t length = 0, wanted = 0;
    (*this)(length, wanted);
    if (length != size)
        refuse("it is cut short");
    in_.seekg(0);
    StableHash checksum;
    std::string piece(std::min<std::uint64_t>(size, 1 << 20), '\0');
    for (std::uint64_t left = size - sizeof(std::uint64_t); left > 0;) {
        const auto here = std::min<std::uint64_t>(left, piece.size());
        left_ = here;
        get_bytes(piece.data(), here);
        checksum.add({piece.data(), here});
        left -= here;
    }
    if (wanted != checksum.value())
        refuse("its checksum does not fit");
    in_.seekg(static_cast<std::streamoff>(kind.size()));
    left_ = end_ - kind.size();
}

void BinaryReader::refuse(const std::string& reason) const
{
    throw IoError(fmt::format("'{}' is broken: {}\n  help: {}", file_.string(), reason, help_));
}

void BinaryReader::get_bytes(void* data, std::size_t size)
{
    if (size > left_)
        refuse("it ends too early");
    in_.read(static_cast<char*>(data), static_cast<std::streamsize>(size));
    if (in_.gcount() != static_cast<std::streamsize>(size))
        refuse("it cannot be read to its end");
    left_ -= size;
}

void BinaryReader::refuse_value(std::size_t bytes_ago, const char* reason) const
{
    refuse(fmt::format("its value at byte {} {}", end_ - left_ - bytes_ago, reason));
}

std::size_t BinaryReader::get_count(std::size_t size_of_one)
{
    std::uint64_t count = 0;
    get(count);
    if (count > left_ / size_of_one)
        refuse(fmt::format("it has no room for the {} values it claims", count));
    return static_cast<std::size_t>(count);
}

}  // namespace deadpoint
