#include "deadpoint/exchange/named_axes.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace deadpoint {

std::optional<Vec3> named_axis(const std::string& name)
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

std::string axis_name(const Vec3& direction)
{
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(direction[i]) > 1 - 1e-9)
            return (direction[i] < 0 ? "-" : "") + std::string(1, "xyz"[i]);
    std::ostringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(2) << '(' << direction[0] << ", " << direction[1] << ", " << direction[2]
         << ')';
    return text.str();
}

std::string side_name(const Vec3& direction)
{
    const auto name = axis_name(direction);
    if (name.starts_with("("))
        return "towards " + name;
    return name.starts_with("-") ? name.substr(1) + " < 0" : name + " > 0";
}

std::optional<std::array<Vec3, 3>> named_axes(const std::vector<std::string>& names)
{
    std::array<Vec3, 3> axes{};
    if (names.size() != axes.size()) {
        return std::nullopt;
    }
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const auto one = named_axis(names[i]);
        if (!one) {
            return std::nullopt;
        }
        axes[i] = *one;
    }
    const double volume = dot(cross(axes[0], axes[1]), axes[2]);
    return volume > 0.5 ? std::optional(axes) : std::nullopt;
}

}  // namespace deadpoint
