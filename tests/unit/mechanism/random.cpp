#include "balance.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "linkages.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <numbers>
#include <random>

// Property test: whatever linkage turns all around obeys Newton, Euler and the conservation of energy.

using namespace deadpoint;
using mechanism::CycleRequest;

namespace {

constexpr double pi = std::numbers::pi;

/// Draws linkages: a crank, then up to four dyads (two bodies that hold each other on a moving point and the ground),
/// each hung on one of the bodies before, the last of them ending in the slide.
class Draw {
public:
    explicit Draw(unsigned seed) : engine_(seed) {}

    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
    Vec2 direction()
    {
        const double angle = between(-pi, pi);
        return {std::cos(angle), std::sin(angle)};
    }

    Linkage linkage()
    {
        linkage_ = {};
        points_.clear();
        linkage_.bodies = {"frame", "crank"};
        const Vec2 centre{between(-0.5, 0.5), between(-0.5, 0.5)};
        const Vec2 pin = centre + between(0.03, 0.1) * direction();
        add(linkages::revolute("bearing", 1, 0, centre));
        points_ = {{1, pin}, {1, centre + between(0.02, 0.08) * direction()}};
        const int dyads = 1 + below(4);
        for (int i = 0; i + 1 < dyads; ++i)
            below(3) == 0 ? add_slide() : add_rocker();
        add_slide();
        linkage_.slide_body = static_cast<int>(linkage_.bodies.size()) - 1;
        linkage_.stroke_direction = linkage_.joints.back().direction;
        return linkage_;
    }

    CycleRequest request(const Linkage& linkage)
    {
        CycleRequest request;
        for (std::size_t body = 0; body < linkage.bodies.size(); ++body)
            request.masses.push_back({between(1, 200), {between(-1, 1), between(-1, 1)}, between(0.01, 20)});
        request.masses[2] = {};  // a massless link
        const double speed = between(5, 60);
        const double swing = between(0, 0.3);
        request.speed = [=](double a) { return speed * (1 + swing * std::sin(a)); };
        request.speed_slope = [=](double a) { return speed * swing * std::cos(a); };
        const double force = between(0, 1e5);
        request.process_force = [=](double a, double, double) { return force * std::exp(4 * (std::cos(a) - 1)); };
        request.process_force_offset = between(-0.2, 0.2);
        request.gravity = {between(-10, 10), between(-10, 10)};
        request.positions = 360;
        return request;
    }

private:
    struct Point {
        int body;
        Vec2 place;
    };

    /// Joints name their bodies in either order.
    void add(LinkageJoint joint)
    {
        if (below(2) == 0)
            std::swap(joint.body_a, joint.body_b);
        linkage_.joints.push_back(std::move(joint));
    }
    int add_body(const char* kind)
    {
        linkage_.bodies.push_back(fmt::format("{}_{}", kind, linkage_.bodies.size()));
        return static_cast<int>(linkage_.bodies.size()) - 1;
    }
    std::string joint_name() const { return fmt::format("joint_{}", linkage_.joints.size()); }

    /// Two links in a knee: one on the moving point, the other on the ground.
    void add_rocker()
    {
        const Point from = points_[below(static_cast<int>(points_.size()))];
        const Vec2 knee = from.place + between(0.3, 0.8) * direction();
        const Vec2 pivot = knee + between(0.3, 0.8) * direction();
        const int link = add_body("link");
        const int rocker = add_body("rocker");
        add(linkages::revolute(joint_name(), link, from.body, from.place));
        add(linkages::revolute(joint_name(), link, rocker, knee));
        add(linkages::revolute(joint_name(), rocker, 0, pivot));
        points_.push_back({link, knee + between(0.05, 0.3) * direction()});
        points_.push_back({rocker, pivot + between(0.05, 0.2) * direction()});
    }

    /// A link and a slide on the ground.
    void add_slide()
    {
        const Point from = points_[below(static_cast<int>(points_.size()))];
        const Vec2 pin = from.place + between(0.4, 1.2) * direction();
        const int link = add_body("link");
        const int slide = add_body("slide");
        add(linkages::revolute(joint_name(), link, from.body, from.place));
        add(linkages::revolute(joint_name(), link, slide, pin));
        add(linkages::slide(joint_name(), slide, 0, pin + between(0, 0.1) * direction(), direction()));
        points_.push_back({slide, pin + between(0, 0.1) * direction()});
    }

    std::mt19937 engine_;
    Linkage linkage_;
    std::vector<Point> points_;
};

/// Rates of the poses against differences of the poses themselves, at constant speed of the driver.
void check_rates(const Linkage& linkage, CycleRequest request)
{
    request.speed = [](double) { return 1.0; };
    request.speed_slope = nullptr;
    request.positions = 7200;
    const CycleHistory history = mechanism::analyse_cycle(linkage, request);
    const double h = 2 * pi / request.positions;
    for (const BodyCycle& body : history.bodies) {
        double largest = 1;
        for (const PlanarPose& a : body.acceleration)
            largest = std::max(largest, std::abs(a.angle));
        for (std::size_t i = 1; i + 1 < body.pose.size(); i += 37) {
            const double before = body.pose[i - 1].angle;
            const double here = body.pose[i].angle;
            const double after = body.pose[i + 1].angle;
            // Error h^2 = 8e-7 times derivatives, which grow as the linkage nears a singular position.
            CHECK(std::abs((after - before) / (2 * h) - body.velocity[i].angle) < 1e-4 * largest);
            CHECK(std::abs((after - 2 * here + before) / (h * h) - body.acceleration[i].angle) < 1e-2 * largest);
        }
    }
}

}  // namespace

TEST_CASE("random linkages that turn all around obey the balances of force, moment and power")
{
    Draw draw(20180917);
    int valid = 0;
    int refused = 0;
    std::size_t most_bodies = 0;
    while (valid < 60) {
        const Linkage linkage = draw.linkage();
        const CycleRequest request = draw.request(linkage);
        CycleHistory history;
        try {
            history = mechanism::analyse_cycle(linkage, request);
        } catch (const InputError&) {
            REQUIRE(++refused < 3000);  // most knees are too short for a whole turn
            continue;
        }
        CAPTURE(valid);
        balance::require_balanced(linkage, request, history);

        // Energy over the turn: what the drive gives the process takes, whatever the masses do.
        double process = 0;
        double size = 0;
        for (std::size_t i = 0; i < history.angle.size(); ++i) {
            const PlanarPose& velocity = history.bodies[linkage.slide_body].velocity[i];
            CHECK(std::abs(velocity.angle) < 1e-9);
            process += history.process_force[i] * history.slide_speed[i] / history.speed[i] * 2 * pi / 360;
            size += std::abs(history.drive_torque[i]) * 2 * pi / 360;
        }
        // The trapezoid rule converges fast on periodic functions; near a dead knee 360 positions leave 1e-6.
        const double drive = mechanism::drive_figures(history).mean_power * history.period;
        CHECK(std::abs(drive + process) < 1e-5 * size);
        if (valid % 10 == 0)
            check_rates(linkage, request);
        most_bodies = std::max(most_bodies, linkage.bodies.size());
        ++valid;
    }
    CHECK(most_bodies >= 8);
    MESSAGE(valid, " linkages of up to ", most_bodies - 1, " moving bodies; ", refused, " did not turn");
}
