#include "deadpoint/drift/chain.hpp"
#include "deadpoint/drift/clearances.hpp"
#include "deadpoint/drift/contact_side.hpp"
#include "deadpoint/drift/corners.hpp"
#include "drift_contacts.hpp"

using namespace deadpoint;
using namespace deadpoint::drift;

TEST_CASE("a circle's centre: an arc off the origin gives back its shift and its growth, apart")
{
    const Vec2 centre{0.3, -0.12};
    for (const double end : {200.0, 250.0, 380.0}) {
        CAPTURE(end);
        auto machine = two_bodies();
        add_bearing(machine, centre, 20, end, true);
        const auto fit = fit_circle(machine, {0, false}, centre);
        const auto displacement = [&](std::uint32_t face, const Vec3& x) {
            return face == 0 ? micrometre * moved_circle(centre, {3, -2}, 5, x) : Vec3{1, 1, 1};
        };
        CHECK(value(fit.x, displacement) == micrometres(3));
        CHECK(value(fit.y, displacement) == micrometres(-2));
        CHECK(value(fit.growth, displacement) == micrometres(5));
    }
}

TEST_CASE("a circle's centre on the plane of a half model stays on it")
{
    const Vec2 centre{0, -0.12};
    auto machine = two_bodies();
    machine.half_model = true;
    machine.parts[0].cut = true;
    add_bearing(machine, centre, 90, 270, true);
    const auto fit = fit_circle(machine, {0, false}, centre);
    const auto displacement = [&](std::uint32_t, const Vec3& x) {
        return micrometre * moved_circle(centre, {0, -2}, 5, x);
    };
    CHECK(fit.x.points.empty());
    CHECK(value(fit.y, displacement) == micrometres(-2));
    CHECK(value(fit.growth, displacement) == micrometres(5));
}

TEST_CASE(
    "a bearing's clearance grows by twice what its bore grows more than its shaft, from whichever side it is seen")
{
    const Vec2 centre{0.3, -0.12};
    for (const bool bore : {true, false}) {
        CAPTURE(bore);
        auto machine = two_bodies();
        add_bearing(machine, centre, 0, 360, bore);
        const auto displacement = [&](std::uint32_t face, const Vec3& x) {
            const bool of_bore = (face == 0) == bore;
            return micrometre * moved_circle(centre, {of_bore ? 3.0 : -4.0, 1}, of_bore ? 5 : 2, x);
        };
        CHECK(value(bearing_clearance(machine, {0}, centre), displacement) == micrometres(6));
    }
}

TEST_CASE("a guide's clearance is what its opposite faces open together, wherever the slide stands")
{
    auto machine = two_bodies();
    const auto add_face = [&](const Vec3& normal, double weight) {
        std::vector<ContactPoint> points(3);
        for (int i = 0; i < 3; ++i) {
            points[i].position_a = points[i].position_b = -0.2 * normal + Vec3{0, 0.1 * i, 0};
            points[i].normal = normal;
            points[i].weight = weight * (i + 1);
        }
        add_contact(machine, PlaneGeometry{normal, 0}, points);
    };
    add_face({1, 0, 0}, 1e-3);
    add_face({-1, 0, 0}, 2e-3);
    add_face({0, 0, 1}, 1e-3);  // nothing opposite
    const auto clearances = guide_clearances(machine, {0, 1, 2});
    REQUIRE(clearances.size() == 1);
    CHECK(clearances[0].across == Vec3{1, 0, 0});
    // Side b of the first face recedes by 3 um, that of the second by 4; the slide as a whole stands 50 um aside.
    const auto displacement = [](std::uint32_t face, const Vec3&) {
        const double opens = face == 1 ? 3 : face == 3 ? -4 : 0;
        return micrometre * Vec3{opens + (face % 2 == 1 ? 50 : 0), 2, 9};
    };
    CHECK(value(clearances[0].growth, displacement) == micrometres(7));
}

TEST_CASE("the mean height of a surface counts each face with its share of it")
{
    Machine machine;
    machine.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {2, 0, 0}, {2, 0, 1}};
    machine.faces.resize(2);
    machine.faces[0].nodes = {0, 1, 2, 3};
    machine.faces[1].nodes = {1, 4, 5, 2};
    machine.surfaces.resize(1);
    machine.surfaces[0].faces = {{0, 1}, {1, 0.25}};
    const auto displacement = [](std::uint32_t face, const Vec3&) {
        return micrometre * Vec3{3, face == 0 ? 1.0 : 6.0, 3};
    };
    CHECK(value(mean_height(machine, 0), displacement) == micrometres((1 + 0.25 * 6) / 1.25));
}

TEST_CASE("corners: the gap to the table's point below, on a table that stands askew and bends as a plane")
{
    Machine machine;
    machine.parts.resize(2);
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
    const auto corners = corner_gaps(machine, linkage, sensitivity, chain, dimensions, {{{0, 0}}, 0});
    REQUIRE(corners.size() == 4);
    const auto slide_at = [](double x, double z) { return 11 - 4 * x + 6 * z; };  // [um]
    const auto table_at = [](double x, double z) { return 2 + 3 * x - 5 * z; };
    const auto displacement = [&](std::uint32_t face, const Vec3& at) {
        return micrometre * Vec3{1, face < 3 ? slide_at(at[0], at[2]) : table_at(at[0], at[2]), 1};
    };
    // The travel is the chain's height of the slide less the mean of its face, which a plane takes at its middle.
    const double travel = slide_at(-0.2, 0.1) - slide_at(0, 0);
    std::size_t i = 0;
    for (const double z : {-0.3, 0.3})
        for (const double x : {-0.4, 0.4}) {
            const auto& corner = corners[i++];
            CAPTURE(corner.name);
            CHECK(corner.name == std::string(z < 0 ? "front " : "back ") + (x < 0 ? "left" : "right"));
            CHECK(corner.x == x);
            CHECK(corner.z == z);
            CHECK(value(corner.gap, displacement) == micrometres(slide_at(x, z) - table_at(x, z) + travel));
        }
}
