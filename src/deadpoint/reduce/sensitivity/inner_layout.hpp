#pragma once

#include <cstddef>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint
namespace deadpoint::heat {
class JointBalance;
struct HeatGeometry;
}  // namespace deadpoint::heat

/// The inner values of a heat balance: scalars through which its states act on each other.
namespace deadpoint::reduce {

/// Index of an inner value; -1: none.
using InnerPlace = std::ptrdiff_t;

/// Interfaces that the oil of a circuit reaches at the same temperature, which is an inner value.
struct OilStop {
    InnerPlace place = -1;
    std::vector<std::size_t> interfaces;
};
struct OilPath {
    /// What the first stop receives: oil of the cooler's temperature; from a sump; or from a sump that exchanges no
    /// heat at all and keeps its temperature.
    enum class Feed { cooler, sump, still };
    std::size_t circuit = 0;  ///< index into HeatProblem::oil
    Feed feed = Feed::cooler;
    double flow = 0;             ///< [W/K]
    std::vector<OilStop> stops;  ///< without those that have no interface
};
/// A film that follows the temperature.
struct FollowingFilm {
    std::size_t surface = 0;
    InnerPlace outside = -1;  ///< flux to its air, and by radiation to its ambient [W/m2]
    InnerPlace slope = -1;    ///< [W/m2/K]
    InnerPlace inside = -1;   ///< flux to the other surfaces of its radiant room [W/m2]
};

/// Inner values of a segment, in this order: heat of each source, oil at each stop, air of each enclosure, films.
struct InnerLayout {
    std::vector<OilPath> oil;
    std::vector<InnerPlace> oil_of;  ///< per interface: the stop's, or none
    InnerPlace first_air = 0;
    std::vector<FollowingFilm> films;
    /// Heat capacity of each value [J/K]; 0 where its equation is algebraic. 1 for a sump that keeps its temperature.
    std::vector<double> capacity;

    [[nodiscard]] static InnerPlace heat(std::size_t source) { return static_cast<InnerPlace>(source); }
    [[nodiscard]] InnerPlace air(std::size_t enclosure) const { return first_air + static_cast<InnerPlace>(enclosure); }
    [[nodiscard]] InnerPlace count() const { return static_cast<InnerPlace>(capacity.size()); }
};

/// @param joints  in that segment
InnerLayout inner_layout(const HeatProblem& problem, const HeatSegment& segment, const heat::HeatGeometry& geometry,
                         const heat::JointBalance& joints);

}  // namespace deadpoint::reduce
