#include "deadpoint/press/translate/enclosures.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/translate/courses.hpp"
#include "deadpoint/press/translate/lookup.hpp"
#include "deadpoint/surroundings/radiation.hpp"

#include <algorithm>
#include <map>

namespace deadpoint::press {
namespace {

constexpr double air_capacity = 1.2 * 1006;  // [J/m3/K]

}  // namespace

std::vector<Enclosure> enclosures(const casefile::Case& input, const Machine& machine)
{
    std::vector<Enclosure> result;
    for (const auto& [name, given] : input.enclosures) {
        const double share = modelled_share(machine);
        const double in_volume = air_capacity * given.volume.value_or(0);
        const double by_changes = in_volume * given.air_changes.value_or(0) / hour;
        result.push_back({name, share * given.heat_capacity.value_or(in_volume),
                          share * given.exchange.value_or(by_changes),
                          given.temperature.value_or(input.machine.initial_temperature)});
    }
    return result;
}

int enclosure_of(const casefile::Case& input, const std::string& surface)
{
    int index = 0;
    for (const auto& [name, enclosure] : input.enclosures) {
        if (std::ranges::find(enclosure.surfaces, surface) != enclosure.surfaces.end())
            return index;
        ++index;
    }
    return -1;
}

std::vector<RadiantRoom> radiation_inside(const std::vector<SurfaceCondition>& surfaces, const Machine& machine)
{
    std::map<int, RadiantRoom> rooms;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        if (surfaces[i].enclosure >= 0 && surfaces[i].emissivity > 0)
            rooms[surfaces[i].enclosure].surfaces.push_back(static_cast<int>(i));
    std::vector<RadiantRoom> result;
    for (auto& [enclosure, room] : rooms) {
        std::vector<double> areas, emissivities;
        for (const int i : room.surfaces) {
            const auto& surface = surfaces[static_cast<std::size_t>(i)];
            areas.push_back(machine.surfaces[static_cast<std::size_t>(surface.surface)].area);
            emissivities.push_back(surface.emissivity);
        }
        room.exchange = surroundings::enclosure_exchange(areas, emissivities);
        result.push_back(std::move(room));
    }
    return result;
}

std::vector<TimeCourse> enclosure_power(const casefile::Case& input, const Machine& machine,
                                        const casefile::Segment& segment)
{
    std::vector<TimeCourse> result;
    for (const auto& [name, given] : input.enclosures)
        result.push_back(given.power && (segment.speed > 0 || given.at_rest)
                             ? scaled_power(*given.power, modelled_share(machine))
                             : TimeCourse{});
    return result;
}

}  // namespace deadpoint::press
