#include "deadpoint/drift/clearances.hpp"

#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/contact_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace deadpoint::drift {
namespace {

// A contact of a guide, or its mirror image.
struct GuideFace {
    int contact = 0;
    Vec3 normal{};  ///< outward normal of body a of the first contact
};

Vec3 mean_normal(const Contact& contact)
{
    Vec3 sum{};
    for (const auto& p : contact.points_as_drawn())
        sum = sum + p.weight * p.normal;
    return sum;
}

std::vector<GuideFace> guide_faces(const Machine& machine, const std::vector<int>& contacts)
{
    std::vector<GuideFace> faces;
    const auto body_of = [&](std::uint32_t part) { return machine.parts[part].body; };
    const auto mirrors_itself = [&](std::uint32_t part) {
        return std::ranges::any_of(machine.parts,
                                   [&](const auto& other) { return other.cut && other.body == body_of(part); });
    };
    for (const int index : contacts) {
        const auto& contact = machine.interfaces[index];
        const Vec3 sum = mean_normal(contact);
        if (norm(sum) < 0.9 * contact.drawn_area)
            continue;
        const bool turned = body_of(contact.part_a) != body_of(machine.interfaces[contacts.front()].part_a);
        const Vec3 normal = (turned ? -1.0 : 1.0) * normalised(sum);
        faces.push_back({index, normal});
        if (machine.half_model && mirrors_itself(contact.part_a) && mirrors_itself(contact.part_b))
            faces.push_back({index, {-normal[0], normal[1], normal[2]}});
    }
    return faces;
}

// Mean of (u_b - u_a) . n over these faces.
Functional mean_opening(const Machine& machine, const std::vector<GuideFace>& faces)
{
    Functional result;
    double area = 0;
    for (const auto& face : faces)
        for (const auto& p : machine.interfaces[face.contact].points_as_drawn())
            area += p.weight;
    for (const auto& face : faces)
        for (const auto& p : machine.interfaces[face.contact].points_as_drawn()) {
            const Vec3 weight = (p.weight / area) * p.normal;
            result.points.push_back({p.face_b, p.position_b, weight});
            result.points.push_back({p.face_a, p.position_a, -1.0 * weight});
        }
    return result;
}

Vec3 with_largest_positive(const Vec3& v)
{
    const auto largest = std::ranges::max_element(v, {}, [](double c) { return std::abs(c); });
    return (*largest < 0 ? -1.0 : 1.0) * v;
}

}  // namespace

Functional bearing_clearance(const Machine& machine, const std::vector<int>& contacts, const Vec2& centre)
{
    Functional growth;
    for (const int contact : contacts)
        add(growth, 2, contact_growth(machine, contact, centre));
    return growth;
}

std::vector<GuideClearance> guide_clearances(const Machine& machine, const std::vector<int>& contacts)
{
    constexpr double alike = 0.95;
    std::vector<GuideClearance> result;
    auto left = guide_faces(machine, contacts);
    while (!left.empty()) {
        const Vec3 across = with_largest_positive(left.front().normal);
        std::array<std::vector<GuideFace>, 2> sides;
        std::vector<GuideFace> others;
        for (const auto& face : left) {
            const double along = dot(face.normal, across);
            (along > alike ? sides[0] : along < -alike ? sides[1] : others).push_back(face);
        }
        left = std::move(others);
        if (sides[0].empty() || sides[1].empty())
            continue;
        GuideClearance clearance{across, {}};
        for (const auto& side : sides)
            add(clearance.growth, 1, mean_opening(machine, side));
        // In a half model a V of four faces gives the same clearance twice, once as its mirror image.
        const bool mirror_image = std::ranges::any_of(result, [&](const GuideClearance& c) {
            return machine.half_model &&
                   dot(c.across, with_largest_positive({-across[0], across[1], across[2]})) > alike;
        });
        if (!mirror_image)
            result.push_back(std::move(clearance));
    }
    return result;
}

}  // namespace deadpoint::drift
