#pragma once

#include "deadpoint/error.hpp"

#include <exception>
#include <filesystem>
#include <new>
#include <string>
#include <system_error>

namespace deadpoint {

/// What an exception means to a user: the message of a deadpoint error; of the system, its reason and the path; else
/// that memory ran out, or that the program does not know the error. Texts of the C++ library are not among it.
inline std::string plain_reason(const std::exception& error)
{
    if (dynamic_cast<const Error*>(&error) != nullptr) {
        return error.what();
    }
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) {
        return "memory ran out";
    }
    if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
        const auto path = of_file->path1().string();
        return path.empty() ? of_file->code().message() : "'" + path + "': " + of_file->code().message();
    }
    if (const auto* of_system = dynamic_cast<const std::system_error*>(&error)) {
        return of_system->code().message();
    }
    return "an error that the program does not know";
}

}  // namespace deadpoint
