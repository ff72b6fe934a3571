#pragma once

#include <span>
#include <string>
#include <string_view>

namespace deadpoint::report::schema {

/// A column of a table.
struct Column {
    std::string_view kind;     ///< what it holds, unique in its file: "joint_heat"
    std::string_view heading;  ///< of the column, with at most one name in braces: "{joint} heat"
    std::string_view unit;     ///< "{unit}": that of the value shown; empty: none
    std::string_view meaning;
};

/// A pattern with its name in braces replaced.
std::string filled(std::string_view pattern, const std::string& name);
/// The name that stands in the braces of a pattern. @return none if the pattern has no braces or
/// the text does not match it
std::string name_in(std::string_view pattern, const std::string& text);

}  // namespace deadpoint::report::schema
