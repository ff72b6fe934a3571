#include "deadpoint/press/loads/loads.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/stopwatch.hpp"
#include "deadpoint/crankshaft/cycle.hpp"
#include "deadpoint/crankshaft/modes.hpp"
#include "deadpoint/crankshaft/response/harmonic_response.hpp"
#include "deadpoint/crankshaft/response/periodic.hpp"
#include "deadpoint/crankshaft/shaft/check.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/mechanism/force_tip.hpp"
#include "deadpoint/mechanism/mirror.hpp"
#include "deadpoint/mechanism/turn.hpp"
#include "deadpoint/press/loads/body_masses.hpp"
#include "deadpoint/press/loads/turn_cache.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/linkage.hpp"
#include "deadpoint/press/translate/loads.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::press {
namespace {

constexpr int modes_shown = 8;
constexpr int campbell_points = 13;
constexpr double balanced_share = 1e-6;  // share of the largest joint force below which a guide counts as unloaded
constexpr double noticed_share = 0.01;   // share of its mean normal force above which a neglected moment is reported

class StageTimer {
public:
    explicit StageTimer(std::vector<std::pair<std::string, double>>& times) : times_(times) {}
    void done(const std::string& stage)
    {
        const auto now = Clock::now();
        times_.emplace_back(stage, std::chrono::duration<double>(now - since_).count());
        since_ = now;
    }

private:
    std::vector<std::pair<std::string, double>>& times_;
    Clock::time_point since_ = Clock::now();
};

bool is_mirrored(const casefile::Case& input, const std::string& body) { return input.bodies.at(body).mirror; }

double direction_of_throw(const Linkage& linkage, const std::vector<PlanarPose>& poses)
{
    const Vec2 axis = linkage.joints[static_cast<std::size_t>(linkage.driver)].centre;
    const Vec2 arm = linkage.joints[static_cast<std::size_t>(crank_pin_joint(linkage))].centre - axis;
    return std::atan2(arm[1], arm[0]) + poses[static_cast<std::size_t>(driven_body(linkage))].angle;
}

double largest_force(const CycleHistory& history)
{
    double largest = 0;
    for (const auto& joint : history.joints)
        for (const auto& force : joint.force)
            largest = std::max(largest, norm(force));
    return largest;
}

double mean_normal_force(const CycleHistory& history, const JointCycle& cycle, const tribology::GuideFaces& faces)
{
    return tribology::duty_mean(tribology::guide_duty(history, cycle, faces), 1, 0);
}

std::vector<GuideLoad> guide_loads(const casefile::Case& input, const LoadsResult& result)
{
    std::vector<GuideLoad> guides;
    const double limit = balanced_share * largest_force(result.history);
    for (std::size_t j = 0; j < result.linkage.joints.size(); ++j) {
        const auto& joint = result.linkage.joints[j];
        if (joint.kind != LinkageJoint::Kind::slide)
            continue;
        const auto& cycle = result.history.joints[j];
        const std::string original = result.images[j] ? joint.name.substr(0, joint.name.size() - 1) : joint.name;
        GuideLoad guide;
        guide.joint = static_cast<int>(j);
        guide.faces = describe_guide(input.joints.at(original));
        guide.mean_normal = mean_normal_force(result.history, cycle, guide.faces);
        for (const double moment : cycle.moment)
            guide.peak_moment = std::max(guide.peak_moment, std::abs(moment));
        guide.balanced = tribology::peak_force(tribology::duty_of(result.history, cycle)) <= limit &&
                         guide.peak_moment <= limit * result.stroke.stroke;
        guides.push_back(guide);
    }
    return guides;
}

// Largest distance of two joints: no guide is longer.
double extent(const Linkage& linkage)
{
    double largest = 0;
    for (const auto& a : linkage.joints)
        for (const auto& b : linkage.joints)
            largest = std::max(largest, norm(a.centre - b.centre));
    return largest;
}

// Where the length that a moment needs is missing, what it would do even on a guide as long as the linkage.
std::optional<std::string> missing_moment(const LoadsResult& result, const GuideLoad& guide)
{
    if (guide.faces.length || guide.peak_moment == 0)
        return std::nullopt;
    const auto j = static_cast<std::size_t>(guide.joint);
    const double longest = extent(result.linkage);
    const double with_moment =
        mean_normal_force(result.history, result.history.joints[j], {guide.faces.preload, longest});
    if (with_moment - guide.mean_normal <= noticed_share * with_moment)
        return std::nullopt;
    return fmt::format("guide '{}' carries a moment of up to {:.3g} N m, which is left out: even on a guide of {:.3g} "
                       "mm, as long as the linkage, its faces would be pressed by {:.4g} N in the mean instead of "
                       "{:.4g} N; state joints.{}.guide_length",
                       result.linkage.joints[j].name, guide.peak_moment, 1e3 * longest, with_moment, guide.mean_normal,
                       result.linkage.joints[j].name);
}

void warn_of_guides(LoadsResult& result)
{
    for (const auto& guide : result.guides) {
        const auto& name = result.linkage.joints[static_cast<std::size_t>(guide.joint)].name;
        if (guide.balanced && guide.faces.preload == 0)
            result.warnings.push_back(
                {"force on guide " + name,
                 fmt::format("guide '{}' carries no force: the linkage is balanced about it, and friction that follows "
                             "the load "
                             "would be zero there; state a preload of its gib, or an offset of the process force",
                             name)});
        if (result.images[static_cast<std::size_t>(guide.joint)])
            continue;
        if (const auto missing = missing_moment(result, guide))
            result.warnings.push_back({"moment on guide " + name, *missing});
    }
}

// Sums of the bearings that name the same seat; a bearing without one is its own.
std::vector<BearingCycle> sum_seats(const casefile::Crankshaft& given, const std::vector<BearingCycle>& bearings,
                                    const std::vector<std::string>& seats)
{
    std::vector<BearingCycle> result;
    for (const auto& seat : seats) {
        std::vector<Vec2> force(bearings.front().force.size(), Vec2{});
        for (std::size_t b = 0; b < bearings.size(); ++b) {
            const auto& named = given.bearings[b].seat.empty() ? bearings[b].name : given.bearings[b].seat;
            if (named == seat)
                for (std::size_t i = 0; i < force.size(); ++i)
                    force[i] = force[i] + bearings[b].force[i];
        }
        result.push_back(crankshaft::summarise(seat, std::move(force)));
    }
    return result;
}

std::vector<std::string> seat_names(const casefile::Crankshaft& given, const crankshaft::Shaft& shaft)
{
    std::vector<std::string> names;
    for (std::size_t b = 0; b < given.bearings.size(); ++b) {
        const auto& seat = given.bearings[b].seat.empty() ? shaft.bearings[b].name : given.bearings[b].seat;
        if (std::ranges::find(names, seat) == names.end())
            names.push_back(seat);
    }
    return names;
}

// Up to a quarter beyond the first critical speed, or the first forward one if that is not far beyond.
double campbell_range(const std::vector<crankshaft::CriticalSpeed>& critical, double speed)
{
    double range = 3 * speed;
    if (critical.empty())
        return range;
    const double first = critical.front().speed;
    range = std::max(range, 1.25 * first);
    for (const auto& c : critical)
        if (c.whirl == crankshaft::Whirl::forward && c.speed < 3 * first)
            return std::max(range, 1.25 * c.speed);
    return range;
}

// Modes over speed and at the operating speed.
void vibrate(CrankshaftLoads& result, double speed, int critical_speeds)
{
    const auto shaft = crankshaft::with_stiffness(result.shaft, result.cycle());
    const auto system = crankshaft::assemble(shaft);
    result.modes = crankshaft::modes(system, speed, modes_shown);
    result.critical_speeds = crankshaft::critical_speeds(system, 1, critical_speeds);
    const double range = campbell_range(result.critical_speeds, speed);
    for (int i = 0; i < campbell_points; ++i)
        result.campbell_speeds.push_back(range * i / (campbell_points - 1));
    result.campbell = crankshaft::campbell(system, result.campbell_speeds, modes_shown);
    const std::vector<double> at{speed};
    result.unbalance = crankshaft::unbalance_response(shaft, at).front();
}

CrankshaftLoads solve_crankshaft(const casefile::Case& input, LoadsResult& loads, const BodyMass& crank,
                                 Vibration vibration, StageTimer& timer)
{
    CrankshaftLoads result;
    const auto& given = *input.crankshaft;
    result.model = casefile::name_of(given.model);
    result.shaft = describe_shaft(input, loads.linkage, crank);
    result.loads = describe_shaft_loads(input, loads.linkage, loads.history, loads.speed);
    result.belt_force = belt_force(input, loads.speed);
    const auto found = crankshaft::shaft_warnings(result.shaft);
    loads.warnings.insert(loads.warnings.end(), found.begin(), found.end());
    result.shaft.sections = slender_pieces(result.shaft.sections);
    result.rigid = crankshaft::rigid_cycle(result.shaft, result.loads);
    timer.done("rigid crankshaft");
    if (given.model == casefile::Crankshaft::Model::flexible) {
        if (process_force_kind(input) == casefile::ProcessForce::Kind::rectangular && loads.force > 0)
            loads.warnings.push_back({"edges of the process force",
                                      "the steps of a rectangular process force double the peak on a flexible "
                                      "crankshaft; choose kind = \"elastic\" or \"half_sine\""});
        result.flexible = crankshaft::flexible_cycle(result.shaft, result.loads);
        timer.done("flexible crankshaft");
    }
    const auto& warnings = result.cycle().warnings;
    loads.warnings.insert(loads.warnings.end(), warnings.begin(), warnings.end());
    result.seats = seat_names(given, result.shaft);
    result.by_seat.rigid = sum_seats(given, result.rigid.bearings, result.seats);
    if (result.flexible)
        result.by_seat.flexible = sum_seats(given, result.flexible->bearings, result.seats);
    result.sag = crankshaft::static_state(result.shaft, result.loads);
    if (vibration == Vibration::computed) {
        vibrate(result, result.rigid.speed, given.critical_speeds);
        timer.done("vibration of the crankshaft");
    }
    return result;
}

CycleHistory cycle_of(const LoadsResult& loads, TurnCache* turns)
{
    if (turns == nullptr)
        return mechanism::analyse_cycle(loads.linkage, loads.request);
    return mechanism::analyse_cycle(loads.linkage, loads.request, *turns->get(loads.linkage, loads.request.positions));
}

}  // namespace

bool has_loads(const casefile::Case& input)
{
    const bool slide = !input.mechanism.slide_body.empty() || input.chain;
    return slide && std::ranges::any_of(input.joints, [](const auto& joint) { return joint.second.driver; });
}

int first_running_segment(const casefile::Case& input)
{
    for (std::size_t i = 0; i < input.operation.size(); ++i)
        if (input.operation[i].speed > 0)
            return static_cast<int>(i);
    return -1;
}

bool loads_need_machine(const casefile::Case& input) { return masses_need_parts(input, describe_linkage(input)); }

LoadsResult compute_loads(const casefile::Case& input, const Machine* machine, int segment, Vibration vibration,
                          TurnCache* turns)
{
    if (segment < 0 || segment >= static_cast<int>(input.operation.size()))
        throw mistake("operation",
                      fmt::format("there is no segment {} in [[operation]]; it has {}, counted from 0", segment,
                                  input.operation.size()),
                      fmt::format("give --segment 0{}",
                                  input.operation.size() > 1 ? fmt::format(" to {}", input.operation.size() - 1) : ""));
    const auto& operation = input.operation[static_cast<std::size_t>(segment)];
    if (!(operation.speed > 0))
        throw mistake(
            fmt::format("operation.{}", segment),
            fmt::format("the press stands still in segment {} of [[operation]]; choose one in which it runs", segment));
    LoadsResult result;
    StageTimer timer(result.timings);
    result.segment = segment;
    result.speed = operation.speed;
    result.force = operation.force;
    result.process_force = casefile::name_of(process_force_kind(input));

    const Linkage own = describe_linkage(input);
    auto masses = describe_masses(input, own, machine);
    result.warnings = masses.warnings;
    std::vector<bool> twice;
    for (const auto& body : own.bodies)
        twice.push_back(is_mirrored(input, body));
    const auto whole = about("bodies", [&] { return mechanism::mirrored(own, twice); });
    result.linkage = whole.linkage;
    result.masses = mechanism::mirrored(masses.values, whole);
    for (const auto& origin : whole.bodies)
        result.mass_origins.push_back(masses.origins[static_cast<std::size_t>(origin.original)]);
    for (const auto& origin : whole.joints)
        result.images.push_back(origin.image);
    for (const int joint : whole.freed)
        result.freed_guides.push_back(whole.linkage.joints[static_cast<std::size_t>(joint)].name);
    timer.done("linkage and masses");

    const auto bottom = about("joints", [&] { return turns ? turns->bottom(own) : mechanism::bottom_dead_point(own); });
    result.lengths = mechanism::length_sensitivities(own, bottom);
    result.throw_at_bottom = direction_of_throw(own, bottom.poses);
    timer.done("bottom dead point");

    result.request = about("process_force", [&] { return describe_cycle(input, operation, result.throw_at_bottom); });
    result.request.masses = result.masses;
    result.history = about("mechanism", [&] { return cycle_of(result, turns); });
    const auto corners = describe_corners(input, result.throw_at_bottom);
    if (const int met = mechanism::positions_for_tip(result.history, result.request, corners);
        met > result.request.positions) {
        result.request.positions = met;
        result.history = cycle_of(result, turns);
    }
    timer.done("motion and joint forces");
    result.stroke = mechanism::stroke_figures(result.linkage, result.request, result.history);
    result.drive = mechanism::drive_figures(result.history);
    if (const auto misplaced = misplaced_force(input, result.throw_at_bottom); misplaced && result.force > 0)
        result.warnings.push_back({"place of the process force", *misplaced});
    result.force_ratios = about("joints", [&] { return mechanism::force_ratios(result.linkage, result.history); });
    result.guides = guide_loads(input, result);
    warn_of_guides(result);
    timer.done("figures");

    if (input.crankshaft)
        result.crankshaft = about("crankshaft", [&] {
            const auto& crank = result.masses[static_cast<std::size_t>(driven_body(own))];
            return solve_crankshaft(input, result, crank, vibration, timer);
        });
    return result;
}

}  // namespace deadpoint::press
