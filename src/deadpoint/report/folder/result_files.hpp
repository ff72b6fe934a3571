#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// The list of files that deadpoint wrote into a folder, to detect changes.
///
/// Each folder of results holds `deadpoint.json`: the number of this format, the version of the
/// program, and size and checksum of every file beside and below it. A subfolder with its own
/// `deadpoint.json` has its own list. Files of different runs, and files that were truncated,
/// changed or lost, do not match the list.
namespace deadpoint::report {

inline constexpr const char* manifest_name = "deadpoint.json";
inline constexpr const char* unfinished_mark = "unfinished";  ///< in the list of a folder that is being written
inline constexpr int result_format = 2;  ///< changes when an older version could not read the folder

/// Size and checksum of a file as written.
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
    /// The contents of a file whose size and checksum match the list; a table as the program writes it, whatever style
    /// it has (table_style.hpp). @return none if the file
    /// neither exists nor is listed @throws IoError if the file is missing or cannot be read
    /// @throws InputError if it was changed, or added later
    [[nodiscard]] std::optional<std::string> read(const std::string& name) const;
    /// Checks a file of any size that must exist, without returning its contents.
    void check(const std::string& name) const;
    /// Checks that a listed file exists with the size that it had, and nothing else.
    void check_size(const std::string& name) const;

private:
    [[nodiscard]] const ListedFile* find(const std::string& name) const;
    void compare(const std::string& name, const ListedFile& found) const;
    [[noreturn]] void refuse_missing(const std::string& name) const;

    std::filesystem::path folder_;
    std::map<std::string, ListedFile> listed_;
};

/// Lists all files that are in a folder now. @throws IoError if a file cannot be read or the list
/// not be written
void write_manifest(const std::filesystem::path& folder);

/// Lists a file that was added to its folder, or written again, after the folder was listed. Does
/// nothing in a folder without a list.
/// @throws as ResultFiles and write_manifest()
void record_file(const std::filesystem::path& file);

/// Files in a result folder or below that are in no list: deadpoint did not write them.
/// @throws as ResultFiles
std::vector<std::filesystem::path> foreign_files(const std::filesystem::path& folder);

/// True if `deadpoint sweep` wrote this folder.
bool is_study(const std::filesystem::path& folder);

}  // namespace deadpoint::report
