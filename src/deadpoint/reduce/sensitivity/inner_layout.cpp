#include "deadpoint/reduce/sensitivity/inner_layout.hpp"

#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/joints.hpp"

#include <algorithm>

namespace deadpoint::reduce {
namespace {

/// Hands out places.
class Places {
public:
    explicit Places(InnerLayout& layout) : layout_(layout) {}
    InnerPlace next(double capacity = 0)
    {
        layout_.capacity.push_back(capacity);
        return layout_.count() - 1;
    }

private:
    InnerLayout& layout_;
};

// Heat that leaves a sump per kelvin, with the oil's way back [W/K].
double leaving(const OilCourse& circuit, double flow, const heat::JointBalance& joints)
{
    double kept = 1;  // of a difference at the inlet, at the outlet
    for (const auto& joint : circuit.joints) {
        double exchange = 0;
        for (const int index : joint) {
            const auto i = static_cast<std::size_t>(index);
            const double oil = joints.laws()[i].oil;
            exchange += oil * joints.area(i) * (1 - oil / joints.film_sum(i));
        }
        kept *= flow > 0 ? 1 - exchange / flow : 1;
    }
    return circuit.sump_loss + flow * (1 - kept);
}

OilPath path_of(const HeatProblem& problem, std::size_t circuit, const HeatSegment& segment,
                const heat::JointBalance& joints, Places& places)
{
    using Feed = OilPath::Feed;
    const auto& course = problem.oil[circuit];
    OilPath path{circuit, Feed::cooler, segment.oil_flow[circuit], {}};
    double capacity = 0;
    if (!course.cooled) {
        const bool still = course.sump_capacity <= 0 && leaving(course, path.flow, joints) <= 0;
        path.feed = still ? Feed::still : Feed::sump;
        capacity = still ? 1 : course.sump_capacity;
    }
    for (const auto& joint : course.joints)
        if (!joint.empty())
            path.stops.push_back({places.next(path.stops.empty() ? capacity : 0), {joint.begin(), joint.end()}});
    return path;
}

bool is_in_room(const HeatProblem& problem, std::size_t surface)
{
    return std::ranges::any_of(problem.radiation, [&](const RadiantRoom& room) {
        return std::ranges::find(room.surfaces, static_cast<int>(surface)) != room.surfaces.end();
    });
}

}  // namespace

InnerLayout inner_layout(const HeatProblem& problem, const HeatSegment& segment, const heat::HeatGeometry& geometry,
                         const heat::JointBalance& joints)
{
    InnerLayout layout;
    Places places(layout);
    layout.capacity.assign(problem.sources.size(), 0.0);
    layout.oil_of.assign(joints.laws().size(), -1);
    for (std::size_t k = 0; k < problem.oil.size(); ++k) {
        layout.oil.push_back(path_of(problem, k, segment, joints, places));
        for (const auto& stop : layout.oil.back().stops)
            for (const auto i : stop.interfaces)
                layout.oil_of[i] = stop.place;
    }
    layout.first_air = layout.count();
    for (const auto& enclosure : problem.enclosures)
        places.next(enclosure.capacity);
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s)
        if (heat::follows_temperature(problem.surfaces[s]) && geometry.surface_area[s] > 0) {
            const auto outside = places.next(), slope = places.next();
            layout.films.push_back({s, outside, slope, is_in_room(problem, s) ? places.next() : -1});
        }
    return layout;
}

}  // namespace deadpoint::reduce
