#pragma once

#include "deadpoint/design/points.hpp"

#include <span>

/// Screening of many inputs with few points.
namespace deadpoint::design {

/// Trajectories (Morris, Technometrics 33 (1991) 161): from a random point of a grid of four levels 0, 1/3, 2/3, 1
/// every input moves once, in random order, by 2/3 up or down. The ends of the ranges are among the points. Points are
/// numbered trajectory by trajectory.
class MorrisDesign {
public:
    MorrisDesign(std::size_t inputs, std::size_t trajectories, unsigned seed);
    [[nodiscard]] std::size_t inputs() const { return inputs_; }
    [[nodiscard]] std::size_t trajectories() const { return points_.size() / (inputs_ + 1); }
    [[nodiscard]] std::size_t size() const { return points_.size(); }
    [[nodiscard]] const Point& point(std::size_t number) const { return points_[number]; }
    /// As SobolDesign::in_turn().
    [[nodiscard]] std::size_t in_turn(std::size_t k) const { return k; }

private:
    std::size_t inputs_;
    std::vector<Point> points_;
};

/// Elementary effects of an input, (f(u + 2/3 e_i) - f(u)) / (2/3), over the trajectories.
struct MorrisEffect {
    Band strength;         ///< mu*: mean of their magnitudes (Campolongo et al., Environ. Model. Softw. 22 (2007) 1509)
    double mean = 0;       ///< mu
    double deviation = 0;  ///< sigma: curvature and interactions; 0 for an input with a constant effect
};

/// @param values  of one output at all points of the design; an effect with a value that is not finite is left out
/// @return per input; NaN without effects
/// @throws DomainError if the number of values is not that of the design
std::vector<MorrisEffect> morris_effects(std::span<const double> values, const MorrisDesign& design,
                                         const Bootstrap& bootstrap);

}  // namespace deadpoint::design
