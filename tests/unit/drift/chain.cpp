#include "deadpoint/drift/chain.hpp"

#include "contacts.hpp"
#include "deadpoint/drift/clearances.hpp"
#include "deadpoint/drift/contact_side.hpp"

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

TEST_CASE("the mean displacement of a surface counts each face with its share of it")
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
    CHECK(value(mean_along(machine, 0, {0, 1, 0}), displacement) == micrometres((1 + 0.25 * 6) / 1.25));
}
