#include "deadpoint/mechanism/process_force.hpp"

#include "deadpoint/core/table.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::mechanism {
namespace {

constexpr double same_angle = 1e-9;

void require(bool holds, const char* what, double value, const char* help)
{
    if (!holds || !std::isfinite(value))
        throw InputError(fmt::format("process force: {} is {:.6g}\n  help: {}", what, value, help));
}

void check_window(const AngleWindow& window)
{
    const char* help = "give an end after the start, at most one turn later";
    require(true, "the start of the window in degrees", degrees * window.start, help);
    require(window.end > window.start, "the end of the window in degrees", degrees * window.end, help);
    require(window.end - window.start <= full_turn * (1 + 1e-12), "the length of the window in degrees",
            degrees * (window.end - window.start), help);
}

/// Angle since the start of the window, within 0..2 pi, or slightly negative at the start itself.
double into(const AngleWindow& window, double past_bottom)
{
    double angle = std::fmod(past_bottom - window.start, full_turn);
    if (angle < -same_angle)
        angle += full_turn;
    return angle > full_turn - same_angle ? angle - full_turn : angle;
}

void check_table(const std::vector<double>& places, const std::vector<double>& forces, const char* what)
{
    if (places.empty() || places.size() != forces.size())
        throw InputError(
            fmt::format("process force: {} {} but {} forces\n  help: give one force for each, at least one",
                        places.size(), what, forces.size()));
    for (std::size_t i = 0; i < places.size(); ++i)
        if (!std::isfinite(places[i]) || !std::isfinite(forces[i]) || (i > 0 && !(places[i] > places[i - 1])))
            throw InputError(fmt::format("process force: point {} of the table ({}, {} N) is not finite, or its place "
                                         "is not above that of the point before\n  help: sort the {}, each once",
                                         i + 1, places[i], forces[i], what));
}

}  // namespace

ProcessForceLaw no_force()
{
    return [](double, double, double) { return 0.0; };
}

ProcessForceLaw elastic_contact(double stiffness, double interference)
{
    require(stiffness > 0, "the stiffness", stiffness, "give a stiffness above zero [N/m]");
    require(interference >= 0, "the interference", interference, "give a height of first contact of zero or more [m]");
    return [=](double, double height, double) { return stiffness * std::max(interference - height, 0.0); };
}

ProcessForceLaw elastic_contact_of_peak(double stiffness, double peak)
{
    require(stiffness > 0, "the stiffness", stiffness, "give a stiffness above zero [N/m]");
    require(peak >= 0, "the peak", peak, "give a force of zero or more [N]");
    return elastic_contact(stiffness, peak / stiffness);
}

ProcessForceLaw half_sine(double peak, const AngleWindow& window)
{
    check_window(window);
    require(true, "the peak", peak, "give a finite force [N]");
    return [=](double past_bottom, double, double) {
        const double share = into(window, past_bottom) / (window.end - window.start);
        return share > 0 && share < 1 ? peak * std::sin(std::numbers::pi * share) : 0.0;
    };
}

ProcessForceLaw rectangle(double force, const AngleWindow& window, double at_edges)
{
    check_window(window);
    require(true, "the force", force, "give a finite force [N]");
    require(at_edges >= 0 && at_edges <= 1, "the share at the edges", at_edges, "give a share within 0..1");
    const double length = window.end - window.start;
    if (length > full_turn - same_angle)
        return [=](double, double, double) { return force; };
    return [=](double past_bottom, double, double) {
        const double angle = into(window, past_bottom);
        if (std::abs(angle) < same_angle || std::abs(angle - length) < same_angle)
            return at_edges * force;
        return angle > 0 && angle < length ? force : 0.0;
    };
}

ProcessForceLaw force_over_angle(std::vector<double> past_bottom, std::vector<double> force)
{
    check_table(past_bottom, force, "angles");
    const double first = past_bottom.front();
    if (!(past_bottom.back() - first < full_turn))
        throw InputError(
            fmt::format("process force: the angles span {} rad\n  help: give less than one turn; the table "
                        "is closed by running back to its first point",
                        past_bottom.back() - first));
    past_bottom.push_back(first + full_turn);
    force.push_back(force.front());
    return [first, angles = std::move(past_bottom), forces = std::move(force)](double angle, double, double) {
        const double since = std::fmod(angle - first, full_turn);
        return interpolate_linear(angles, forces, first + (since < 0 ? since + full_turn : since)).value;
    };
}

ProcessForceLaw force_over_height(std::vector<double> height, std::vector<double> force, Strokes strokes)
{
    check_table(height, force, "heights");
    return [strokes, heights = std::move(height), forces = std::move(force)](double past_bottom, double at,
                                                                             double slide_speed) {
        const double value = at > heights.back() ? 0.0 : interpolate_linear(heights, forces, at).value;
        if (strokes == Strokes::both)
            return value;
        if (std::abs(past_bottom) < same_angle)
            return 0.5 * value;
        return slide_speed <= 0 ? value : 0.0;
    };
}

}  // namespace deadpoint::mechanism
