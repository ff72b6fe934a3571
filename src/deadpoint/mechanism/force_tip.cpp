#include "deadpoint/mechanism/force_tip.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/mechanism/cycle.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::mechanism {
namespace {

constexpr double met = 1 - 1e-3;  // share of the largest force that counts as met
constexpr int most_often = 4;     // as many positions as asked for
constexpr double beside = 1e-6;   // distance to a corner at which the force may jump [rad]
constexpr int halvings = 50;

/// The force over the angle since bottom dead point, 0..2 pi, between the positions of a history too.
class ForceOverTurn {
public:
    ForceOverTurn(const CycleHistory& history, const CycleRequest& request) : history_(history), request_(request) {}

    [[nodiscard]] int positions() const { return static_cast<int>(history_.height.size()); }
    [[nodiscard]] double step() const { return full_turn / positions(); }

    [[nodiscard]] double height(double since) const
    {
        const auto [i, s] = find(since);
        const auto k = (i + 1) % history_.height.size();
        const double from = slope(i) * step(), to = slope(k) * step();
        return history_.height[i] * (1 + 2 * s) * (1 - s) * (1 - s) + from * s * (1 - s) * (1 - s) +
               history_.height[k] * s * s * (3 - 2 * s) + to * s * s * (s - 1);
    }
    [[nodiscard]] double magnitude(double since) const
    {
        const double past = std::remainder(since, full_turn);
        const auto [i, s] = find(since);
        const auto k = (i + 1) % history_.height.size();
        const double speed = (1 - s) * history_.slide_speed[i] + s * history_.slide_speed[k];
        const double force = request_.process_force(past, height(since), speed);
        if (!std::isfinite(force))
            throw DomainError(fmt::format("the process force is {} N at {:.3f} degrees past bottom dead point\n  help: "
                                          "check its law",
                                          force, past * 360 / full_turn));
        return std::abs(force);
    }
    /// Angles since bottom dead point at which the slide passes a height.
    void add_passages(double wanted, std::vector<double>& angles) const
    {
        for (int i = 0; i < positions(); ++i) {
            double low = i * step(), high = (i + 1) * step();
            const bool rises = height(low) <= wanted;
            if (rises == (height(high) <= wanted))
                continue;
            for (int round = 0; round < halvings; ++round) {
                const double middle = 0.5 * (low + high);
                ((height(middle) <= wanted) == rises ? low : high) = middle;
            }
            angles.push_back(low);
        }
    }

private:
    [[nodiscard]] std::pair<std::size_t, double> find(double since) const
    {
        const double place = (since - full_turn * std::floor(since / full_turn)) / step();
        const auto i = std::min(static_cast<std::size_t>(place), history_.height.size() - 1);
        return {i, place - static_cast<double>(i)};
    }
    [[nodiscard]] double slope(std::size_t i) const { return history_.slide_speed[i] / history_.speed[i]; }

    const CycleHistory& history_;
    const CycleRequest& request_;
};

/// Bottom dead point and the corners, each from both sides: the force may jump there.
std::vector<double> places_of(const ForceOverTurn& force, const ForceCorners& corners)
{
    std::vector<double> angles{0};
    for (const double past : corners.past_bottom)
        angles.push_back(past);
    for (const double height : corners.height)
        force.add_passages(height, angles);
    std::vector<double> places;
    for (const double angle : angles)
        for (const double off : {-beside, 0.0, beside})
            places.push_back(angle + off);
    return places;
}

double largest_near(const ForceOverTurn& force, const std::vector<double>& tips, int positions)
{
    const double step = full_turn / positions;
    double largest = 0;
    for (const double tip : tips)
        for (const double place : {std::floor(tip / step), std::ceil(tip / step)})
            largest = std::max(largest, force.magnitude(place * step));
    return largest;
}

}  // namespace

int positions_for_tip(const CycleHistory& history, const CycleRequest& request, const ForceCorners& corners)
{
    const ForceOverTurn force(history, request);
    if (!request.process_force || (corners.past_bottom.empty() && corners.height.empty()))
        return force.positions();
    const auto places = places_of(force, corners);
    double tip = 0, largest = 0;
    for (const double place : places)
        tip = std::max(tip, force.magnitude(place));
    for (const double sample : history.process_force)
        largest = std::max(largest, std::abs(sample));
    if (largest >= met * tip)
        return force.positions();
    std::vector<double> tips;
    for (const double place : places)
        if (force.magnitude(place) >= met * tip)
            tips.push_back(place);
    int best = force.positions();
    for (int count = best + 1; count <= most_often * force.positions(); ++count) {
        const double near = largest_near(force, tips, count);
        if (near > largest) {
            largest = near;
            best = count;
        }
        if (largest >= met * tip)
            break;
    }
    return best;
}

}  // namespace deadpoint::mechanism
