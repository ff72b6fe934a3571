#include "deadpoint/drift/corners.hpp"

#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/contact_side.hpp"
#include "deadpoint/drift/tilt.hpp"
#include "deadpoint/exchange/linkage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace deadpoint::drift {
namespace {

struct FacePlace {
    std::uint32_t face = 0;
    Vec3 position{};
};

std::vector<FacePlace> nodes_of(const Machine& machine, int surface)
{
    std::vector<FacePlace> places;
    for (const auto& entry : machine.surfaces[surface].faces) {
        if (!entry.central)
            continue;
        const auto& face = machine.faces[entry.face];
        for (int i = 0; i < face.node_count; ++i)
            places.push_back({entry.face, machine.nodes[face.nodes[i]]});
    }
    return places;
}

// The two directions across the stroke: to its right, and along the crankshaft.
struct Across {
    Vec3 right{};
    [[nodiscard]] Vec2 of(const Vec3& x) const { return {dot(right, x), x[2]}; }
};

// The place that lies farthest towards a corner of the rectangle around all places.
FacePlace farthest(const std::vector<FacePlace>& places, const Across& across, const Vec2& to)
{
    Vec2 size{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto along = [&](const FacePlace& p) { return across.of(p.position)[axis]; };
        const auto [low, high] = std::ranges::minmax_element(places, {}, along);
        size[axis] = along(*high) - along(*low);
    }
    return *std::ranges::max_element(places, {}, [&](const FacePlace& p) {
        const Vec2 at = across.of(p.position);
        return to[0] * at[0] / size[0] + to[1] * at[1] / size[1];
    });
}

// Where the line along the stroke through a point meets a triangle.
std::optional<Vec3> below(const Across& across, const Vec3& at, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const auto cross2 = [&](const Vec3& p, const Vec3& q) {
        const Vec2 u = across.of(p), v = across.of(q);
        return u[0] * v[1] - u[1] * v[0];
    };
    const double whole = cross2(b - a, c - a);
    const double s = cross2(at - a, c - a) / whole, t = cross2(b - a, at - a) / whole;
    constexpr double slack = 1e-7;
    if (!(s >= -slack && t >= -slack && s + t <= 1 + slack))
        return std::nullopt;
    return a + s * (b - a) + t * (c - a);
}

FacePlace opposite(const Machine& machine, int surface, const Across& across, const Vec3& at)
{
    for (const auto& entry : machine.surfaces[surface].faces) {
        const auto& face = machine.faces[entry.face];
        const auto node = [&](int i) { return machine.nodes[face.nodes[i]]; };
        for (int i = 2; i < face.node_count; ++i)
            if (const auto met = below(across, at, node(0), node(i - 1), node(i)))
                return {entry.face, *met};
    }
    const auto places = nodes_of(machine, surface);
    return *std::ranges::min_element(places, {}, [&](const FacePlace& p) { return norm(across.of(p.position - at)); });
}

double mean_z(const Machine& machine, const std::vector<ContactSide>& sides)
{
    double mean = 0;
    for (const auto& side : sides) {
        double moment = 0, area = 0;
        for (const auto& p : points_of(machine, side)) {
            moment += p.weight * p.position[2];
            area += p.weight;
        }
        mean += moment / area / static_cast<double>(sides.size());
    }
    return mean;
}

// Rotation of the slide about z [rad] and the place to the right of the stroke about which it turns [m].
struct Turn {
    Functional angle;
    double about = 0;
};

// +1 where the slide is the joint's second body, -1 where the first, 0 elsewhere.
int side_of(const LinkageJoint& joint, int body) { return joint.body_b == body ? 1 : joint.body_a == body ? -1 : 0; }

std::optional<Turn> turn_by_guide(const Machine& machine, const Linkage& linkage,
                                  const BottomDeadPointSensitivity& sensitivity, const ChainDescription& chain)
{
    const int slide = linkage.slide_body;
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        const auto& joint = linkage.joints[j];
        const int side = side_of(joint, slide);
        const int other = side > 0 ? joint.body_a : joint.body_b;
        if (joint.kind != LinkageJoint::Kind::slide || !joint.guides_rotation || side == 0 || other != linkage.ground)
            continue;
        const auto in_a = fit_tilt(machine, chain.joints[j].in_a, {0, 0, 1}, false);
        const auto in_b = fit_tilt(machine, chain.joints[j].in_b, {0, 0, 1}, false);
        if (!in_a || !in_b)
            continue;
        Turn turn;
        add(turn.angle, side, in_a->angle);
        add(turn.angle, -side, in_b->angle);
        for (std::size_t k = 0; k < linkage.joints.size(); ++k) {
            const auto& w = sensitivity.weight[k];
            const auto& c = sensitivity.joint_centres[k];
            turn.about -= side_of(linkage.joints[k], slide) * (w[1] * c[0] - w[0] * c[1]);
        }
        return turn;
    }
    return std::nullopt;
}

Turn turn_by_closing(const Machine& machine, const Linkage& linkage, const BottomDeadPointSensitivity& sensitivity,
                     const ChainDescription& chain, const SlideTurn& turn)
{
    Turn result{{}, turn.about};
    for (int j = 0; j < static_cast<int>(linkage.joints.size()); ++j) {
        const auto centres = joint_centres(machine, linkage, sensitivity, j, chain.joints[j]);
        for (int c = 0; c < 2; ++c) {
            add(result.angle, turn.weight[j][c], centres.in_b[c]);
            add(result.angle, -turn.weight[j][c], centres.in_a[c]);
        }
    }
    return result;
}

// How much each body's tilt lifts the slide by the joints it carries off their common plane, per rad.
std::vector<double> lift_by_tilt(const Machine& machine, const Linkage& linkage,
                                 const BottomDeadPointSensitivity& sensitivity, const ChainDescription& chain)
{
    std::vector<double> lift(linkage.bodies.size(), 0.0);
    for (std::size_t j = 0; j < linkage.joints.size(); ++j) {
        const auto& joint = linkage.joints[j];
        const auto& weight = sensitivity.weight[j];
        const double w = dot(stroke_of(linkage), Vec3{weight[0], weight[1], 0});
        if (!chain.joints[j].in_a.empty())
            lift[joint.body_a] += w * mean_z(machine, chain.joints[j].in_a);
        if (!chain.joints[j].in_b.empty())
            lift[joint.body_b] -= w * mean_z(machine, chain.joints[j].in_b);
    }
    return lift;
}

}  // namespace

std::vector<Corner> corner_gaps(const Machine& machine, const Linkage& linkage,
                                const BottomDeadPointSensitivity& sensitivity, const ChainDescription& chain,
                                const std::vector<Functional>& dimensions, const SlideTurn& turn, const Vec3& front)
{
    Functional travel;
    add(travel, 1, dimensions[slide_height]);
    const Vec3 stroke = stroke_of(linkage);
    add(travel, -1, mean_along(machine, chain.slide_surface, stroke));
    Turn turning;
    if (!machine.half_model) {
        const auto guided = turn_by_guide(machine, linkage, sensitivity, chain);
        turning = guided ? *guided : turn_by_closing(machine, linkage, sensitivity, chain, turn);
    }
    const TiltClosure closure(machine, linkage, sensitivity, chain);
    const auto lift = lift_by_tilt(machine, linkage, sensitivity, chain);

    const Across across{right_of(linkage)};
    const auto places = nodes_of(machine, chain.slide_surface);
    std::vector<Corner> corners;
    const Vec2 to_front = across.of(front), to_left = across.of(cross(front, stroke));
    for (const auto& [depth, to_depth] : {std::pair{"front", to_front}, std::pair{"back", -1.0 * to_front}})
        for (const auto& [side, to_side] : {std::pair{"left", to_left}, std::pair{"right", -1.0 * to_left}}) {
            const Vec2 towards = to_depth + to_side;
            if (machine.half_model && towards[0] > 0)
                continue;
            const auto place = farthest(places, across, towards);
            const auto table = opposite(machine, chain.table_surface, across, place.position);
            const Vec2 at = across.of(place.position);
            Corner corner{std::string(depth) + " " + side, at[0], at[1], {}};
            corner.gap.name = "gap " + corner.name;
            corner.gap.points = {{place.face, place.position, stroke}, {table.face, table.position, -1.0 * stroke}};
            add(corner.gap, 1, travel);
            add(corner.gap, corner.x - turning.about, turning.angle);
            if (closure.holds(linkage.slide_body)) {
                auto factors = lift;
                factors[linkage.slide_body] -= corner.z;
                add(corner.gap, 1, closure.combine(factors));
            }
            corners.push_back(std::move(corner));
        }
    return corners;
}

}  // namespace deadpoint::drift
