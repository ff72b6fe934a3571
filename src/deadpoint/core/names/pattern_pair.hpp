#pragma once

#include "deadpoint/core/names/pattern.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace deadpoint {

/// Two patterns of part names, in any order: "motor|frame_*".
struct PatternPair {
    std::string first;
    std::string second;

    [[nodiscard]] bool names(std::string_view a, std::string_view b) const
    {
        return (matches(first, a) && matches(second, b)) || (matches(first, b) && matches(second, a));
    }
};

/// None for a text that is not of the form "a|b".
inline std::optional<PatternPair> pattern_pair(const std::string& text)
{
    const auto bar = text.find('|');
    if (bar == std::string::npos || bar == 0 || bar + 1 == text.size())
        return {};
    return PatternPair{text.substr(0, bar), text.substr(bar + 1)};
}

}  // namespace deadpoint
