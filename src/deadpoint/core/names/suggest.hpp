#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint {

/// Smallest number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment distance); upper and lower case count as equal.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate closest to `name`, for "did you mean".
/// @return empty if none is near: more than a third of the letters (at least one, at most three)
///         would change, or the name is longer than anyone types
std::string closest_name(std::string_view name, const std::vector<std::string>& candidates);

/// The keys of a map, as candidates.
template <class T>
std::vector<std::string> names_of(const std::map<std::string, T>& map)
{
    std::vector<std::string> names;
    for (const auto& [name, value] : map) {
        names.push_back(name);
    }
    return names;
}

}  // namespace deadpoint
