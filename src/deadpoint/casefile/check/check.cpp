#include "deadpoint/casefile/check/check.hpp"

#include "deadpoint/casefile/check/belonging.hpp"
#include "deadpoint/casefile/check/check_bonds.hpp"
#include "deadpoint/casefile/check/check_elastic.hpp"
#include "deadpoint/casefile/check/check_enclosures.hpp"
#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/check/plausible.hpp"
#include "deadpoint/casefile/describe/accuracy.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/case_films.hpp"
#include "deadpoint/casefile/describe/case_heat.hpp"
#include "deadpoint/casefile/describe/case_loads.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/formula.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <set>
#include <string_view>

namespace deadpoint::casefile {
namespace {

class Checker : private Findings {
public:
    explicit Checker(const Case& c) : Findings(c) {}

    std::vector<Finding> run()
    {
        check_bodies();
        check_parts_and_joints();
        check_oil_circuits();
        check_heat_sources();
        check_air();
        check_places();
        if (c_.chain) {
            check_chain(*c_.chain);
        }
        add_all(check_elastic(c_));
        refer("mechanism.slide_body", "body", c_.mechanism.slide_body, c_.bodies);
        check_slide();
        add_all(check_directions(c_));
        check_process_force();
        check_mirrors();
        check_operation();
        if (auto finding = check_accuracy(c_)) {
            add(std::move(*finding));
        }
        check_reference();
        add_all(check_belonging(c_));
        add_all(check_values(c_));
        return take();
    }

private:
    void add_all(std::vector<Finding> findings)
    {
        for (auto& finding : findings) {
            add(std::move(finding));
        }
    }

    void check_parts_and_joints()
    {
        for (const auto& [name, part] : c_.parts) {
            check_part(name, part);
        }
        for (const auto& [name, law] : c_.friction) {
            refer("friction." + name + ".lubricant", "lubricant", law.lubricant, c_.lubricants);
        }
        for (const auto& [name, joint] : c_.joints) {
            check_joint("joints." + name, joint);
        }
        check_drivers();
        for (const auto& [law, coefficient] : c_.oil) {
            refer("oil." + law, "friction law", law, c_.friction);
        }
        for (const auto& [law, growth] : c_.oil_with_speed) {
            refer("oil_with_speed." + law, "friction law", law, c_.friction);
        }
    }

    void check_heat_sources()
    {
        for (const auto& [name, source] : c_.heat_sources) {
            check_heat_source("heat_sources." + name, source);
            if (c_.joints.contains(name)) {
                report("ambiguous-name", "heat_sources." + name,
                       fmt::format("'{}' is a joint as well as a source of heat", name),
                       std::string("rename one of the two: the list of causes names both"));
            }
        }
    }

    void check_air()
    {
        for (const auto& [name, enclosure] : c_.enclosures) {
            for (std::size_t i = 0; i < enclosure.surfaces.size(); ++i) {
                refer(fmt::format("enclosures.{}.surfaces.{}", name, i), "surface", enclosure.surfaces[i], c_.surfaces);
            }
        }
        add_all(check_enclosures(c_));
        for (const auto& [name, surface] : c_.surfaces) {
            check_surface("surfaces." + name, surface);
        }
    }

    void check_places()
    {
        for (const auto& [name, probe] : c_.probes) {
            refer("probes." + name + ".part", "part", probe.part, c_.parts);
        }
        for (std::size_t i = 0; i < c_.machine.unbonded.size(); ++i) {
            check_pair(fmt::format("machine.unbonded.{}", i), c_.machine.unbonded[i]);
        }
        add_all(check_bonds(c_));
        if (c_.crankshaft) {
            refer("crankshaft.material", "material", c_.crankshaft->material, c_.materials);
        }
    }

    void check_reference()
    {
        if (!c_.reference) {
            return;
        }
        for (const auto& [probe, rise] : c_.reference->rises) {
            refer("reference.rises." + probe, "probe", probe, c_.probes);
        }
    }

    void check_bodies()
    {
        std::string first;
        for (const auto& [name, body] : c_.bodies) {
            if (!body.ground) {
                continue;
            }
            if (first.empty()) {
                first = name;
            } else {
                report("ground", "bodies." + name + ".ground",
                       fmt::format("'{}' and '{}' are both the ground", first, name),
                       "let exactly one body be the ground");
            }
        }
        if (first.empty() && !c_.bodies.empty()) {
            report("ground", "bodies", "no body is the ground", "add ground = true to the body that stands still");
        }
    }

    void check_part(const std::string& name, const Part& part)
    {
        refer("parts." + name + ".body", "body", part.body, c_.bodies);
        refer("parts." + name + ".material", "material", part.material, c_.materials);
        if (c_.surfaces.contains(name)) {
            report("ambiguous-name", "surfaces." + name, fmt::format("'{}' is a part as well as a surface", name),
                   "rename one of the two: interfaces name either");
        }
    }

    void check_joint(const std::string& path, const Joint& joint)
    {
        for (std::size_t i = 0; i < joint.bodies.size(); ++i) {
            refer(fmt::format("{}.bodies.{}", path, i), "body", joint.bodies[i], c_.bodies);
        }
        if (joint.bodies.size() == 2 && joint.bodies[0] == joint.bodies[1]) {
            report("inconsistent", path + ".bodies.1", "a joint cannot connect a body to itself",
                   "name the other body");
        }
        refer(path + ".friction", "friction law", joint.friction, c_.friction);
        std::set<std::string> names;
        for (std::size_t i = 0; i < joint.interfaces.size(); ++i) {
            const auto& interface = joint.interfaces[i];
            const std::string here = fmt::format("{}.interfaces.{}", path, i);
            check_side(here + ".a", interface.a, interface.diameter.has_value());
            check_side(here + ".b", interface.b, interface.diameter.has_value());
            check_heat_place(here, joint, interface);
            if (const auto* elements = std::get_if<RollingElements>(&interface.conductance)) {
                refer(here + ".conductance.material", "material", elements->material, c_.materials);
            }
            if (!interface.a.empty() && interface.a == interface.b) {
                report("inconsistent", here + ".b", fmt::format("'{}' cannot touch itself", interface.b),
                       "name the other side");
            }
            check_body(here + ".a", joint, interface.a);
            check_body(here + ".b", joint, interface.b);
            if (!interface.name.empty() && !names.insert(interface.name).second) {
                report("duplicate-name", here + ".name", fmt::format("two interfaces are called '{}'", interface.name),
                       "give each a name of its own");
            }
        }
        names.clear();
        for (std::size_t i = 0; i < joint.elements.size(); ++i) {
            if (!joint.elements[i].name.empty() && !names.insert(joint.elements[i].name).second) {
                report("duplicate-name", fmt::format("{}.elements.{}.name", path, i),
                       fmt::format("two elements are called '{}'", joint.elements[i].name),
                       "give each a name of its own");
            }
        }
        if (!joint.friction.empty() && joint.interfaces.empty() && c_.friction.contains(joint.friction)) {
            report("inconsistent", path + ".friction",
                   "the joint has friction, but no interface that receives its heat",
                   "add interfaces, or remove `friction`");
        }
    }

    void check_heat_place(const std::string& path, const Joint& joint, const Interface& interface)
    {
        refer(path + ".heat_into", "part", interface.heat_into, c_.parts);
        if (!interface.load_zone) {
            return;
        }
        const bool grounded = std::ranges::any_of(joint.bodies, [&](const std::string& body) {
            const auto found = c_.bodies.find(body);
            return found != c_.bodies.end() && found->second.ground;
        });
        if (joint.kind != Joint::Kind::revolute || !grounded || (joint.turns_fully && !interface.stands_still)) {
            report("inconsistent", path + ".load_zone",
                   "a load zone needs a revolute joint with the ground and an interface that does not turn",
                   "remove `load_zone`, or add stands_still = true to the outer ring's interface");
        }
    }

    void check_oil_circuits()
    {
        std::map<std::string, std::string> served;
        for (const auto& [name, circuit] : c_.oil_circuits) {
            const std::string path = "oil_circuits." + name;
            refer(path + ".lubricant", "lubricant", circuit.lubricant, c_.lubricants);
            const auto oil = c_.lubricants.find(circuit.lubricant);
            if (oil != c_.lubricants.end() && !(oil->second.density > 0)) {
                report("missing-key", path + ".lubricant",
                       fmt::format("the density of '{}' is missing", circuit.lubricant),
                       fmt::format("add density = \"870 kg/m^3\" to [lubricants.{}]", circuit.lubricant));
            }
            for (std::size_t i = 0; i < circuit.joints.size(); ++i) {
                const auto& joint = circuit.joints[i];
                const std::string here = fmt::format("{}.joints.{}", path, i);
                refer(here, "joint", joint, c_.joints);
                const auto [other, fresh] = served.emplace(joint, name);
                if (!fresh) {
                    report("duplicate-name", here, fmt::format("joint '{}' is served twice", joint),
                           fmt::format("name it once; circuit '{}' has it already", other->second));
                }
                check_reached_by_oil(here, joint);
            }
        }
    }

    void check_reached_by_oil(const std::string& path, const std::string& name)
    {
        const auto joint = c_.joints.find(name);
        if (joint == c_.joints.end()) {
            return;
        }
        const auto by_row = c_.oil.find(joint->second.friction);
        const bool reached = (by_row != c_.oil.end() && by_row->second > 0) ||
                             std::ranges::any_of(joint->second.interfaces, [](const auto& i) { return i.oil > 0; });
        if (!reached) {
            report("inconsistent", path, fmt::format("joint '{}' gives no heat to oil", name),
                   "add a coefficient to [oil] for its friction law, or `oil` to its interfaces");
        }
    }

    void check_heat_source(const std::string& path, const HeatInput& source)
    {
        for (std::size_t i = 0; i < source.parts.size(); ++i) {
            check_pattern(fmt::format("{}.parts.{}", path, i), source.parts[i]);
        }
        refer(path + ".surface", "surface", source.surface, c_.surfaces);
    }

    void check_side(const std::string& path, const std::string& name, bool is_cylinder)
    {
        if (name.empty() || c_.surfaces.contains(name)) {
            return;
        }
        if (c_.parts.contains(name)) {
            if (!is_cylinder) {
                report("inconsistent", path,
                       fmt::format("'{}' is a part, but an interface without diameter joins surfaces", name),
                       "add `diameter`, or name a surface");
            }
            return;
        }
        auto names = names_of(c_.surfaces);
        if (is_cylinder) {
            const auto parts = names_of(c_.parts);
            names.insert(names.begin(), parts.begin(), parts.end());
        }
        report_unknown(path, is_cylinder ? "part or surface" : "surface", name, names);
    }

    /// Checks that an interface lies on the bodies of its joint or on bearing rings.
    void check_body(const std::string& path, const Joint& joint, const std::string& name)
    {
        const auto part = c_.parts.find(name);
        if (part == c_.parts.end()) {
            return;
        }
        const auto body = c_.bodies.find(part->second.body);
        if (body == c_.bodies.end() || body->second.thermal_only) {
            return;
        }
        if (std::ranges::find(joint.bodies, body->first) != joint.bodies.end()) {
            return;
        }
        report("inconsistent", path,
               fmt::format("part '{}' belongs to body '{}', which is not of this joint", name, body->first),
               "name a part of the joint's bodies, or mark the body as thermal_only if it is a bearing ring");
    }

    void check_mirrors()
    {
        for (const auto& [name, body] : c_.bodies) {
            if (body.mirror && !c_.parts.empty() && !c_.machine.half_model) {
                report("mirror", "bodies." + name + ".mirror",
                       fmt::format("'{}' has a mirror image, but the machine is modelled as a whole", name),
                       "describe both bodies, or add half_model = true to [machine] and keep one half");
            }
            for (const auto& [joint_name, joint] : c_.joints) {
                if (body.mirror && joint.driver && std::ranges::find(joint.bodies, name) != joint.bodies.end()) {
                    report(
                        "mirror", "bodies." + name + ".mirror",
                        fmt::format("'{}' has a mirror image, but joint '{}' drives it, and there is one driver only",
                                    name, joint_name),
                        "let a body that exists once be driven");
                }
            }
        }
    }

    /// Refuses mistakes such as "1 ms", which would fill memory and disk.
    void check_row_count()
    {
        constexpr double most_rows = 1e6;
        double duration = 0;
        for (const auto& segment : c_.operation) {
            duration += segment.duration;
        }
        if (const double rows = duration / c_.output.history_interval; rows > most_rows) {
            report("too-many", "output.history_interval",
                   fmt::format("history.csv would have {:.2g} rows, but may have at most {:.0e}", rows, most_rows),
                   "make the interval longer");
        }
    }

    /// Smallest number of steps of the operation [-]: step sizes double from the first to the largest.
    [[nodiscard]] double least_steps() const
    {
        double steps = 0;
        for (const auto& segment : c_.operation) {
            double reached = 0, length = c_.numerics.initial_step;
            for (; length < c_.numerics.max_step && reached < segment.duration; length *= 2, ++steps) {
                reached += length;
            }
            steps += std::ceil(std::max(0.0, segment.duration - reached) / c_.numerics.max_step);
        }
        return steps;
    }

    /// Limits the number of steps, since each step is kept until the end of the run.
    void check_step_count()
    {
        constexpr double most_steps = 1e6, many_steps = 1e5;
        const double steps = c_.parts.empty() ? 0 : least_steps();
        const auto help = "lengthen `max_step`, or shorten the `duration` of the operation";
        if (steps > most_steps) {
            report("too-many", "numerics.max_step",
                   fmt::format("the run would take {:.3g} time steps or more, but may take at most {:.0e}", steps,
                               most_steps),
                   help);
        } else if (steps > many_steps) {
            warn("many-steps", "numerics.max_step", fmt::format("the run takes {:.3g} time steps or more", steps),
                 help);
        }
    }

    void check_operation()
    {
        check_row_count();
        check_step_count();
        for (std::size_t i = 0; i < c_.operation.size(); ++i) {
            if (!c_.parts.empty() && c_.operation[i].duration == 0) {
                report("no-duration", fmt::format("operation.{}.duration", i),
                       "the segment has no duration: 'duration' is missing or zero",
                       "state how long the segment lasts, like duration = \"4 h\"");
            }
        }
        std::set<std::string> names;
        for (std::size_t i = 0; c_.crankshaft && i < c_.crankshaft->bearings.size(); ++i) {
            const auto& name = c_.crankshaft->bearings[i].name;
            if (!name.empty() && !names.insert(name).second) {
                report("duplicate-name", fmt::format("crankshaft.bearings.{}.name", i),
                       fmt::format("two bearings are called '{}'", name), "give each a name of its own");
            }
        }
    }

    void check_slide()
    {
        const auto& slide = c_.mechanism.slide_body;
        const bool guided = std::ranges::any_of(c_.joints, [&](const auto& joint) {
            return joint.second.kind == Joint::Kind::slide &&
                   std::ranges::find(joint.second.bodies, slide) != joint.second.bodies.end();
        });
        if (!guided && c_.bodies.contains(slide)) {
            warn("guide", "mechanism.slide_body",
                 fmt::format("no guide holds '{}': it moves as its other joints let it, not along a line", slide),
                 "name the body that runs in the guides, or add a joint of kind = \"slide\" to it");
        }
    }

    void check_process_force()
    {
        if (!c_.process_force) {
            return;
        }
        const auto& process = *c_.process_force;
        const bool rigid = c_.crankshaft && c_.crankshaft->model == Crankshaft::Model::rigid;
        using Kind = ProcessForce::Kind;
        const auto kind = process.kind.value_or(rigid ? Kind::rectangular : Kind::elastic);
        const bool window = kind == Kind::half_sine || kind == Kind::rectangular;
        for (const auto& [key, stated] :
             {std::pair{"from", process.from.has_value()}, std::pair{"to", process.to.has_value()}}) {
            if (stated && !window) {
                warn("unused", fmt::format("process_force.{}", key),
                     fmt::format("'{}' has no effect: only a half-sine or rectangular force acts between two crank "
                                 "angles",
                                 key),
                     "remove it, or add kind = \"half_sine\"");
            }
        }
        const bool idle = std::ranges::all_of(c_.operation, [](const Segment& segment) { return segment.force == 0; });
        if (idle && process.kind && process.kind != Kind::none) {
            warn("unused", "process_force.kind",
                 "there is no process force: every segment of [[operation]] has a force of 0",
                 "add force = \"300 kN\" to the segment in which the press works");
        }
    }

    void check_drivers()
    {
        std::string first;
        for (const auto& [name, joint] : c_.joints) {
            if (!joint.driver) {
                continue;
            }
            if (!first.empty()) {
                report("driver", "joints." + name + ".driver", fmt::format("'{}' and '{}' both drive", first, name),
                       "let exactly one joint be the driver");
            }
            if (first.empty()) {
                first = name;
            }
            const bool grounded = std::ranges::any_of(joint.bodies, [&](const std::string& body) {
                const auto found = c_.bodies.find(body);
                return found == c_.bodies.end() || found->second.ground;
            });
            if (!grounded) {
                report("driver", "joints." + name + ".driver", "the driver does not connect to the ground",
                       "let the joint of crankshaft and frame be the driver");
            }
        }
        if (first.empty() && c_.chain) {
            report("driver", "joints", "no joint drives the linkage",
                   "add driver = true to the joint of crankshaft and frame");
        }
    }

    void check_surface(const std::string& path, const Surface& surface)
    {
        for (std::size_t i = 0; i < surface.parts.size(); ++i) {
            check_pattern(fmt::format("{}.parts.{}", path, i), surface.parts[i]);
        }
        if (surface.temperature_formula.empty()) {
            return;
        }
        try {
            const Formula formula(surface.temperature_formula);
            if (!formula.depends_on_place()) {
                check_course(path + ".temperature_formula", formula);
            }
        } catch (const InputError& error) {
            const std::string text = error.what();
            report("formula", path + ".temperature_formula", text.substr(0, text.find("; write")),
                   "write it in x, y, z (metres) and t (seconds), like \"293.15 + 10*sin(pi*t/40)\"");
        }
    }

    /// Checks the temperatures of a formula that does not depend on place, over the operation.
    void check_course(const std::string& path, const Formula& formula)
    {
        constexpr int samples = 1000;
        double end = 0;
        for (const auto& segment : c_.operation) {
            end += segment.duration;
        }
        double least = std::numeric_limits<double>::infinity();
        double when = 0;
        for (int i = 0; i <= samples; ++i) {
            const double time = end * i / samples;
            const double value = value_or_nan(formula, time);
            if (!(value >= least)) {
                least = value;
                when = time;
            }
            if (!(value > 0)) {
                break;
            }
        }
        if (!(least > 0)) {
            report("formula", path,
                   std::isnan(least) ? fmt::format("the formula is not finite at t = {:.6g} s", when)
                                     : fmt::format("{:.6g} K at t = {:.6g} s is not above absolute zero", least, when),
                   "its result is in kelvin: 20 degC are 293.15");
        } else if (least < coldest_meant) {
            warn("cold-formula", path,
                 fmt::format("the formula gives {:.6g} K ({:.4g} degC) at t = {:.6g} s", least, least - zero_celsius,
                             when),
                 "if degC are meant, add 273.15: the result of a formula is in kelvin");
        }
    }

    static double value_or_nan(const Formula& formula, double time)
    {
        try {
            return formula({}, time);
        } catch (const DomainError&) {
            return std::numeric_limits<double>::quiet_NaN();
        }
    }

    void check_chain(const Chain& chain)
    {
        refer("chain.slide_body", "body", chain.slide_body, c_.bodies);
        refer("chain.slide_surface", "surface", chain.slide_surface, c_.surfaces);
        refer("chain.table_surface", "surface", chain.table_surface, c_.surfaces);
        refer("chain.ground_surface", "surface", chain.ground_surface, c_.surfaces);
        refer("chain.crank_joint", "joint", chain.crank_joint, c_.joints);
        const auto crank = c_.joints.find(chain.crank_joint);
        if (chain.bearing_play == Chain::Play::limited && crank != c_.joints.end() && !crank->second.clearance) {
            report("missing-key", "chain.bearing_play", "the play at the start is not given",
                   fmt::format("add clearance = \"80 um\" (on the diameter) to joints.{}", chain.crank_joint));
        }
    }
};

}  // namespace

std::vector<Finding> check_references(const Case& c) { return Checker(c).run(); }

}  // namespace deadpoint::casefile
