#pragma once

#include "deadpoint/casefile/case.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::casefile {

/// No press is colder; what a formula gives below was meant in degC [K].
inline constexpr double coldest_meant = 150;

/// A mistake in how the sections of a case refer to each other.
struct Finding {
    std::string code;
    std::string path;  ///< of the key at fault: "joints.crank_pin.bodies.1"
    std::string message;
    std::string help;
    bool warning = false;
};

/// Checks every name that refers to something else, and the rules that span sections. Does not look at geometry.
/// Names left empty are passed over: that they are missing is found on reading.
std::vector<Finding> check_references(const Case& c);

}  // namespace deadpoint::casefile
