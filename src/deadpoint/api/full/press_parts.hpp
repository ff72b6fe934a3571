#pragma once

#include "deadpoint/full/run/press.hpp"
#include "deadpoint/press.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// Internal to api/: the implementation of a public press.
namespace deadpoint {

struct Press::Implementation {
    full::Press press;
    std::filesystem::path file;  ///< that it was read from
    ReadOptions options;
    std::vector<Diagnostic> warnings;
    std::vector<std::string> reading;           ///< the same warnings as texts
    std::vector<std::filesystem::path> inputs;  ///< all files of the user that belong to it
};

struct CheckedCase;

/// Everything that `deadpoint check` finds in a case without errors of reading: warnings and mistakes of reading, mesh,
/// loads, laws and dimension chain.
/// @param press  of the case
std::vector<Diagnostic> check_press(const CheckedCase& read, full::Press& press, Observer& observer);

/// @throws InputError where no Session is open
void require_session();

}  // namespace deadpoint
