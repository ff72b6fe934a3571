#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"
#include "deadpoint/diagnostic.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Errors that are found after reading, with file, line and caret as those found while reading.
namespace deadpoint::casefile {

/// Where a case was read from. Its texts are read again when a place in them is wanted, so that thousands of cases of a
/// study need not keep them.
struct CaseSource {
    std::filesystem::path path;
    std::vector<std::string> overrides;
    FileAccess files = FileAccess::below;
    std::string hash;  ///< of the texts: where they have changed since, no place is told
};

class Diagnostics;
struct Finding;

/// What was found, as the public headers have it.
std::vector<deadpoint::Diagnostic> as_data(const Diagnostics& found);

/// @param outcome  as of Diagnostics::render_errors
/// @throws CaseError with all errors if there are any
void stop_at_errors(const Diagnostics& found, std::string_view outcome);

/// The error with the place of each of its diagnostics, the lines and carets. It stays as it is where it has them
/// already, where the case was not read from files, and where those are no longer what they were.
CaseError placed(const CaseError& error, const Case& input);
CaseDomainError placed(const CaseDomainError& error, const Case& input);

/// Warnings about keys of a case, each with its place, line and caret where these are known as for `placed`, else as
/// "path: message; help".
std::vector<std::string> placed_warnings(const Case& input, const std::vector<Finding>& found);

/// Runs what may find mistakes in a case after reading; they get their places.
template <class Action>
decltype(auto) with_places(const Case& input, const Action& action)
{
    try {
        return action();
    } catch (const CaseError& error) {
        throw placed(error, input);
    } catch (const CaseDomainError& error) {
        throw placed(error, input);
    }
}

}  // namespace deadpoint::casefile
