#pragma once

#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The part of a case about supports of the machine and loads other than heat.
namespace deadpoint::casefile {

struct Foundation {
    /// free: the feet slide in their plane; elastic: they stand on elastic pads.
    enum class Kind { free, clamped, elastic };
    Kind kind = Kind::free;
    std::string surface;                         ///< the feet; empty: that of the dimension chain
    std::optional<double> vertical_stiffness;    ///< of the pads, per area [N/m3]
    std::optional<double> horizontal_stiffness;  ///< [N/m3]
    double gravity = 0;                          ///< [m/s2]; 0: weights are left out
};

/// Rods that are stretched at assembly and press parts together.
struct Preload {
    std::vector<std::string> parts;   ///< names or patterns; each part is one rod
    Axis axis = Axis::y;              ///< along the rods
    double force = 0;                 ///< of each rod at the start, weights acting [N]
    double process_share = 0;         ///< of the process force, that each rod has to hold
    std::vector<std::string> closes;  ///< pairs of parts that only the preload holds together
};

template <>
inline constexpr auto spelling<Foundation::Kind> = std::array<std::string_view, 3>{"free", "clamped", "elastic"};
template <>
inline constexpr auto spelling<Axis> = std::array<std::string_view, 3>{"x", "y", "z"};

}  // namespace deadpoint::casefile
