#pragma once

#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/io/write_file.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <utility>

/// What a build has finished, on disk, so that another process can go on with it.
namespace deadpoint::reduce {

/// A folder with a file for each finished piece: sets of fields, the basis, the terms on it, the moments of the
/// training runs, full runs. Files are written under another name and renamed, so that each is whole or absent. Each
/// states the build to which it belongs and ends with a checksum.
class BuildCheckpoint {
public:
    /// Keeps nothing.
    BuildCheckpoint() = default;
    /// @param folder  exists, and is empty or has pieces of this build
    /// @param build   program, case and mesh, as text
    /// @param writes  false: another rank writes
    /// @param warn    called if a piece cannot be written; the build goes on
    BuildCheckpoint(std::filesystem::path folder, std::string build, bool writes,
                    std::function<void(const std::string&)> warn)
        : folder_(std::move(folder)), build_(std::move(build)), writes_(writes), warn_(std::move(warn))
    {}

    [[nodiscard]] bool keeps() const { return !folder_.empty(); }
    /// Reads a piece. @return false if it is not there
    /// @throws IoError if the file is broken; InputError if it belongs to another build
    template <class... Values>
    bool read(const std::string& piece, Values&... values) const
    {
        if (!keeps() || !std::filesystem::exists(file(piece)))
            return false;
        BinaryReader in(file(piece), kind, help);
        std::string build;
        in(build);
        require_own(piece, build);
        in(values...);
        return true;
    }
    template <class... Values>
    void write(const std::string& piece, const Values&... values) const
    {
        if (!keeps() || !writes_)
            return;
        fill(piece, [&](std::ostream& out) {
            BinaryWriter writer(out, kind);
            writer(build_, values...);
            writer.finish();
        });
    }

private:
    static constexpr std::string_view kind = "deadpoint-build-1\n";
    static constexpr const char* help = "remove this folder and build anew without --resume";
    [[nodiscard]] std::filesystem::path file(const std::string& piece) const { return folder_ / (piece + ".bin"); }
    void require_own(const std::string& piece, const std::string& build) const;
    void fill(const std::string& piece, const std::function<void(std::ostream&)>& write) const;

    std::filesystem::path folder_;
    std::string build_;
    bool writes_ = false;
    std::function<void(const std::string&)> warn_;
};

}  // namespace deadpoint::reduce
