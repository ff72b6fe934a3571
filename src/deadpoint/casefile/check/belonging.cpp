#include "deadpoint/casefile/check/belonging.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/names/pattern.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace deadpoint::casefile {
namespace {

constexpr double nearly_aligned = 1e-3;  // directions whose angle has a smaller sine count as the same
constexpr double same_place = 1e-4;      // [m]

class Belonging : private Findings {
public:
    explicit Belonging(const Case& c) : Findings(c) {}

    std::vector<Finding> run()
    {
        if (c_.chain)
            check_chain(*c_.chain);
        check_bodies();
        for (const auto& [name, joint] : c_.joints)
            check_joint("joints." + name, name, joint);
        check_oil();
        return take();
    }

private:
    /// Bodies of the parts that a surface names; empty if it names none, or the case has no such surface.
    [[nodiscard]] std::set<std::string> bodies_of(const std::string& surface) const
    {
        std::set<std::string> bodies;
        const auto found = c_.surfaces.find(surface);
        if (found == c_.surfaces.end())
            return bodies;
        for (const auto& pattern : found->second.parts)
            for (const auto& [name, part] : c_.parts)
                if (matches(pattern, name))
                    bodies.insert(part.body);
        return bodies;
    }
    [[nodiscard]] std::string ground() const
    {
        const auto found = std::ranges::find_if(c_.bodies, [](const auto& body) { return body.second.ground; });
        return found == c_.bodies.end() ? std::string{} : found->first;
    }
    [[nodiscard]] bool is_thermal(const std::string& body) const
    {
        const auto found = c_.bodies.find(body);
        return found != c_.bodies.end() && found->second.thermal_only;
    }

    void require_on(const std::string& path, const std::string& surface, const std::string& body, std::string_view role)
    {
        const auto bodies = bodies_of(surface);
        if (bodies.empty() || body.empty() || bodies.contains(body))
            return;
        report("inconsistent", path,
               fmt::format("surface '{}' lies on body '{}', not on '{}', {}", surface, fmt::join(bodies, "', '"), body,
                           role),
               fmt::format("name a surface of parts of body '{}'{}", body, surfaces_of(body)));
    }
    /// ": these are a, b", of the surfaces with a plane.
    [[nodiscard]] std::string surfaces_of(const std::string& body) const
    {
        std::vector<std::string> names;
        for (const auto& [name, surface] : c_.surfaces)
            if (surface.select == Surface::Select::plane && bodies_of(name).contains(body))
                names.push_back(name);
        return names.empty() ? std::string{} : fmt::format(", such as {}", fmt::join(names, ", "));
    }
    void check_chain(const Chain& chain)
    {
        require_on("chain.slide_surface", chain.slide_surface, chain.slide_body, "the slide");
        require_on("chain.ground_surface", chain.ground_surface, ground(), "the ground");
        if (bodies_of(chain.table_surface).contains(chain.slide_body))
            report("inconsistent", "chain.table_surface",
                   fmt::format("surface '{}' lies on the slide itself, '{}'", chain.table_surface, chain.slide_body),
                   fmt::format("name the surface of the table that faces the slide{}", surfaces_of(ground())));
    }

    void check_bodies()
    {
        const bool moves = std::ranges::any_of(c_.joints, [](const auto& joint) { return joint.second.driver; });
        for (const auto& [name, body] : c_.bodies) {
            const auto& of = name;
            const bool has_parts = std::ranges::any_of(c_.parts, [&](const auto& p) { return p.second.body == of; });
            const bool jointed = std::ranges::any_of(c_.joints, [&](const auto& j) {
                return std::ranges::find(j.second.bodies, of) != j.second.bodies.end();
            });
            if (!jointed && !has_parts)
                warn("unused", "bodies." + name,
                     fmt::format("body '{}' has no part and no joint: nothing is computed for it, and its weight and "
                                 "loads are missing",
                                 name),
                     fmt::format("remove it, or give it parts with body = \"{}\" and a joint that names it in `bodies`",
                                 name));
            else if (!jointed && moves && !body.ground && !body.thermal_only)
                warn("unheld", "bodies." + name,
                     fmt::format("no joint holds body '{}': it neither moves nor presses, and its weight loads no "
                                 "joint",
                                 name),
                     "add the joint that names it in `bodies`; if it is fixed to another body, let its parts belong "
                     "to that; if it is a bearing ring, mark it as thermal_only");
        }
    }

    void check_joint(const std::string& path, const std::string& name, const Joint& joint)
    {
        for (std::size_t i = 0; i < joint.interfaces.size(); ++i) {
            const auto here = fmt::format("{}.interfaces.{}", path, i);
            for (const auto& [key, side] :
                 {std::pair{"a", joint.interfaces[i].a}, std::pair{"b", joint.interfaces[i].b}}) {
                require_of_joint(fmt::format("{}.{}", here, key), name, joint, side);
                check_motion(fmt::format("{}.{}", here, key), name, joint, side);
            }
        }
        check_law(path + ".friction", joint);
    }
    void require_of_joint(const std::string& path, const std::string& name, const Joint& joint,
                          const std::string& surface)
    {
        const auto bodies = bodies_of(surface);
        const bool fits = std::ranges::any_of(bodies, [&](const std::string& body) {
            return is_thermal(body) || std::ranges::find(joint.bodies, body) != joint.bodies.end();
        });
        if (!bodies.empty() && !fits)
            report("inconsistent", path,
                   fmt::format("surface '{}' lies on body '{}', which is not of joint '{}'", surface,
                               fmt::join(bodies, "', '"), name),
                   fmt::format("name a surface of '{}'", fmt::join(joint.bodies, "' or '")));
    }
    // What touches in a slide lies along its travel; what touches around a pin is round about it, or flat across it.
    void check_motion(const std::string& path, const std::string& name, const Joint& joint, const std::string& side)
    {
        const auto found = c_.surfaces.find(side);
        if (found == c_.surfaces.end())
            return;
        const auto& surface = found->second;
        if (joint.kind == Joint::Kind::slide && surface.select == Surface::Select::plane) {
            const Vec3 normal = normal_of(surface);
            const double length = norm(joint.direction) * norm(normal);
            if (length > 0 &&
                std::abs(normal[0] * joint.direction[0] + normal[1] * joint.direction[1]) > nearly_aligned * length)
                warn("geometry", path,
                     fmt::format("surface '{}' lies across the travel of joint '{}', [{:.4g}, {:.4g}]: it would not "
                                 "slide but lift off",
                                 side, name, joint.direction[0], joint.direction[1]),
                     "name a face along the travel, or correct `direction`");
        }
        if (joint.kind != Joint::Kind::slide && surface.select == Surface::Select::cylinder && surface.centre) {
            const double off = norm(*surface.centre - joint.centre);
            if (surface.axis == Axis::z && off > same_place)
                warn("geometry", path,
                     fmt::format("surface '{}' is round about ({:.6g}, {:.6g}) mm, {:.4g} mm off the centre of joint "
                                 "'{}'",
                                 side, 1e3 * (*surface.centre)[0], 1e3 * (*surface.centre)[1], 1e3 * off, name),
                     "let both have the same centre");
        }
    }
    static Vec3 normal_of(const Surface& surface)
    {
        if (norm(surface.normal) > 0 || !surface.axis)
            return surface.normal;
        Vec3 normal{};
        normal[static_cast<std::size_t>(*surface.axis)] = 1;
        return normal;
    }

    void check_law(const std::string& path, const Joint& joint)
    {
        const auto found = c_.friction.find(joint.friction);
        if (found == c_.friction.end())
            return;
        const auto& law = found->second.law;
        const auto* fitted = std::get_if<CalibratedFriction>(&law);
        const bool of_guides =
            std::holds_alternative<GuideFriction>(law) || (fitted != nullptr && fitted->kind == FrictionKind::guide);
        const bool slides = joint.kind == Joint::Kind::slide;
        if (of_guides != slides)
            warn("inconsistent", path,
                 fmt::format(
                     "friction law '{}' is for {}, but the joint is a {}: its heat would follow the wrong motion",
                     joint.friction, of_guides ? "guides" : "bearings and pins",
                     slides                            ? "slide"
                     : joint.kind == Joint::Kind::ball ? "ball joint"
                                                       : "revolute joint"),
                 slides ? "name a law of kind = \"guide\"" : "name a law of kind = \"pin\" or \"rolling\"");
    }

    void check_oil()
    {
        for (const auto& [name, circuit] : c_.oil_circuits) {
            const bool sump = circuit.sump_volume > 0 || circuit.sump_loss > 0 || circuit.sump_temperature;
            if (circuit.inlet_temperature && sump)
                warn("unused", fmt::format("oil_circuits.{}.inlet_temperature", name),
                     "the circuit has a sump as well as an inlet temperature: a cooler then brings the oil to "
                     "`inlet_temperature`, whatever the sump has, and the sump changes no joint",
                     "remove `inlet_temperature` if there is no cooler, else the keys of the sump");
        }
    }
};

}  // namespace

std::vector<Finding> check_belonging(const Case& c) { return Belonging(c).run(); }

}  // namespace deadpoint::casefile
