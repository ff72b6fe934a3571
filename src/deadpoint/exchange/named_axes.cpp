#include "deadpoint/exchange/named_axes.hpp"

namespace deadpoint {
namespace {

std::optional<Vec3> direction(const std::string& name)
{
    const bool back = name.starts_with("-");
    const std::string letter = name.substr(back ? 1 : 0);
    if (letter != "x" && letter != "y" && letter != "z") {
        return std::nullopt;
    }
    Vec3 result{};
    result[static_cast<std::size_t>(letter[0] - 'x')] = back ? -1 : 1;
    return result;
}

}  // namespace

std::optional<std::array<Vec3, 3>> named_axes(const std::vector<std::string>& names)
{
    std::array<Vec3, 3> axes{};
    if (names.size() != axes.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto one = direction(names[i]);
        if (!one) {
            return std::nullopt;
        }
        axes[i] = *one;
    }
    const double volume = dot(cross(axes[0], axes[1]), axes[2]);
    return volume > 0.5 ? std::optional(axes) : std::nullopt;
}

}  // namespace deadpoint
