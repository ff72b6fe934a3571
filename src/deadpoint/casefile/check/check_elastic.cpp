#include "deadpoint/casefile/check/check_elastic.hpp"

#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_elastic.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <fmt/format.h>

namespace deadpoint::casefile {

namespace {

bool is_held_sideways(const Foundation& foundation)
{
    return foundation.kind == Foundation::Kind::clamped ||
           (foundation.kind == Foundation::Kind::elastic && foundation.horizontal_stiffness.value_or(0) > 0);
}

// Plane feet have a known direction; other feet are assumed to face along y.
bool pulls_along_feet(const Case& c)
{
    const auto& name = c.foundation->surface.empty() && c.chain ? c.chain->ground_surface : c.foundation->surface;
    const auto feet = c.surfaces.find(name);
    const bool plane = feet != c.surfaces.end() && feet->second.select == Surface::Select::plane;
    if (plane && !feet->second.axis) {
        return norm(cross(normalised(feet->second.normal), normalised(c.machine.gravity_direction))) > aligned;
    }
    const auto axis = static_cast<std::size_t>(plane ? *feet->second.axis : Axis::y);
    for (std::size_t i = 0; i < 3; ++i) {
        if (i != axis && c.machine.gravity_direction[i] != 0) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::vector<Finding> check_elastic(const Case& c)
{
    Findings findings(c);
    if (c.foundation) {
        const auto& foundation = *c.foundation;
        findings.refer("foundation.surface", "surface", foundation.surface, c.surfaces);
        if (foundation.surface.empty() && !c.chain) {
            findings.report("missing-key", "foundation", "the surface of the feet is not given",
                            "add surface = \"feet\", the name of a surface");
        }
        if (foundation.gravity > 0 && !is_held_sideways(foundation) && pulls_along_feet(c)) {
            findings.report("inconsistent", "foundation.gravity",
                            "the feet slide freely, so nothing holds the machine against gravity along their plane",
                            "let gravity_direction of [machine] act across the feet, or add kind = \"clamped\"");
        }
    }
    for (const auto& [name, preload] : c.preload) {
        for (std::size_t i = 0; i < preload.parts.size(); ++i) {
            findings.check_pattern(fmt::format("preload.{}.parts.{}", name, i), preload.parts[i]);
        }
        for (std::size_t i = 0; i < preload.closes.size(); ++i) {
            findings.check_pair(fmt::format("preload.{}.closes.{}", name, i), preload.closes[i]);
        }
    }
    for (std::size_t i = 0; i < c.output.stress.size(); ++i) {
        const auto& name = c.output.stress[i];
        if (!c.bodies.contains(name)) {
            findings.check_pattern(fmt::format("output.stress.{}", i), name);
        }
    }
    return findings.take();
}

}  // namespace deadpoint::casefile
