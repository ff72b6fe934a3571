#include "deadpoint/press/machine/travel.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/mechanism/planar_system.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "deadpoint/press/translate/loads.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace deadpoint::press {
namespace {

constexpr int positions = 720;

bool travels(const casefile::Joint& joint)
{
    return joint.kind == casefile::Joint::Kind::slide && joint.swept && !joint.turns_fully && !joint.interfaces.empty();
}

// The motion needs no masses and no process force.
CycleHistory motion_of(const casefile::Case& input, const Linkage& linkage, const casefile::Segment& segment)
{
    auto request = describe_cycle(input, segment, 0);
    request.process_force = {};
    request.masses.assign(linkage.bodies.size(), BodyMass{});
    request.positions = positions;
    return mechanism::analyse_cycle(linkage, request);
}

}  // namespace

std::vector<Stop> condensed(const std::vector<double>& position, const std::vector<double>& share, int count)
{
    std::vector<std::size_t> order(position.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return position[i]; });
    const double each = 1.0 / count;
    std::vector<Stop> stops(static_cast<std::size_t>(count), Stop{0, each});
    std::vector<double> filled(stops.size(), 0.0);
    std::size_t bin = 0;
    for (const auto i : order) {
        double left = share[i];
        while (left > 0) {
            const bool last = bin + 1 == stops.size();
            const double taken = last ? left : std::min(left, each - filled[bin]);
            stops[bin].position += taken * position[i];
            filled[bin] += taken;
            left -= taken;
            if (!last && filled[bin] >= each)
                ++bin;
        }
    }
    for (std::size_t k = 0; k < stops.size(); ++k)
        stops[k].position /= filled[k];
    return stops;
}

std::vector<double> displacement(const Linkage& linkage, int joint, const CycleHistory& history)
{
    const auto& slide = linkage.joints[static_cast<std::size_t>(joint)];
    const auto& a = history.bodies[static_cast<std::size_t>(slide.body_a)].pose;
    const auto& b = history.bodies[static_cast<std::size_t>(slide.body_b)].pose;
    std::vector<double> result;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Vec2 apart = mechanism::place(a[i], slide.centre) - mechanism::place(b[i], slide.centre);
        const double c = std::cos(b[i].angle), s = std::sin(b[i].angle);
        const Vec2 direction{c * slide.direction[0] - s * slide.direction[1],
                             s * slide.direction[0] + c * slide.direction[1]};
        result.push_back(dot(apart, direction));
    }
    return result;
}

std::map<std::string, Travel> describe_travel(const casefile::Case& input, int count)
{
    std::map<std::string, Travel> result;
    const int segment = first_running_segment(input);
    const bool any = std::ranges::any_of(input.joints, [](const auto& joint) { return travels(joint.second); });
    if (!any || segment < 0 || !has_loads(input))
        return result;
    const Linkage linkage = describe_linkage(input);
    const auto history = motion_of(input, linkage, input.operation[static_cast<std::size_t>(segment)]);
    const auto shares = tribology::turn_weights(history.time, history.period);
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        const auto& joint = linkage.joints[j];
        if (!travels(input.joints.at(joint.name)))
            continue;
        const auto course = displacement(linkage, static_cast<int>(j), history);
        const auto [low, high] = std::ranges::minmax(course);
        if (high - low < least_stroke)
            continue;
        auto stops = condensed(course, shares, count);
        stops.insert(stops.begin(), Stop{low, 0});
        stops.push_back(Stop{high, 0});
        Travel travel{linkage.bodies[static_cast<std::size_t>(joint.body_a)],
                      linkage.bodies[static_cast<std::size_t>(joint.body_b)],
                      {}};
        for (const auto& stop : stops)
            travel.stops.push_back(
                {{stop.position * joint.direction[0], stop.position * joint.direction[1], 0}, stop.share});
        result.emplace(joint.name, std::move(travel));
    }
    return result;
}

}  // namespace deadpoint::press
