#pragma once

#include "deadpoint/core/vec.hpp"

#include <functional>

/// Internal: the slide's height over the driver's angle and its extrema.
namespace deadpoint::mechanism {

struct PlanarPosition;

class PlanarSystem;

/// Travel of the slide along the stroke direction.
class SlideMotion {
public:
    explicit SlideMotion(const PlanarSystem& system);

    [[nodiscard]] const PlanarSystem& system() const { return system_; }
    [[nodiscard]] const Vec2& stroke() const { return stroke_; }  ///< unit
    [[nodiscard]] Vec2 point(const PlanarPosition& position) const;
    [[nodiscard]] double height(const PlanarPosition& position) const;     ///< [m], above any level
    [[nodiscard]] double slope(const PlanarPosition& position) const;      ///< by the driver's angle [m/rad]
    [[nodiscard]] double curvature(const PlanarPosition& position) const;  ///< [m/rad2]

    /// Zero of a function of the position, between two positions at which it has different signs.
    [[nodiscard]] PlanarPosition zero(const std::function<double(const PlanarPosition&)>& of,
                                      const PlanarPosition& first, const PlanarPosition& second) const;
    enum class Extremum { lowest, highest };
    /// The extremum of the height that lies less than `reach` [rad] from a position, to 1e-12 rad.
    [[nodiscard]] PlanarPosition extremum(Extremum kind, const PlanarPosition& near, double reach) const;

private:
    const PlanarSystem& system_;
    Vec2 point_;
    Vec2 stroke_;
};

}  // namespace deadpoint::mechanism
