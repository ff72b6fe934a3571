#include "balance.hpp"
#include "deadpoint/mechanism/bottom_dead_point.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/mechanism/mirror.hpp"
#include "driver_speed.hpp"
#include "linkages.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

// The twelve-body linkage with both halves (18 moving bodies, 54 equations) against an independent multibody program.

using namespace deadpoint;
using mechanism::CycleRequest;
using mechanism::MirroredLinkage;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double tolerance = 1e-8;  // of the largest value of each quantity over the turn

const nlohmann::json& oracle()
{
    static const nlohmann::json data = [] {
        std::ifstream file(std::string(DEADPOINT_TEST_DATA) + "/mechanism_oracle.json");
        return nlohmann::json::parse(file);
    }();
    return data;
}

const nlohmann::json& set_of(double l5a, double rpm)
{
    for (const auto& set : oracle()["sets"])
        if (set["l5a"].get<double>() == l5a && set["rpm"].get<double>() == rpm)
            return set;
    throw std::runtime_error("no such set in the reference data");
}

const nlohmann::json& row_at(const nlohmann::json& set, double theta)
{
    for (const auto& row : set["rows"])
        if (row["theta"].get<double>() == theta)
            return row;
    throw std::runtime_error("no such crank angle in the reference data");
}

/// One half, assembled at bottom dead point.
struct Half {
    Linkage linkage;
    std::vector<BodyMass> masses;
    std::vector<bool> twice;
};

int body_named(const Linkage& linkage, const std::string& name)
{
    const auto found = std::find(linkage.bodies.begin(), linkage.bodies.end(), name);
    REQUIRE(found != linkage.bodies.end());
    return static_cast<int>(found - linkage.bodies.begin());
}

Half half_of(double l5a, bool left)
{
    const nlohmann::json& row = row_at(set_of(l5a, 200), 270);
    nlohmann::json rows = {{{"theta_deg", 270.0}}};
    for (const auto& [name, values] : row["joint"].items())
        rows[0]["joint"][name]["p"] = {values[0], values[1]};
    Half half;
    half.linkage = linkages::twelve_body(rows);
    for (LinkageJoint& joint : half.linkage.joints)
        if (joint.name == "89") {  // in the reference link 9 hangs on link 7, on the same pin
            joint.name = "79";
            joint.body_b = body_named(half.linkage, "7");
        }
    half.masses.resize(half.linkage.bodies.size());
    half.twice.resize(half.linkage.bodies.size());
    for (std::size_t body = 1; body < half.masses.size(); ++body) {
        const std::string& name = half.linkage.bodies[body];
        BodyMass& mass = half.masses[body];
        mass.mass = oracle()["masses"][name];
        mass.inertia = oracle()["inertias"].value(name, 0.0);
        for (const std::string& key : {name, name + "R"})
            if (row["body"].contains(key))
                mass.centre = {row["body"][key][3], row["body"][key][4]};
        half.twice[body] = name == "12" || row["body"].contains(name + "R");
    }
    if (left) {
        for (LinkageJoint& joint : half.linkage.joints)
            joint.centre[0] = -joint.centre[0];
        for (BodyMass& mass : half.masses)
            mass.centre[0] = -mass.centre[0];
    }
    return half;
}

/// The whole press, built from one of its halves.
struct Press {
    MirroredLinkage full;
    CycleRequest request;
    bool left = false;

    Press(double l5a, double rpm, double force, int positions, bool from_left = false) : left(from_left)
    {
        const Half half = half_of(l5a, left);
        full = mechanism::mirrored(half.linkage, half.twice);
        request.masses = mechanism::mirrored(half.masses, full);
        request.speed = mechanism::steady_speed(rpm * pi / 30).speed;
        request.process_force = [force](double, double, double) { return force; };
        request.gravity = {0, -oracle()["g"].get<double>()};
        request.positions = positions;
    }
    [[nodiscard]] CycleHistory run() const { return mechanism::analyse_cycle(full.linkage, request); }
    /// Body or joint of the right half, which is the image if the left half was given.
    [[nodiscard]] int right_body(const std::string& name) const
    {
        const std::string image = name + "'";
        const auto& bodies = full.linkage.bodies;
        return body_named(full.linkage, left && std::count(bodies.begin(), bodies.end(), image) ? image : name);
    }
    [[nodiscard]] int joint(const std::string& name) const
    {
        const int found = find(name);
        if (found < 0)
            throw std::runtime_error("no joint named " + name);
        return found;
    }
    [[nodiscard]] int right_joint(const std::string& name) const
    {
        const int image = find(name + "'");
        return left && image >= 0 ? image : joint(name);
    }

private:
    [[nodiscard]] int find(const std::string& name) const
    {
        for (std::size_t j = 0; j < full.linkage.joints.size(); ++j)
            if (full.linkage.joints[j].name == name)
                return static_cast<int>(j);
        return -1;
    }
};

/// Compares quantities over the turn: the largest difference by the largest value, per name.
class Comparison {
public:
    void add(const std::string& name, const Vec2& ours, const Vec2& reference)
    {
        Entry& entry = entries_[name];
        entry.difference = std::max(entry.difference, norm(ours - reference));
        entry.scale = std::max(entry.scale, norm(reference));
    }
    void add(const std::string& name, double ours, double reference) { add(name, Vec2{ours, 0}, {reference, 0}); }
    void require() const
    {
        for (const auto& [name, entry] : entries_) {
            CAPTURE(name);
            CHECK(entry.difference <= tolerance * std::max(entry.scale, 1e-6));
        }
    }

private:
    struct Entry {
        double difference = 0;
        double scale = 0;
    };
    std::map<std::string, Entry> entries_;
};

std::size_t sample_at(double theta) { return static_cast<std::size_t>(std::lround(std::fmod(theta + 90, 360.0))); }

/// Names of the reference's joints and ours, and whether ours names the bodies in the other order.
struct JointName {
    const char* theirs;
    const char* ours;
    bool swapped;
};
constexpr JointName joint_names[] = {
    {"12", "12", false},   {"32", "23", true},    {"34", "34", false},    {"45", "45", false}, {"56", "56", false},
    {"16", "61", false},   {"57", "57", true},    {"78", "78", true},     {"79", "79", false}, {"18", "81", false},
    {"910", "910", false}, {"811", "811", false}, {"1112", "1112", false}};

}  // namespace

TEST_CASE("whole press: angles, centres of mass and joints over the turn, with their rates")
{
    for (const double l5a : {0.24, 0.23}) {
        for (const bool left : {false, true}) {
            const Press press(l5a, 200, 0, 360, left);
            const CycleHistory history = press.run();
            const nlohmann::json& set = set_of(l5a, 200);
            const nlohmann::json& start = row_at(set, 270)["body"];
            Comparison comparison;
            for (const auto& row : set["rows"]) {
                const std::size_t i = sample_at(row["theta"]);
                for (const auto& [key, value] : row["body"].items()) {
                    const std::string name = key.ends_with('R') ? key.substr(0, key.size() - 1) : key;
                    const int body = press.right_body(name);
                    const BodyCycle& cycle = history.bodies[body];
                    const Vec2 centre = press.request.masses[body].centre;
                    const double turned = value[0].get<double>() - start[key][0].get<double>();
                    const double off = std::remainder(cycle.pose[i].angle - turned, 2 * pi);
                    comparison.add(name + " angle", 1 + off, 1);  // against one radian
                    comparison.add(name + " rate", cycle.velocity[i].angle, value[1]);
                    comparison.add(name + " angular acceleration", cycle.acceleration[i].angle, value[2]);
                    comparison.add(name + " centre", mechanism::place(cycle.pose[i], centre), {value[3], value[4]});
                    comparison.add(name + " velocity", mechanism::velocity_of(cycle.pose[i], cycle.velocity[i], centre),
                                   {value[5], value[6]});
                    comparison.add(
                        name + " acceleration",
                        mechanism::acceleration_of(cycle.pose[i], cycle.velocity[i], cycle.acceleration[i], centre),
                        {value[7], value[8]});
                }
                for (const auto& [name, value] : row["joint"].items()) {
                    const int joint = press.right_joint(name);
                    const LinkageJoint& description = press.full.linkage.joints[joint];
                    const BodyCycle& cycle = history.bodies[description.body_a];
                    comparison.add("joint " + name, history.joints[joint].centre[i], {value[0], value[1]});
                    comparison.add("joint velocity " + name,
                                   mechanism::velocity_of(cycle.pose[i], cycle.velocity[i], description.centre),
                                   {value[2], value[3]});
                    comparison.add("joint acceleration " + name,
                                   mechanism::acceleration_of(cycle.pose[i], cycle.velocity[i], cycle.acceleration[i],
                                                              description.centre),
                                   {value[4], value[5]});
                }
            }
            comparison.require();
        }
    }
}

TEST_CASE("whole press: every joint force, drive torque and guide force")
{
    for (const auto& set : oracle()["sets"]) {
        for (const char* load : {"0", "300000"}) {
            const bool left = set["rpm"].get<double>() > 300;  // one of the halves for each speed
            const Press press(set["l5a"], set["rpm"], std::stod(load), 360, left);
            const CycleHistory history = press.run();
            Comparison comparison;
            double centre_guide = 0;
            for (const auto& row : set["rows"]) {
                const std::size_t i = sample_at(row["theta"]);
                const nlohmann::json& forces = row["forces"][load];
                for (const JointName& name : joint_names) {
                    const Vec2 ours = history.joints[press.right_joint(name.ours)].force[i];
                    comparison.add(std::string("force ") + name.theirs, (name.swapped ? -1.0 : 1.0) * ours,
                                   forces[name.theirs].get<Vec2>());
                }
                comparison.add("torque", history.drive_torque[i], forces["torque"]);
                comparison.add("guide 4", history.joints[press.joint("guide_4")].force[i][0], forces["g4"]);
                comparison.add("guide 12", history.joints[press.right_joint("guide_12")].force[i][0], forces["g12R"]);
                centre_guide = std::max(centre_guide, norm(history.joints[press.joint("guide_10")].force[i]));
            }
            comparison.require();
            CHECK(centre_guide < 1e-6);  // the halves balance each other; up to 450 kN act in the joints
        }
    }
}

TEST_CASE("whole press: force, moment and power balance, also with an eccentric load")
{
    for (const double force : {0.0, 3e5}) {
        Press press(0.24, 200, force, 90);
        balance::require_balanced(press.full.linkage, press.request, press.run());
    }
    // Slide 10 has no guide for its rotation here, so that an eccentric load goes through the links on both sides.
    Press press(0.23, 500, 3e5, 90);
    press.request.process_force_offset = 0.1;
    const CycleHistory history = press.run();
    balance::require_balanced(press.full.linkage, press.request, history);
    const Vec2 right = history.joints[press.joint("910")].force[0];
    const Vec2 left = history.joints[press.joint("910'")].force[0];
    CHECK(right[1] > left[1]);
}

TEST_CASE("whole press: stroke, dead points and largest values")
{
    for (const auto& row : oracle()["summary"]) {
        const Press press(row["l5a"], row["rpm"], 0, 720);
        const CycleHistory history = press.run();
        const auto figures = mechanism::stroke_figures(press.full.linkage, press.request, history);
        CHECK(figures.stroke == near(row["stroke10"].get<double>(), 1e-10));
        CHECK(std::abs(figures.bottom_dead_point) < 1e-10);
        CHECK(figures.top_dead_point == near(pi, 1e-10));

        // The reference's extremes are those of its samples, which are every half degree as ours.
        const auto [low, high] =
            std::minmax_element(history.slide_acceleration.begin(), history.slide_acceleration.end());
        CHECK(*high == near(row["a10_max"].get<double>(), tolerance));
        CHECK(*low == near(row["a10_min"].get<double>(), tolerance));
        CHECK(*std::max_element(history.slide_speed.begin(), history.slide_speed.end()) ==
              near(row["v10_peak"].get<double>(), tolerance));
        CHECK(figures.largest_speed >= row["v10_peak"].get<double>() * (1 - tolerance));
        CHECK(figures.largest_speed == near(row["v10_peak"].get<double>(), 2e-5));
        CHECK(figures.largest_acceleration == near(-row["a10_min"].get<double>(), 2e-5));

        double extremes[4] = {0, 0, 0, 0};
        for (const Vec2& force : history.joints[press.joint("23")].force) {
            // On the rod by the crank: the source counts the crank's upward component down, and x is symmetric.
            extremes[0] = std::min(extremes[0], force[0]);
            extremes[1] = std::max(extremes[1], force[0]);
            extremes[2] = std::min(extremes[2], force[1]);
            extremes[3] = std::max(extremes[3], force[1]);
        }
        CHECK(extremes[0] == near(row["Fx32"][0].get<double>(), tolerance));
        CHECK(extremes[1] == near(row["Fx32"][1].get<double>(), tolerance));
        CHECK(extremes[2] == near(row["Fy32"][0].get<double>(), tolerance));
        CHECK(extremes[3] == near(row["Fy32"][1].get<double>(), tolerance));

        const auto drive = mechanism::drive_figures(history);
        CHECK(drive.rms_torque == near(row["torque"]["rms"].get<double>(), tolerance));
        CHECK(drive.peak_torque == near(row["torque"]["max"].get<double>(), tolerance));
        CHECK(std::abs(drive.mean_torque) < 1e-9 * drive.peak_torque);
        CHECK(std::abs(drive.mean_power) < 1e-9 * drive.peak_torque * history.speed[0]);
    }
}

TEST_CASE("whole press: height near bottom dead point and what the crank pin feels")
{
    // Published: 0.043, 0.179 and 0.427 mm above bottom dead point at 10, 20 and 30 degrees, dy10/dy4 = 0.1045 there.
    const Press press(0.24, 200, 0, 360);
    const CycleHistory history = press.run();
    CHECK(history.height[10] == near(0.043e-3, 0.01));
    CHECK(history.height[20] == near(0.179e-3, 0.01));
    CHECK(history.height[350] == near(0.043e-3, 0.01));
    CHECK(std::abs(history.height[0]) < 1e-15);

    const auto figures = mechanism::stroke_figures(press.full.linkage, press.request, history);
    const mechanism::PlanarSystem system(press.full.linkage);
    const auto ratios = mechanism::force_ratios(press.full.linkage, history);
    CHECK(ratios.size() == 358);  // all but the two dead points
    for (const auto& ratio : ratios) {
        const auto angle = ratio.past_bottom * 180 / pi;
        if (std::abs(angle + 10) > 1e-6)
            continue;
        // By central differences of the height over two degrees: error of second order, 2e-3.
        const double by_angle = (history.height[351] - history.height[349]) / (2 * pi / 180);
        CHECK(ratio.force_by_torque == near(1 / std::abs(by_angle), 2e-3));
        CHECK(ratio.advantage == near(0.025 * ratio.force_by_torque, 1e-5));
    }
    // Ends of the dwell: symmetric about bottom dead point, at the height asked for.
    for (const auto& [share, height] : {std::pair{figures.dwell_10um, 10e-6}, {figures.dwell_100um, 100e-6}}) {
        const auto poses = system.follow(system.assembled(), 0, share * pi);
        const Vec2 point = mechanism::place(poses[press.full.linkage.slide_body], system.slide_point());
        CHECK(point[1] - system.slide_point()[1] == near(height, 1e-9));
    }
}

TEST_CASE("the half alone gives the same motion as the whole")
{
    const Half half = half_of(0.24, false);
    const auto alone = mechanism::bottom_dead_point(half.linkage);
    const Press press(0.24, 200, 0, 90);
    const auto whole = mechanism::bottom_dead_point(press.full.linkage);
    for (std::size_t j = 0; j < half.linkage.joints.size(); ++j)
        CHECK(norm(alone.joint_centres[j] - whole.joint_centres[j]) < 1e-12);
    // A shift of both halves counts as one of the half: the weights of pin and image add up to the half's.
    const int pin = press.joint("56");
    const int image = press.joint("56'");
    CHECK(whole.weight[pin][1] + whole.weight[image][1] == near(alone.weight[pin][1], 1e-9));
}
