#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// Which files of a folder deadpoint wrote, and whether they are still as they were written.
///
/// Each folder of results holds `deadpoint.json`: the number of this format, the version of the program, and size and
/// checksum of every file beside and below it. A folder below with a `deadpoint.json` of its own speaks for itself.
/// Files of different runs, and files that were cut, changed or lost, do not fit the list.
namespace deadpoint::report {

inline constexpr const char* manifest_name = "deadpoint.json";
inline constexpr int result_format = 2;  ///< changes when an older version could not read the folder

/// How a file was written.
struct ListedFile {
    std::uintmax_t size = 0;  ///< [byte]
    std::string checksum;     ///< stable_hash() of its bytes
};

/// The list of one folder, read back.
class ResultFiles {
public:
    /// @throws IoError    if there is no such folder or its list cannot be read
    /// @throws InputError if the folder has no list (another program, or an older version, wrote it), the list is of
    ///                    another format, or was changed
    explicit ResultFiles(std::filesystem::path folder);

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    /// By path from the folder, with '/' between: "fields/top.vtu".
    [[nodiscard]] const std::map<std::string, ListedFile>& listed() const { return listed_; }
    /// All of a file, of which size and checksum are as listed.
    /// @return nothing if there is no such file, nor was
    /// @throws IoError if the file is gone or cannot be read
    /// @throws InputError if it is not what was written, or was put there since
    [[nodiscard]] std::optional<std::string> read(const std::string& name) const;
    /// The same of a file that must be there, however large, without its text.
    void check(const std::string& name) const;

private:
    [[nodiscard]] const ListedFile* find(const std::string& name) const;
    void compare(const std::string& name, const ListedFile& found) const;

    std::filesystem::path folder_;
    std::map<std::string, ListedFile> listed_;
};

/// Lists all that is in a folder now. @throws IoError if a file cannot be read or the list not be written
void write_manifest(const std::filesystem::path& folder);

/// Lists a file that was added to its folder, or written anew, since the folder was listed. Nothing happens in a folder
/// without a list.
/// @throws as ResultFiles and write_manifest()
void record_file(const std::filesystem::path& file);

/// What stands in a folder of results, or below, and is in no list: deadpoint did not write it.
/// @throws as ResultFiles
std::vector<std::filesystem::path> foreign_files(const std::filesystem::path& folder);

}  // namespace deadpoint::report
