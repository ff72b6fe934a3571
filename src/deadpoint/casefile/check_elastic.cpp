#include "deadpoint/casefile/findings.hpp"

#include <fmt/format.h>

namespace deadpoint::casefile {

std::vector<Finding> check_elastic(const Case& c)
{
    Findings findings(c);
    if (c.foundation) {
        const auto& foundation = *c.foundation;
        findings.refer("foundation.surface", "surface", foundation.surface, c.surfaces);
        if (foundation.surface.empty() && !c.chain) {
            findings.report("missing-key", "foundation", "nothing says which surface the feet are",
                            "add surface = \"feet\", the name of a surface");
        }
        if (c.machine.half_model && foundation.gravity > 0 && foundation.gravity_direction[0] != 0) {
            findings.report("inconsistent", "foundation.gravity_direction",
                            "in a half model nothing may pull across the plane of symmetry",
                            "let it be 0 along x, or model the whole machine");
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
