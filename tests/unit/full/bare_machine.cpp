/// Requirement: loads, laws and heat problem of a case follow from the figures of its machine alone. Every shipped case
/// with parts has the same on its mesh and on a machine without mesh that went through a file.
#include "deadpoint/exchange/bare_machine.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/machine/model_part.hpp"
#include "deadpoint/press/problem/heat.hpp"
#include "deadpoint/press/result/loads_result.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <optional>
#include <sstream>

using namespace deadpoint;

namespace {

namespace fs = std::filesystem;

constexpr double zero_celsius = 273.15;

/// Shipped cases with parts; those that can share a mesh stand together.
std::vector<casefile::Case> shipped_cases()
{
    std::vector<casefile::Case> cases;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(DEADPOINT_SOURCE_DIR) / "cases")) {
        const auto text = entry.path().extension() == ".toml" ? content(entry.path()) : "";
        if (text.find("\nformat = 1") == text.npos || text.find("\n[machine]") == text.npos)
            continue;  // a study, or a file that a case includes
        auto input = casefile::read_case(entry.path()).value;
        if (!input.parts.empty())
            cases.push_back(std::move(input));
    }
    std::ranges::sort(cases, {}, [](const casefile::Case& input) { return press::model_key(input); });
    return cases;
}

std::string bytes_of(const Machine& machine)
{
    std::ostringstream out;
    BinaryWriter writer(out, "machine\n");
    writer(machine);
    writer.finish();
    return out.str();
}

Machine read_back(const Machine& machine)
{
    const ScratchFolder folder;
    BinaryReader reader(folder.file("machine", bytes_of(machine)), "machine\n", "write it again");
    Machine result;
    reader(result);
    return result;
}

/// Names of what differs.
class Differences {
public:
    template <class Value>
    void compare(const std::string& name, const Value& one, const Value& other)
    {
        if (!(one == other))
            names_.push_back(name);
    }
    template <class Value, class Compare>
    void each(const std::string& name, const std::vector<Value>& one, const std::vector<Value>& other,
              const Compare& compare_one)
    {
        compare(name + " count", one.size(), other.size());
        for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i)
            compare_one(fmt::format("{} {}", name, i), one[i], other[i]);
    }
    /// Functions of these arguments: both empty, or of equal results.
    template <class Function, class Argument, class Result>
    void functions(const std::string& name, const Function& one, const Function& other,
                   const std::vector<Argument>& arguments, const Result& result)
    {
        compare(name + " is there", static_cast<bool>(one), static_cast<bool>(other));
        for (const auto& argument : arguments)
            if (one && other)
                compare(name, result(one, argument), result(other, argument));
    }
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

private:
    std::vector<std::string> names_;
};

std::vector<double> numbers_of(const LawValue& at) { return {at.value, at.slope, at.in_range ? 1.0 : 0.0}; }

void compare_courses(Differences& found, const std::string& name, const TimeCourse& one, const TimeCourse& other)
{
    found.functions(name, one, other, std::vector<double>{0, 1800, 7200.5, 30000, 86400},
                    [](const TimeCourse& course, double time) { return course(time); });
}

/// @param positions  on the interface, for its load zone
void compare_laws(Differences& found, const std::string& name, const InterfaceLaw& one, const InterfaceLaw& other,
                  const std::vector<Vec3>& positions)
{
    found.compare(name + " conductances", std::tuple(one.film_a, one.film_b, one.oil, one.oil_temperature),
                  std::tuple(other.film_a, other.film_b, other.oil, other.oil_temperature));
    found.compare(name + " heat", std::tuple(one.turns_fully, one.source, one.heat_weight, one.heat_part),
                  std::tuple(other.turns_fully, other.source, other.heat_weight, other.heat_part));
    found.functions(name + " load zone", one.load_zone, other.load_zone, positions,
                    [](const auto& zone, const Vec3& position) { return zone(position); });
}

void compare_interfaces(Differences& found, const std::string& name, const std::vector<InterfaceLaw>& one,
                        const std::vector<InterfaceLaw>& other, const Machine& machine)
{
    found.compare(name + " count", one.size(), other.size());
    for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
        std::vector<Vec3> positions;
        for (const auto& point : machine.interfaces.at(i).points)
            positions.push_back(point.position_a);
        compare_laws(found, name + " " + machine.interfaces[i].name, one[i], other[i], positions);
    }
}

void compare_films(Differences& found, const std::string& name, const FilmLawAt& one, const FilmLawAt& other)
{
    found.compare(name + " formula", one.formula, other.formula);
    for (const double ambient : {zero_celsius + 5, zero_celsius + 20})
        for (const double rise : {-10.0, 0.0, 1.0, 15.0, 60.0})
            found.compare(name, numbers_of(one(ambient)(ambient + rise)), numbers_of(other(ambient)(ambient + rise)));
}

void compare_surfaces(Differences& found, const SurfaceCondition& one, const SurfaceCondition& other)
{
    const auto& name = one.name;
    found.compare(
        name, std::tuple(one.name, one.surface, one.kind, one.coefficient, one.emissivity, one.enclosure),
        std::tuple(other.name, other.surface, other.kind, other.coefficient, other.emissivity, other.enclosure));
    found.each(
        name + " law", one.laws, other.laws,
        [&](const std::string& law, const FilmLawAt& a, const FilmLawAt& b) { compare_films(found, law, a, b); });
    compare_courses(found, name + " ambient", one.ambient, other.ambient);
    compare_courses(found, name + " flux", one.flux, other.flux);
    found.functions(name + " temperature", one.temperature, other.temperature, std::vector<double>{0, 3600},
                    [](const auto& course, double time) {
                        return course(Vec3{-0.1, 0.2, 0.3}, time);
                    });
}

void compare_segments(Differences& found, const std::string& name, const HeatSegment& one, const HeatSegment& other,
                      const Machine& machine)
{
    const auto courses = [&](const std::string& what, const TimeCourse& a, const TimeCourse& b) {
        compare_courses(found, what, a, b);
    };
    found.compare(name + " duration", one.duration, other.duration);
    found.compare(name + " friction", one.heat, other.heat);
    found.compare(name + " load part", one.zoned_heat, other.zoned_heat);
    found.each(name + " rings", one.ring_heat, other.ring_heat,
               [&](const std::string& what, const auto& a, const auto& b) {
                   found.functions(what, a, b, std::vector<double>{-5, 0, 2.5, 20},
                                   [](const RingHeatLaw& law, double difference) { return law(difference); });
               });
    found.each(name + " body heat", one.body_heat, other.body_heat, courses);
    found.each(name + " enclosure power", one.enclosure_power, other.enclosure_power, courses);
    found.compare(name + " oil flow", one.oil_flow, other.oil_flow);
    compare_interfaces(found, name + " interface", one.interfaces, other.interfaces, machine);
    compare_courses(found, name + " ambient", one.ambient, other.ambient);
}

std::vector<std::tuple<int, bool>> sides_of(const std::vector<InterfaceSide>& rings)
{
    std::vector<std::tuple<int, bool>> sides;
    for (const auto& ring : rings)
        sides.emplace_back(ring.interface, ring.b);
    return sides;
}

void compare_sources(Differences& found, const HeatProblem& one, const HeatProblem& other)
{
    found.each("source", one.sources, other.sources, [&](const auto& name, const auto& a, const auto& b) {
        found.compare(name, std::tuple(a.name, a.share, sides_of(a.inner_rings), sides_of(a.outer_rings)),
                      std::tuple(b.name, b.share, sides_of(b.inner_rings), sides_of(b.outer_rings)));
    });
    found.each("body heat", one.body_heat, other.body_heat, [&](const auto& name, const auto& a, const auto& b) {
        found.compare(name, std::tuple(a.name, a.parts, a.surface), std::tuple(b.name, b.parts, b.surface));
    });
}

void compare_media(Differences& found, const HeatProblem& one, const HeatProblem& other)
{
    const auto of_oil = [](const OilCourse& oil) {
        return std::tuple(oil.name, oil.joints, oil.cooled, oil.inlet_temperature, oil.sump_capacity, oil.sump_loss,
                          oil.sump_start);
    };
    const auto of_air = [](const Enclosure& air) {
        return std::tuple(air.name, air.capacity, air.exchange, air.start);
    };
    const auto of_room = [](const RadiantRoom& room) { return std::tuple(room.surfaces, room.exchange); };
    const auto each = [&](const std::string& name, const auto& a, const auto& b, const auto& numbers) {
        found.each(name, a, b, [&](const std::string& which, const auto& x, const auto& y) {
            found.compare(which, numbers(x), numbers(y));
        });
    };
    each("oil", one.oil, other.oil, of_oil);
    each("enclosure", one.enclosures, other.enclosures, of_air);
    each("radiation", one.radiation, other.radiation, of_room);
    each("probe", one.probes, other.probes,
         [](const HeatProbe& probe) { return std::tuple(probe.name, probe.part, probe.position); });
}

void compare_problems(Differences& found, const HeatProblem& one, const HeatProblem& other, const Machine& machine)
{
    compare_interfaces(found, "interface", one.interfaces, other.interfaces, machine);
    compare_sources(found, one, other);
    compare_media(found, one, other);
    found.each("surface", one.surfaces, other.surfaces,
               [&](const auto&, const auto& a, const auto& b) { compare_surfaces(found, a, b); });
    found.each("segment", one.segments, other.segments,
               [&](const auto& name, const auto& a, const auto& b) { compare_segments(found, name, a, b, machine); });
    for (int part = 0; part < static_cast<int>(machine.parts.size()); ++part)
        found.compare("initial temperature", one.initial_temperature(part, {}), other.initial_temperature(part, {}));
    found.compare("field times", one.field_times, other.field_times);
}

void compare_bearings(Differences& found, const std::string& name, const std::vector<BearingCycle>& one,
                      const std::vector<BearingCycle>& other)
{
    found.each(name, one, other, [&](const std::string& which, const BearingCycle& a, const BearingCycle& b) {
        found.compare(which, std::tuple(a.name, a.force, a.peak, a.mean, a.rms, a.mean_rolling_load),
                      std::tuple(b.name, b.force, b.peak, b.mean, b.rms, b.mean_rolling_load));
    });
}

/// Wall times may differ.
void compare_loads(Differences& found, const press::LoadsResult& one, const press::LoadsResult& other)
{
    found.each("mass", one.masses, other.masses, [&](const auto& name, const BodyMass& a, const BodyMass& b) {
        found.compare(name, std::tuple(a.mass, a.centre, a.inertia), std::tuple(b.mass, b.centre, b.inertia));
    });
    found.compare("origins of masses", one.mass_origins, other.mass_origins);
    found.each("joint", one.history.joints, other.history.joints, [&](const auto& name, const auto& a, const auto& b) {
        found.compare(name, std::tuple(a.centre, a.force, a.moment, a.sliding),
                      std::tuple(b.centre, b.force, b.moment, b.sliding));
    });
    found.compare("drive torque", one.history.drive_torque, other.history.drive_torque);
    found.each("guide", one.guides, other.guides, [&](const auto& name, const auto& a, const auto& b) {
        found.compare(name, std::tuple(a.mean_normal, a.peak_moment), std::tuple(b.mean_normal, b.peak_moment));
    });
    found.compare("warnings", one.warnings.size(), other.warnings.size());
    found.compare("crankshaft", one.crankshaft.has_value(), other.crankshaft.has_value());
    if (!one.crankshaft || !other.crankshaft)
        return;
    compare_bearings(found, "bearing", one.crankshaft->cycle().bearings, other.crankshaft->cycle().bearings);
    compare_bearings(found, "seat", one.crankshaft->seat_cycles(), other.crankshaft->seat_cycles());
}

std::optional<press::LoadsResult> loads_of(const casefile::Case& input, const Machine& machine)
{
    const int segment = press::first_running_segment(input);
    if (segment < 0 || !press::has_loads(input))
        return std::nullopt;
    return press::compute_loads(input, &machine, segment);
}

}  // namespace

TEST_CASE("a machine without mesh has no mesh, and what it has goes through a file")
{
    const auto input = casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter-by-laws/case.toml").value;
    Observer quiet;
    const auto machine = full::prepare_machine(input, 3, quiet);
    const auto bare = without_mesh(machine);
    CHECK(bare.nodes.empty());
    CHECK(bare.cells.empty());
    CHECK(bare.faces.empty());
    CHECK(bare.geometries.empty());
    CHECK(bare.exposed_fraction.empty());
    REQUIRE(bare.interfaces.size() == machine.interfaces.size());
    for (std::size_t i = 0; i < bare.interfaces.size(); ++i) {
        CHECK(bare.interfaces[i].points.empty());
        CHECK(bare.interfaces[i].points_as_drawn().empty());
        CHECK(bare.interfaces[i].coverage() == machine.interfaces[i].coverage());
        CHECK(bare.interfaces[i].geometry.index() == machine.interfaces[i].geometry.index());
    }
    REQUIRE(bare.bonds.size() == machine.bonds.size());
    REQUIRE(!bare.surfaces.empty());
    for (const auto& surface : bare.surfaces)
        CHECK(surface.faces.empty());
    CHECK(bytes_of(bare) == bytes_of(machine));
    CHECK(bytes_of(read_back(machine)) == bytes_of(machine));
}

TEST_CASE("every shipped case has the same loads and the same heat problem without its mesh")
{
    const auto cases = shipped_cases();
    CHECK(cases.size() >= 12);
    Observer quiet;
    full::Press press(cases.front(), 3);
    for (const auto& input : cases) {
        CAPTURE(input.machine.name);
        press.take(input);
        const auto& machine = press.machine(quiet);
        const auto bare = read_back(machine);
        const auto loads = loads_of(input, machine), bare_loads = loads_of(input, bare);
        REQUIRE(loads.has_value() == bare_loads.has_value());
        Differences found;
        if (loads)
            compare_loads(found, *loads, *bare_loads);
        const auto problem = press::describe_heat(input, machine, quiet, loads ? &*loads : nullptr);
        const auto bare_problem = press::describe_heat(input, bare, quiet, loads ? &*bare_loads : nullptr);
        compare_problems(found, problem, bare_problem, machine);
        CHECK(found.names() == std::vector<std::string>{});
    }
}
