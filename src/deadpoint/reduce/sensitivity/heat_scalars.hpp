#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace deadpoint {
struct HeatProblem;
}

/// The scalars of a heat problem by which a run can be derived.
namespace deadpoint::reduce {

enum class JointScalar { film_a, film_b, oil, oil_temperature };

/// Index of each scalar of a heat balance.
struct ScalarLayout {
    explicit ScalarLayout(const HeatProblem& problem);

    std::size_t interfaces = 0, surfaces = 0, sources = 0, bodies = 0, circuits = 0, enclosures = 0;

    /// Scalar of an interface's law; its oil's temperature only if no circuit brings the oil.
    [[nodiscard]] std::size_t joint(std::size_t interface, JointScalar scalar) const
    {
        return 4 * interface + static_cast<std::size_t>(scalar);
    }
    /// Coefficient of a constant film [W/m2/K]; of a film that follows the temperature a factor on all it gives to its
    /// air, and by radiation to its ambient.
    [[nodiscard]] std::size_t film(std::size_t surface) const { return 4 * interfaces + surface; }
    /// Temperature that a film faces, if that is no enclosed air [K].
    [[nodiscard]] std::size_t faced(std::size_t surface) const { return film(surfaces) + surface; }
    /// Prescribed flux into the part [W/m2].
    [[nodiscard]] std::size_t flux(std::size_t surface) const { return faced(surfaces) + surface; }
    /// Flux that a film that follows the temperature gives to its air and its ambient [W/m2], and its slope [W/m2/K].
    [[nodiscard]] std::size_t lost(std::size_t surface) const { return flux(surfaces) + surface; }
    [[nodiscard]] std::size_t slope(std::size_t surface) const { return lost(surfaces) + surface; }
    /// HeatSource::share.
    [[nodiscard]] std::size_t share(std::size_t source) const { return slope(surfaces) + source; }
    /// Heat of a source at a given temperature, and its part by load zone, both of the whole press [W].
    [[nodiscard]] std::size_t heat(std::size_t source) const { return share(sources) + source; }
    [[nodiscard]] std::size_t zoned(std::size_t source) const { return heat(sources) + source; }
    [[nodiscard]] std::size_t body(std::size_t index) const { return zoned(sources) + index; }  ///< [W]
    /// Scalars of a circuit: flow [W/K], the cooler's temperature [K], loss of the sump [W/K].
    [[nodiscard]] std::size_t flow(std::size_t circuit) const { return body(bodies) + circuit; }
    [[nodiscard]] std::size_t inlet(std::size_t circuit) const { return flow(circuits) + circuit; }
    [[nodiscard]] std::size_t sump_loss(std::size_t circuit) const { return inlet(circuits) + circuit; }
    /// Scalars of an enclosure: exchange with the ambient [W/K], power [W].
    [[nodiscard]] std::size_t exchange(std::size_t enclosure) const { return sump_loss(circuits) + enclosure; }
    [[nodiscard]] std::size_t power(std::size_t enclosure) const { return exchange(enclosures) + enclosure; }
    /// Ambient temperature of the segment, as sumps and enclosures face it [K].
    [[nodiscard]] std::size_t ambient() const { return power(enclosures); }
    /// InterfaceLaw::heat_weight, which shares a source's heat among its interfaces.
    [[nodiscard]] std::size_t weight(std::size_t interface) const { return ambient() + 1 + interface; }
    [[nodiscard]] std::size_t count() const { return weight(interfaces); }
};

/// Changes of scalars; all others do not change.
using ScalarChanges = std::vector<std::pair<std::size_t, double>>;

/// (more - less) / by of the scalars that hold throughout a segment, of two problems with the same joints, surfaces,
/// sources, circuits and enclosures.
ScalarChanges lasting_changes(const HeatProblem& less, const HeatProblem& more, double by, std::size_t segment);

}  // namespace deadpoint::reduce
