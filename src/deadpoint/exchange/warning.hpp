#pragma once

#include <string>

namespace deadpoint {

/// A warning that may come again with other numbers.
struct Warning {
    std::string about;  ///< what it is about, without numbers that change: equal for the same cause
    std::string text;
};

}  // namespace deadpoint
