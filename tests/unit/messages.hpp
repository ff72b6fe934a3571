#pragma once

#include "deadpoint/error.hpp"

#include <string>

/// What a test asks about the text of an error or a report.
namespace messages {

inline bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

/// The message of the error that an action ends with, empty if it ends with none. Errors of another kind pass through.
template <class Kind = deadpoint::Error>
std::string error_of(const auto& action)
{
    try {
        action();
    } catch (const Kind& error) {
        return error.what();
    }
    return {};
}

}  // namespace messages
