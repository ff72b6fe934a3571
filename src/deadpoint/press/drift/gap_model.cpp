#include "deadpoint/press/drift/gap_model.hpp"

#include "deadpoint/casefile/check/directions.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/clearances.hpp"
#include "deadpoint/drift/corners.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/mechanism/planar_motion.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/series_sum.hpp"
#include "deadpoint/press/translate/bearing_groups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <set>

namespace deadpoint::press {
namespace {

drift::SlideTurn slide_turn(const ChainModel& chain)
{
    drift::SlideTurn turn;
    const Vec2& stroke = chain.linkage.stroke_direction;
    turn.about = dot(chain.system.slide_point(), Vec2{stroke[1], -stroke[0]});
    const auto poses = chain.system.assembled();
    std::vector<mechanism::CentreShift> shifts(chain.linkage.joints.size());
    for (auto& shift : shifts) {
        Vec2 weight{};
        for (int c = 0; c < 2; ++c) {
            shift.in_b[c] = 1;
            weight[c] = chain.system.closing_motion(poses, shifts)[chain.linkage.slide_body].angle;
            shift.in_b[c] = 0;
        }
        turn.weight.push_back(weight);
    }
    return turn;
}

std::string bearing_name(const casefile::Case& input, const Machine& machine, const std::string& joint,
                         const std::vector<int>& bearing, bool alone)
{
    if (alone)
        return joint;
    const auto& contact = machine.interfaces[bearing.front()];
    for (const auto part : {contact.part_a, contact.part_b})
        if (input.bodies.at(machine.parts[part].body).thermal_only)
            return joint + " " + machine.parts[part].name;
    return joint + contact.name.substr(contact.name.rfind('.')).replace(0, 1, " ");
}

std::string direction_name(const Vec3& across)
{
    constexpr std::array<const char*, 3> axes{"x", "y", "z"};
    for (std::size_t c = 0; c < 3; ++c)
        if (std::abs(across[c]) > 0.999)
            return fmt::format("along {}", axes[c]);
    return fmt::format("along ({:.2f}, {:.2f}, {:.2f})", across[0], across[1], across[2]);
}

/// "front left" becomes "front right" or, where the plane of symmetry lies between front and back, "back left".
std::string mirrored_name(const std::string& name, bool sideways)
{
    const auto space = name.find(' ');
    const auto depth = name.substr(0, space), side = name.substr(space + 1);
    if (sideways)
        return depth + (side == "left" ? " right" : " left");
    return (depth == "front" ? "back " : "front ") + side;
}

/// The corners of a half with their images, in the order of Parallelism::corners.
std::vector<CornerSeries> with_images(const std::vector<CornerSeries>& half)
{
    const auto depth = [](const CornerSeries& corner) { return corner.name.substr(0, corner.name.find(' ')); };
    const bool sideways = depth(half[0]) != depth(half[1]);
    std::vector<CornerSeries> all = half;
    for (auto image : half) {
        image.name = mirrored_name(image.name, sideways);
        image.x = -image.x;
        all.push_back(std::move(image));
    }
    constexpr std::array order{"front left", "front right", "back left", "back right"};
    std::ranges::sort(all, {}, [&](const CornerSeries& corner) { return std::ranges::find(order, corner.name); });
    return all;
}

/// Distance of two pairs of corners, along the axis that leads from one pair to the other [m].
double distance(const CornerSeries& a0, const CornerSeries& a1, const CornerSeries& b0, const CornerSeries& b1)
{
    return 0.5 * std::max(std::abs(b0.x + b1.x - a0.x - a1.x), std::abs(b0.z + b1.z - a0.z - a1.z));
}

/// Left and right of a slide are those of its stroke, wherever that points.
Viewer viewer_at_slide(const casefile::Case& input)
{
    Viewer viewer = casefile::viewer_of(input);
    const Vec2 stroke = casefile::stroke_direction(input);
    viewer.left = cross(viewer.front, Vec3{stroke[0], stroke[1], 0});
    return viewer;
}

// When initial + change first reaches 0, linear between the steps.
std::optional<double> used_up(const std::vector<double>& time, const ClearanceSeries& clearance)
{
    const auto left = [&](std::size_t i) { return *clearance.initial + clearance.change.value[i]; };
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (left(i) > 0)
            continue;
        return i == 0 ? time[0] : time[i - 1] + (time[i] - time[i - 1]) * left(i - 1) / (left(i - 1) - left(i));
    }
    return std::nullopt;
}

void add_corners(GapModel& model, const casefile::Case& input, const Machine& machine, const ChainModel& chain)
{
    const auto front = casefile::viewer_of(input).front;
    for (auto& corner : drift::corner_gaps(machine, chain.linkage, chain.sensitivity, chain.description,
                                           chain.dimensions, slide_turn(chain), front)) {
        model.corners.push_back({corner.name, corner.x, corner.z, {}});
        model.functionals.push_back(std::move(corner.gap));
    }
}

// Clearances of one joint, whose contacts are given.
class JointClearances {
public:
    JointClearances(GapModel& model, const casefile::Case& input, const Machine& machine, const std::string& joint)
        : model_(model), input_(input), machine_(machine), joint_(joint)
    {}

    void of_guide(const std::vector<int>& contacts)
    {
        const auto found = drift::guide_clearances(machine_, contacts);
        for (const auto& clearance : found)
            keep(found.size() == 1 ? joint_ : joint_ + " " + direction_name(clearance.across),
                 ClearanceSeries::Kind::guide, clearance.growth);
        if (found.empty())
            model_.left_out.push_back(fmt::format("{}: no two of its faces point in opposite directions", joint_));
    }

    void of_bearings(const std::vector<int>& contacts, const Vec2& centre)
    {
        const auto bearings = bearings_of(input_, machine_, contacts);
        for (const auto& bearing : bearings)
            try {
                keep(bearing_name(input_, machine_, joint_, bearing, bearings.size() == 1),
                     ClearanceSeries::Kind::bearing, drift::bearing_clearance(machine_, bearing, centre));
            } catch (const InputError& error) {
                model_.left_out.push_back(fmt::format("{}: {}", joint_, error.what()));
            }
    }

private:
    void keep(const std::string& name, ClearanceSeries::Kind kind, Functional growth)
    {
        growth.name = "clearance " + name;
        model_.clearances.push_back({name, kind, joint_});
        model_.functionals.push_back(std::move(growth));
    }

    GapModel& model_;
    const casefile::Case& input_;
    const Machine& machine_;
    const std::string& joint_;
};

}  // namespace

Parallelism parallelism(std::vector<CornerSeries> corners, bool mirrored)
{
    if (mirrored)
        corners = with_images(corners);
    const auto& c = corners;
    const double width = distance(c[0], c[2], c[1], c[3]);
    const double depth = distance(c[0], c[1], c[2], c[3]);
    const auto slope = [&](double length, const std::array<double, 4>& signs) {
        return combined({{signs[0] / length, &c[0].gap},
                         {signs[1] / length, &c[1].gap},
                         {signs[2] / length, &c[2].gap},
                         {signs[3] / length, &c[3].gap}});
    };
    Parallelism result;
    result.left_right = slope(width, {-0.5, 0.5, -0.5, 0.5});
    result.front_back = slope(depth, {-0.5, -0.5, 0.5, 0.5});
    result.corners = std::move(corners);
    return result;
}

GapModel describe_gaps(const casefile::Case& input, const Machine& machine, const ChainModel& chain)
{
    GapModel model;
    model.mirrored = machine.half_model;
    if (input.chain->corners)
        add_corners(model, input, machine, chain);
    if (!input.chain->clearances)
        return model;
    int next = 0;
    std::size_t index = 0;
    for (const auto& [name, joint] : input.joints) {
        std::vector<int> contacts(joint.interfaces.size());
        std::iota(contacts.begin(), contacts.end(), next);
        next += static_cast<int>(contacts.size());
        const auto centre = chain.sensitivity.joint_centres[index++];
        JointClearances clearances(model, input, machine, name);
        if (joint.kind == casefile::Joint::Kind::slide)
            clearances.of_guide(contacts);
        else
            clearances.of_bearings(contacts, centre);
    }
    return model;
}

GapSeries gap_series(const casefile::Case& input, const GapModel& model, const ThermalHistory& history, int first,
                     const DriftSeries& drift)
{
    GapSeries result;
    auto next = static_cast<std::size_t>(first);
    if (!model.corners.empty()) {
        auto corners = model.corners;
        for (auto& corner : corners)
            corner.gap = combined({{1, &history.functionals[next++]}, {1, &drift.play}});
        result.parallelism = parallelism(std::move(corners), model.mirrored);
        result.parallelism->viewer = viewer_at_slide(input);
    }
    result.left_out = model.left_out;
    for (const auto& clearance : model.clearances) {
        ClearanceSeries series{clearance.name,
                               clearance.kind,
                               history.functionals[next++],
                               input.joints.at(clearance.joint).clearance,
                               {}};
        if (series.initial)
            series.used_up = used_up(history.time, series);
        result.clearances.push_back(std::move(series));
    }
    if (input.chain->press_stiffness) {
        result.press_stiffness = *input.chain->press_stiffness;
        result.force = combined({{-result.press_stiffness, &drift.gap}});
    }
    return result;
}

std::vector<std::string> gap_warnings(const GapSeries& gaps)
{
    std::vector<std::string> warnings;
    for (const auto& clearance : gaps.clearances)
        if (clearance.used_up)
            warnings.push_back(fmt::format(
                "the clearance of {:.0f} um of '{}' is used up {:.2f} h after the start: "
                "after that it would jam, and the results are no longer valid; give it more clearance, or cool it",
                1e6 * *clearance.initial, clearance.name, *clearance.used_up / 3600));
    return warnings;
}

}  // namespace deadpoint::press
