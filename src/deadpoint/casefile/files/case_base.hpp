#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/document.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

/// Many cases from one file.
namespace deadpoint::casefile {

/// A case file that is read once. Each case made of it reads only the tables that its overrides touch. Any number of
/// threads may use it.
class CaseBase {
public:
    /// @throws IoError if the case file cannot be read
    CaseBase(std::filesystem::path path, FileAccess files);
    /// As read_case(path, overrides, files).value, and its errors.
    [[nodiscard]] Case with(const std::vector<std::string>& overrides) const;

private:
    [[nodiscard]] std::optional<Case> changed(const std::vector<std::string>& overrides) const;
    [[nodiscard]] std::optional<Document> touched(const std::vector<std::string>& overrides) const;

    std::filesystem::path path_;
    FileAccess files_;
    Document document_;
    StableHash texts_;                             ///< of the file and all it includes
    std::optional<Case> base_;                     ///< none if it has mistakes, which overrides may mend
    std::set<std::string, std::less<>> groups_;    ///< sections that hold tables by name: "joints"
    std::set<std::string, std::less<>> required_;  ///< sections and keys that no case may lack
};

}  // namespace deadpoint::casefile
