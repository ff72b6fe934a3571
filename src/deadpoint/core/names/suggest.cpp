#include "deadpoint/core/names/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace deadpoint {

int edit_distance(std::string_view a, std::string_view b)
{
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    const std::size_t width = b.size() + 1;
    std::vector<int> cost((a.size() + 1) * width);
    const auto at = [&](std::size_t i, std::size_t j) -> int& { return cost[i * width + j]; };
    for (std::size_t i = 0; i <= a.size(); ++i) {
        at(i, 0) = static_cast<int>(i);
    }
    for (std::size_t j = 0; j <= b.size(); ++j) {
        at(0, j) = static_cast<int>(j);
    }
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int change = lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1;
            at(i, j) = std::min({at(i - 1, j) + 1, at(i, j - 1) + 1, at(i - 1, j - 1) + change});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) {
                at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + 1);
            }
        }
    }
    return at(a.size(), b.size());
}

std::string closest_name(std::string_view name, const std::vector<std::string>& candidates)
{
    constexpr std::size_t longest = 100;  // a longer text is not a typing mistake
    if (name.size() > longest) {
        return {};
    }
    const int limit = std::clamp(static_cast<int>(name.size()) / 3, 1, 3);
    int best = limit + 1;
    std::string found;
    for (const auto& candidate : candidates) {
        if (candidate.size() > name.size() + static_cast<std::size_t>(limit)) {
            continue;
        }
        const int distance = edit_distance(name, candidate);
        if (distance < best) {
            best = distance;
            found = candidate;
        }
    }
    return found;
}

}  // namespace deadpoint
