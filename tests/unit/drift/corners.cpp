#include "deadpoint/drift/corners.hpp"

#include "contacts.hpp"
#include "deadpoint/exchange/linkage.hpp"

#include <array>

using namespace deadpoint;
using namespace deadpoint::drift;

namespace {

// Surface 0: the slide's face, on faces 0 to 2. Surface 1: a table below it that stands askew.
Machine with_table()
{
    Machine machine = two_bodies();
    const auto add_face = [&](std::uint32_t part, const std::vector<Vec3>& nodes) {
        Face face;
        face.part = part;
        face.node_count = static_cast<std::uint8_t>(nodes.size());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            face.nodes[i] = static_cast<std::uint32_t>(machine.nodes.size());
            machine.nodes.push_back(nodes[i]);
        }
        machine.faces.push_back(face);
        return SurfaceFace{static_cast<std::uint32_t>(machine.faces.size() - 1), 1};
    };
    MeshSurface slide, table;
    slide.faces.push_back(add_face(0, {{-0.4, 0, -0.3}, {0.1, 0, -0.3}, {0.1, 0, 0.3}, {-0.4, 0, 0.3}}));
    slide.faces.push_back(add_face(0, {{0.1, 0, -0.3}, {0.4, 0, -0.3}, {0.4, 0, 0.3}}));
    slide.faces.push_back(add_face(0, {{0.1, 0, -0.3}, {0.4, 0, 0.3}, {0.1, 0, 0.3}}));
    table.faces.push_back(add_face(1, {{-0.9, -0.3, 0.1}, {-0.2, -0.3, -0.9}, {0.1, -0.3, 0.2}}));
    table.faces.push_back(add_face(1, {{-0.2, -0.3, -0.9}, {0.9, -0.3, -0.2}, {0.3, -0.3, 0.9}, {0.1, -0.3, 0.2}}));
    table.faces.push_back(add_face(1, {{-0.9, -0.3, 0.1}, {0.1, -0.3, 0.2}, {0.3, -0.3, 0.9}}));
    machine.surfaces = {slide, table};
    return machine;
}

void add_pad(Machine& machine, const Vec3& middle, const Vec3& normal)
{
    std::vector<ContactPoint> points;
    for (const double y : {-0.1, 0.1})
        for (const double z : {-0.2, 0.2}) {
            ContactPoint point;
            point.position_a = point.position_b = middle + Vec3{0, y, z};
            point.normal = normal;
            point.weight = 1e-3;
            points.push_back(point);
        }
    add_contact(machine, PlaneGeometry{normal, 0}, points);
}

}  // namespace

TEST_CASE("corners: the gap to the table's point below, on a table that bends as a plane")
{
    const auto machine = with_table();
    Linkage linkage;
    linkage.bodies = {"frame", "slide"};
    linkage.slide_body = 1;
    LinkageJoint guide;
    guide.kind = LinkageJoint::Kind::slide;
    guide.body_b = 1;
    guide.guides_rotation = false;
    linkage.joints = {guide};
    BottomDeadPointSensitivity sensitivity;
    sensitivity.joint_centres = {{0, 0}};
    sensitivity.weight = {{0, 0}};
    ChainDescription chain;
    chain.joints.resize(1);
    chain.slide_surface = 0;
    chain.table_surface = 1;
    std::vector<Functional> dimensions(dimension_count);
    dimensions[slide_height].points = {{0, {-0.2, 0, 0.1}, {0, 1, 0}}};
    const auto slide_at = [](double x, double z) { return 11 - 4 * x + 6 * z; };  // [um]
    const auto table_at = [](double x, double z) { return 2 + 3 * x - 5 * z; };
    const auto displacement = [&](std::uint32_t face, const Vec3& at) {
        return micrometre * Vec3{1, face < 3 ? slide_at(at[0], at[2]) : table_at(at[0], at[2]), 1};
    };
    // The travel is the chain's height of the slide less the mean of its face, which a plane takes at its middle.
    const double travel = slide_at(-0.2, 0.1) - slide_at(0, 0);
    // Who stands at z > 0 and looks at the machine, y up, has x > 0 on the right; who walks around it by a quarter to x
    // > 0 has z < 0 there, at z < 0 x < 0, and at x < 0 z > 0. Places of front left, front right, back left, back
    // right:
    struct Seen {
        Vec3 front;
        std::array<Vec2, 4> places;
    };
    const std::array<Vec2, 4> from_z{{{-0.4, 0.3}, {0.4, 0.3}, {-0.4, -0.3}, {0.4, -0.3}}};
    const std::array<Vec2, 4> from_x{{{0.4, 0.3}, {0.4, -0.3}, {-0.4, 0.3}, {-0.4, -0.3}}};
    const std::array<Vec2, 4> from_back{{{0.4, -0.3}, {-0.4, -0.3}, {0.4, 0.3}, {-0.4, 0.3}}};
    const std::array<Vec2, 4> from_left{{{-0.4, -0.3}, {-0.4, 0.3}, {0.4, -0.3}, {0.4, 0.3}}};
    const std::array names{"front left", "front right", "back left", "back right"};
    for (const auto& seen :
         {Seen{{0, 0, 1}, from_z}, Seen{{1, 0, 0}, from_x}, Seen{{0, 0, -1}, from_back}, Seen{{-1, 0, 0}, from_left}}) {
        const auto corners = corner_gaps(machine, linkage, sensitivity, chain, dimensions, {{{0, 0}}, 0}, seen.front);
        REQUIRE(corners.size() == 4);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& corner = corners[i];
            const auto [x, z] = seen.places[i];
            CAPTURE(corner.name);
            CHECK(corner.name == names[i]);
            CHECK(corner.x == x);
            CHECK(corner.z == z);
            CHECK(value(corner.gap, displacement) == micrometres(slide_at(x, z) - table_at(x, z) + travel));
        }
    }
}

TEST_CASE("corners do not feel how the slide stands, its rod aslant and its guide off the middle")
{
    auto machine = with_table();
    const Vec2 pin_centre{0.05, 0.25}, guide_centre{0.01, 0.4};
    add_bearing(machine, pin_centre, 0, 360, true, 9);
    const double middle = 4 * ring_distance;
    add_pad(machine, {0.3, guide_centre[1], middle}, {1, 0, 0});
    add_pad(machine, {-0.3, guide_centre[1], middle}, {-1, 0, 0});
    add_pad(machine, {0, guide_centre[1], middle - 0.3}, {0, 0, -1});

    Linkage linkage;
    linkage.bodies = {"frame", "slide", "rod"};
    linkage.slide_body = 1;
    LinkageJoint pin, guide;
    pin.body_a = 2;
    pin.body_b = 1;
    guide.kind = LinkageJoint::Kind::slide;
    guide.body_b = 1;
    linkage.joints = {guide, pin};
    // The pin passes on what the rod lets it: its height, and 0.3 of its way aside, which the guide undoes.
    constexpr double aslant = 0.3;
    BottomDeadPointSensitivity sensitivity;
    sensitivity.joint_centres = {guide_centre, pin_centre};
    sensitivity.weight = {{-aslant, 0}, {aslant, -1}};
    ChainDescription chain;
    chain.joints = {{{{1, false}, {2, false}, {3, false}}, {{1, true}, {2, true}, {3, true}}},
                    {{{0, false}}, {{0, true}}}};
    chain.slide_surface = 0;
    chain.table_surface = 1;
    chain.crank_joint = 1;
    const auto dimensions = chain_functionals(machine, linkage, sensitivity, chain);
    const auto corners =
        corner_gaps(machine, linkage, sensitivity, chain, dimensions, {{{0, 0}, {0, 0}}, 0}, {0, 0, 1});
    REQUIRE(corners.size() == 4);
    const auto of_slide = [&](std::uint32_t face) {
        return face < 3 || (face >= machine.faces.size() && (face - machine.faces.size()) % 2 == 1);
    };
    for (int motion = 0; motion < 6; ++motion) {
        CAPTURE(motion);
        Vec3 shift{}, turn{};
        (motion < 3 ? shift[motion] : turn[motion - 3]) = 1;
        const auto rigid = [&](std::uint32_t face, const Vec3& x) {
            return of_slide(face) ? shift + cross(turn, x) : Vec3{};
        };
        for (const auto& corner : corners)
            CHECK(std::abs(value(corner.gap, rigid)) < 1e-12);
    }
}
