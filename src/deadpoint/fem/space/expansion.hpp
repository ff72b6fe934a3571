#pragma once

#include "deadpoint/exchange/laws/material.hpp"

#include <cmath>
#include <cstdint>
#include <vector>

/// Internal to fem/: the thermal strain at the unknowns, as the rise that gives the same strain
/// with the part's constant coefficient (exchange/laws/material). It is interpolated between the
/// unknowns like the temperature.
namespace deadpoint::fem {

class Discretisation;

class Expansion {
public:
    Expansion(const Discretisation& space, const std::vector<Material>& materials);

    /// True if the rise is T - T_start everywhere.
    [[nodiscard]] bool linear() const { return parts_.empty(); }
    /// @param unknown  counted from this rank's first
    /// @return [K]
    [[nodiscard]] double rise(std::size_t unknown, double temperature, double start) const
    {
        return linear() ? temperature - start : expansion_rise(materials_[parts_[unknown]], temperature, start);
    }
    /// Its derivative by the temperature.
    [[nodiscard]] double slope(std::size_t unknown, double temperature) const
    {
        return linear() ? 1 : expansion_rise_slope(materials_[parts_[unknown]], temperature);
    }
    /// The rise over T - T_start, or its limit.
    [[nodiscard]] double secant(std::size_t unknown, double temperature, double start) const
    {
        const bool apart = std::abs(temperature - start) > 1e-6;
        return apart ? rise(unknown, temperature, start) / (temperature - start) : slope(unknown, start);
    }

private:
    const std::vector<Material>& materials_;
    std::vector<std::uint32_t> parts_;  ///< of this rank's unknowns, where a material has a table
};

}  // namespace deadpoint::fem
