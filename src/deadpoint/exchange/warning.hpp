#pragma once

#include <string>

namespace deadpoint {

/// A warning that may occur again with other numbers.
struct Warning {
    std::string about;  ///< its subject, without numbers that change: equal for the same cause
    std::string text;
};

}  // namespace deadpoint
