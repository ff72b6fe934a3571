#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace deadpoint {

/// Smallest number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`
/// (optimal string alignment distance); upper and lower case count as equal.
int edit_distance(std::string_view a, std::string_view b);

/// The candidate closest to `name`, for "did you mean".
/// @return empty where none is near: more than a third of the letters (at least one, at most three) would change
std::string closest_name(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace deadpoint
