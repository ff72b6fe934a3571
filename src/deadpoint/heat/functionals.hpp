#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// The functionals of the temperature field that a heat balance knows, by number.
namespace deadpoint::heat {

/// Index of each functional in the list of a system. The transposed functional is a load: watts by
/// unknown.
struct FunctionalLayout {
    std::size_t interfaces = 0, parts = 0, surfaces = 0, bodies = 0, probes = 0;

    /// Mean temperature of a side of an interface; as a load, one watt uniform over it.
    [[nodiscard]] std::size_t mean(std::size_t interface, bool side_b) const
    {
        return 2 * interface + (side_b ? 1 : 0);
    }
    /// As a load: one watt by load zone less one watt uniform. If the heat enters a part's volume,
    /// it is that of side a.
    [[nodiscard]] std::size_t zone(std::size_t interface, bool side_b) const
    {
        return 2 * interfaces + 2 * interface + (side_b ? 1 : 0);
    }
    /// Mean temperature of a part's volume.
    [[nodiscard]] std::size_t part(std::size_t index) const { return 4 * interfaces + index; }
    /// Integral of the temperature over a surface condition's area [K m2]; empty where it is prescribed.
    [[nodiscard]] std::size_t surface(std::size_t index) const { return part(parts) + index; }
    /// As a load: one watt of heat in parts or over a surface.
    [[nodiscard]] std::size_t body(std::size_t index) const { return surface(surfaces) + index; }
    /// Temperature of a probe.
    [[nodiscard]] std::size_t probe(std::size_t index) const { return body(bodies) + index; }
    [[nodiscard]] std::size_t count() const { return probe(probes); }
};

/// One term of a combination of functionals.
struct Load {
    std::size_t functional = 0;
    double factor = 0;
};
using Loads = std::vector<Load>;

/// Value of a combination. @param values  by functional
inline double value_of(const Loads& loads, const std::vector<double>& values)
{
    double sum = 0;
    for (const auto& load : loads)
        sum += load.factor * values[load.functional];
    return sum;
}

/// Adds `watts` of a combination to the watts by functional.
inline void add_watts(std::vector<double>& by_functional, const Loads& loads, double watts)
{
    for (const auto& load : loads)
        by_functional[load.functional] += watts * load.factor;
}

/// Data of a mesh that the balance needs.
struct HeatGeometry {
    FunctionalLayout layout;
    std::vector<std::string> interface_names;
    std::vector<double> interface_area;  ///< [m2]
    std::vector<double> surface_area;    ///< per surface condition; 0 where it is prescribed [m2]
};

}  // namespace deadpoint::heat
