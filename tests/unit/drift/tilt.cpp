#include "deadpoint/drift/tilt.hpp"

#include "contacts.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "near.hpp"

using namespace deadpoint;
using namespace deadpoint::drift;

namespace {

constexpr double micro = 1e-6;
const Vec2 centre{0.3, -0.12};

auto microradians(double expected) { return near(expected * micro, 1e-9); }

Vec3 tilted(double angle, const Vec3& x) { return cross({angle * micro, 0, 0}, x); }

// Information of rings that weigh the same: the mean of sin^2 around the axis times the spread along it.
double bearing_information(const Machine& machine, int contact, int rings)
{
    return machine.interfaces[contact].drawn_area / 2 * ring_distance * ring_distance * (rings * rings - 1) / 12;
}

}  // namespace

TEST_CASE("tilt of a bearing: that of its axis, whatever it grows or tapers, held as its length says")
{
    auto machine = two_bodies();
    add_bearing(machine, centre, 0, 360, true, 9);
    const auto fit = fit_tilt(machine, {{0, false}}, Vec3{1, 0, 0}, false);
    REQUIRE(fit);
    const auto displacement = [](std::uint32_t, const Vec3& x) {
        const Vec3 arm{x[0] - centre[0], x[1] - centre[1], 0};
        return tilted(30, x) + micro * Vec3{4, -3, 8} + (5e-5 + 2e-3 * x[2]) * arm;
    };
    CHECK(value(fit->angle, displacement) == microradians(30));
    CHECK(fit->information == near(bearing_information(machine, 0, 9), 1e-9));
    CHECK_FALSE(fit_tilt(machine, {{0, false}}, Vec3{0, 0, 1}, false));  // about its own axis
    CHECK_FALSE(fit_tilt(machine, {}, Vec3{1, 0, 0}, false));
}

TEST_CASE("tilt of two bearings beside each other: each may grow as it likes")
{
    auto machine = two_bodies();
    add_bearing(machine, centre, 0, 360, true, 3);
    add_bearing(machine, {0.5, 0.2}, 0, 360, false, 5);
    const auto fit = fit_tilt(machine, {{0, false}, {1, true}}, Vec3{1, 0, 0}, false);
    REQUIRE(fit);
    const auto displacement = [](std::uint32_t face, const Vec3& x) {
        const Vec2 axis = face == 0 ? centre : Vec2{0.5, 0.2};
        const Vec3 arm{x[0] - axis[0], x[1] - axis[1], 0};
        return tilted(30, x) + (face == 0 ? 5e-5 : -2e-5 + 1e-3 * x[2]) * arm;
    };
    CHECK(value(fit->angle, displacement) == microradians(30));
    CHECK(fit_tilt(machine, {{0, false}, {1, true}}, Vec3{0, 0, 1}, false));
}

TEST_CASE("tilts of bodies: in series they add up, side by side the longer bearing counts as the cube of its length")
{
    auto machine = two_bodies();
    for (const int rings : {9, 4, 6})
        add_bearing(machine, centre, 0, 360, true, rings);
    Linkage linkage;
    linkage.bodies = {"frame", "crank", "slide", "loose"};
    ChainDescription chain;
    const auto join = [&](int body_a, int body_b, int contact) {
        LinkageJoint joint;
        joint.body_a = body_a;
        joint.body_b = body_b;
        linkage.joints.push_back(joint);
        chain.joints.push_back({{{contact, false}}, {{contact, true}}});
    };
    join(0, 1, 0);
    join(0, 1, 1);
    join(2, 1, 2);
    BottomDeadPointSensitivity sensitivity;
    sensitivity.joint_centres.assign(3, centre);
    sensitivity.weight.assign(3, {0, 0});

    const TiltClosure closure(machine, linkage, sensitivity, chain);
    CHECK(closure.holds(2));
    CHECK_FALSE(closure.holds(3));
    // What each side of each bearing turns within its body [urad].
    const std::vector<double> turn{3, 10, -2, 7, 6, -5};
    const auto displacement = [&](std::uint32_t face, const Vec3& x) { return tilted(turn[face], x); };
    const double first = bearing_information(machine, 0, 9), second = bearing_information(machine, 1, 4);
    const double crank = -(first * (10 - 3) + second * (7 + 2)) / (first + second);
    const double slide = crank + (-5 - 6);
    CHECK(value(closure.combine({0, 1, 0, 0}), displacement) == microradians(crank));
    CHECK(value(closure.combine({4, 0, 1, 9}), displacement) == microradians(slide));
    CHECK(value(closure.combine({0, 2, -3, 0}), displacement) == microradians(2 * crank - 3 * slide));
}
