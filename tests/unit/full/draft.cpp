#include "deadpoint/full/draft/draft.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "near.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <iterator>
#include <numbers>

using namespace deadpoint;
using namespace deadpoint::full;

namespace {

const std::string press = DEADPOINT_SOURCE_DIR "/cases/c-frame/press.step";

machine::CadModel drawing() { return machine::read_cad("press", press, {}, {}); }

std::vector<std::string> solids_of(const Draft& draft, const std::string& body)
{
    const auto found = std::ranges::find(draft.bodies, body, &DraftBody::name);
    REQUIRE(found != draft.bodies.end());
    std::vector<std::string> names;
    for (const std::size_t i : found->solids) {
        names.push_back(draft.model.solids[i].name);
    }
    std::ranges::sort(names);
    return names;
}

const DraftJoint& joint(const Draft& draft, const std::string& name)
{
    const auto found = std::ranges::find(draft.joints, name, &DraftJoint::name);
    REQUIRE(found != draft.joints.end());
    return *found;
}

/// The drawing with its axes exchanged: x, y and z become y, z and x.
machine::CadModel turned(machine::CadModel model)
{
    const auto turn = [](Vec3& v) { v = {v[2], v[0], v[1]}; };
    for (auto& solid : model.solids) {
        turn(solid.bounds.min);
        turn(solid.bounds.max);
        for (auto& face : solid.faces) {
            if (auto* plane = std::get_if<machine::CadPlane>(&face.form)) {
                turn(plane->normal);
                for (auto& loop : plane->loops) {
                    std::ranges::for_each(loop, turn);
                }
            } else if (auto* cylinder = std::get_if<machine::CadCylinder>(&face.form)) {
                turn(cylinder->point);
                turn(cylinder->axis);
                turn(cylinder->across);
            }
        }
    }
    return model;
}

}  // namespace

TEST_CASE("words in names of solids say what they are")
{
    CHECK(role_of("frame") == Role::frame);  // it holds "ram"
    CHECK(role_of("Slide_Guide-left") == Role::frame);
    CHECK(role_of("ram_upper") == Role::slide);
    CHECK(role_of("connecting_rod") == Role::rod);
    CHECK(role_of("Kurbelwelle") == Role::crank);
    CHECK(role_of("motor_shaft") == Role::frame);
    CHECK(role_of("rod") == Role::rod);
    CHECK(role_of("tie_rod_front") == Role::frame);
    CHECK(role_of("guide_rod") == Role::frame);
    CHECK(role_of("Stoessel_oben") == Role::slide);
    CHECK(role_of("part_17") == Role::unknown);
    CHECK(material_of("bush_front", Role::frame) == "bronze");
    CHECK(is_ring("bearing_front_inner_ring"));
    CHECK(is_ring("Lager-Innenring"));
    CHECK_FALSE(is_ring("spring_plate"));
    CHECK(material_of("wrist_pin", Role::slide) == "steel");
    CHECK(material_of("slide", Role::slide) == "iron");
}

TEST_CASE("the solids of a press fall into its bodies")
{
    const Draft draft = draft_of(drawing());
    CHECK(draft.bodies.size() == 4);
    CHECK(draft.bodies.front().role == Role::frame);
    // A ring belongs to what it touches, a pin to the slide, whose eyes it touches over more area than the rod.
    CHECK(solids_of(draft, "frame") == std::vector<std::string>{"bearing_back_outer_ring", "bearing_front_outer_ring",
                                                                "bolster", "bracket_left", "bracket_right", "frame",
                                                                "gib_left", "gib_right", "motor", "motor_foot"});
    CHECK(solids_of(draft, "crank") ==
          std::vector<std::string>{"bearing_back_inner_ring", "bearing_front_inner_ring", "crankshaft", "flywheel"});
    CHECK(solids_of(draft, "rod") == std::vector<std::string>{"connecting_rod"});
    CHECK(solids_of(draft, "slide") == std::vector<std::string>{"slide", "wrist_pin"});
}

TEST_CASE("the user says which solids are one body")
{
    const Draft draft = draft_of(drawing(), {{"ram", {"slide"}}, {"shaft", {"crankshaft"}}, {"wheel", {"flywheel"}}});
    CHECK(draft.bodies.size() == 5);
    CHECK(solids_of(draft, "ram") == std::vector<std::string>{"slide", "wrist_pin"});
    CHECK(solids_of(draft, "wheel") == std::vector<std::string>{"flywheel"});
    CHECK(joint(draft, "ram_frame").kind == DraftJoint::Kind::slide);  // a ram is a slide
    CHECK(joint(draft, "wheel_shaft").contacts.size() == 1);           // no longer bonded

    const Draft pinned = draft_of(drawing(), {{"rod", {"connecting_*", "wrist_pin"}}});
    CHECK(pinned.bodies.size() == 4);
    CHECK(solids_of(pinned, "rod") == std::vector<std::string>{"connecting_rod", "wrist_pin"});
    CHECK(solids_of(pinned, "slide") == std::vector<std::string>{"slide"});

    const auto refusal = [](const std::vector<WantedBody>& wanted) {
        try {
            draft_of(drawing(), wanted);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    CHECK(refusal({{"rod", {"con_rod"}}})
              .find("no solid of the drawing is named 'con_rod'\n  help: its solids are frame") != std::string::npos);
    CHECK(refusal({{"rod", {"wrist_pin"}}, {"slide", {"slide", "wrist_*"}}})
              .find("solid 'wrist_pin' is in 'rod' and in 'slide'") != std::string::npos);
}

TEST_CASE("a ball in a socket becomes a ball joint of two bodies")
{
    auto model = drawing();
    for (auto& solid : model.solids) {  // the rod's small end as a ball of 70 mm in the slide, for its wrist pin
        if (solid.name == "connecting_rod" || solid.name == "slide") {
            const bool socket = solid.name == "slide";
            solid.faces.push_back({"", 0.01, machine::CadSphere{{0, -0.4, 0}, 0.035, socket}});
        }
    }
    std::erase_if(model.solids, [](const auto& solid) { return solid.name == "wrist_pin"; });
    const Draft draft = draft_of(model);
    CHECK(draft.bodies.size() == 4);
    CHECK(joint(draft, "slide_rod").kind == DraftJoint::Kind::ball);
    const std::string text = draft_text(draft, "press.step");
    CHECK(text.find("kind = \"ball\"\nbodies = [\"slide\", \"rod\"]\ncentre = [\"0 mm\", \"-400 mm\"]\nball = { "
                    "diameter = \"70 mm\" }") != std::string::npos);
    const ScratchFolder folder;
    std::filesystem::copy_file(press, folder.path / "press.step");
    const auto input = casefile::read_case(folder.file("case.toml", text).string()).value;
    CHECK(input.joints.at("slide_rod").kind == casefile::Joint::Kind::ball);
}

TEST_CASE("joints are where the bodies of a press meet")
{
    const Draft draft = draft_of(drawing());
    REQUIRE(draft.joints.size() == 4);
    CHECK(joint(draft, "crank_frame").contacts.size() == 2);  // both bearings
    CHECK(joint(draft, "crank_frame").rolling);
    CHECK_FALSE(joint(draft, "rod_crank").rolling);
    const auto& bearing = draft.contacts[joint(draft, "crank_frame").contacts.front()];
    CHECK(bearing.diameter == near(0.12, 1e-5));
    CHECK(bearing.clearance == near(0.024, 1e-5));
    CHECK(bearing.area == near(std::numbers::pi * 0.12 * 0.052, 1e-6));
    CHECK(joint(draft, "slide_frame").kind == DraftJoint::Kind::slide);
    CHECK(joint(draft, "slide_frame").contacts.size() == 2);
    const auto& pin = draft.contacts[joint(draft, "rod_crank").contacts.front()];
    CHECK(pin.diameter == near(0.18, 1e-5));
    CHECK(pin.point[1] == near(-0.03, 1e-9));
    CHECK(draft.contacts[joint(draft, "rod_slide").contacts.front()].diameter == near(0.07, 1e-5));
}

TEST_CASE("the crankshaft and the slide of a drawing say where z and up are")
{
    const Draft straight = draft_of(drawing());
    REQUIRE(straight.axes.found);
    CHECK(straight.axes.rows == std::array<Vec3, 3>{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    const Draft draft = draft_of(turned(drawing()));
    REQUIRE(draft.axes.found);
    CHECK(draft.axes.rows == std::array<Vec3, 3>{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}});
    CHECK(draft.joints.size() == 4);
    const auto& pin = draft.contacts[joint(draft, "rod_crank").contacts.front()];
    CHECK(pin.point[1] == near(-0.03, 1e-9));
    // The front view of a drawing looks along -z where y points up; along y where z does, which is here the case's x.
    CHECK(draft_text(straight, "press.step").find("front = \"z\" ") != std::string::npos);
    CHECK(draft_text(draft, "press.step").find("front = \"-x\" ") != std::string::npos);
}

TEST_CASE("two faces of one solid on another have interfaces of two names")
{
    auto model = drawing();
    const auto of = [&](const std::string& name) {
        return std::ranges::find(model.solids, name, &machine::CadSolid::name);
    };
    auto& both = *of("gib_left");  // both gibs as one solid
    const auto& right = *of("gib_right");
    both.faces.insert(both.faces.end(), right.faces.begin(), right.faces.end());
    both.bounds.max = right.bounds.max;
    model.solids.erase(of("gib_right"));
    const ScratchFolder folder;
    std::filesystem::copy_file(press, folder.path / "press.step");
    const auto file = folder.file("case.toml", draft_text(draft_of(model), "press.step"));
    const auto input = casefile::read_case(file.string()).value;
    const auto& interfaces = input.joints.at("slide_frame").interfaces;
    REQUIRE(interfaces.size() == 2);
    CHECK(interfaces[0].name == "slide_gib_left");
    CHECK(interfaces[1].name == "slide_gib_left_2");
}

TEST_CASE("what keeps a drawing from being a press is said")
{
    const auto said = [](const machine::CadModel& model) {
        std::string all;
        for (const auto& doubt : doubts_about(draft_of(model))) {
            all += doubt + "\n";
        }
        return all;
    };
    const auto without = [](const std::string& name) {
        auto model = drawing();
        std::erase_if(model.solids, [&](const auto& solid) { return solid.name == name; });
        return model;
    };
    const auto holds = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
    CHECK(said(drawing()).empty());
    CHECK(draft_of(drawing()).near_misses.empty());

    const auto no_rod = said(without("connecting_rod"));
    CHECK(holds(no_rod, "No solid is a connecting rod by its name: say which with --body rod=SOLID"));
    CHECK_FALSE(holds(no_rod, "No joint"));  // one cause, one sentence
    CHECK(holds(said(without("wrist_pin")), "No joint of rod and slide was found"));

    auto twice = drawing();
    twice.solids.push_back(twice.solids.front());
    twice.solids.back().name = "frame_2";
    CHECK(holds(said(twice), "'frame_2' lies where 'frame' lies"));

    auto sheet = drawing();
    sheet.without_solid = {"cover"};
    CHECK(holds(said(sheet), "'cover' is left out, since it holds surfaces or curves"));
}

TEST_CASE("what would touch if it were drawn a little thinner is listed")
{
    auto model = drawing();
    for (auto& solid : model.solids) {  // a rod whose bore is 0.6 mm too narrow
        for (auto& face : solid.faces) {
            auto* cylinder = std::get_if<machine::CadCylinder>(&face.form);
            if (solid.name == "connecting_rod" && cylinder != nullptr && std::abs(cylinder->radius - 0.09) < 1e-9) {
                cylinder->radius -= 0.3e-3;
            }
        }
    }
    const Draft draft = draft_of(model);
    REQUIRE(draft.near_misses.size() == 1);
    CHECK(draft.near_misses.front().clearance == near(-0.6e-3, 1e-5));
    CHECK(draft_text(draft, "press.step").find("drawn into each other by 0.6 mm: TO DO") != std::string::npos);
}

TEST_CASE("the first case of a drawing is a case")
{
    const ScratchFolder folder;
    std::filesystem::copy_file(press, folder.path / "press.step");
    const auto file = folder.file("case.toml", draft_text(draft_of(drawing()), "press.step"));
    const auto input = casefile::read_case(file.string()).value;
    CHECK(input.parts.size() == 17);
    CHECK(input.bodies.at("frame").ground);
    CHECK(input.parts.at("bearing_back_inner_ring").material == "steel");
    CHECK(input.parts.at("bearing_back_inner_ring").body == "crank");
    CHECK(input.joints.at("crank_frame").elements.size() == 2);
    const auto& bearing = std::get<casefile::PalmgrenFriction>(input.friction.at("crank_frame").law);
    CHECK(bearing.mean_diameter == near(0.1325, 1e-5));  // of 100 and 165 mm
    REQUIRE(input.joints.size() == 4);
    CHECK(input.joints.at("crank_frame").driver);
    CHECK(input.joints.at("rod_slide").centre[1] == near(-0.4, 1e-5));
    CHECK(input.joints.at("slide_frame").centre[1] == near(-0.59, 1e-5));  // gibs from -760 to -420 mm
    CHECK(input.friction.size() == 4);
    // Table top and slide face of the drawing: y of -890 and -780 mm.
    CHECK(*input.surfaces.at("table_top").position == near(-0.89, 1e-5));
    CHECK(*input.surfaces.at("slide_face").position == near(-0.78, 1e-5));
    CHECK(*input.surfaces.at("feet").position == near(-1.1, 1e-5));
}

TEST_CASE("the shipped case of a drawing is what the program writes")
{
    const std::string file = DEADPOINT_SOURCE_DIR "/cases/c-frame/case.toml";
    const std::string text = draft_text(draft_of(drawing()), "press.step");
    if (std::getenv("DEADPOINT_RENEW_DOCS") != nullptr) {
        std::ofstream(file) << text;
    }
    std::ifstream stream(file);
    CHECK(std::string(std::istreambuf_iterator<char>(stream), {}) == text);
}

TEST_CASE("drawn clearances reach the case")
{
    auto model = drawing();
    for (auto& solid : model.solids) {
        for (auto& face : solid.faces) {
            auto* cylinder = std::get_if<machine::CadCylinder>(&face.form);
            if (solid.name == "connecting_rod" && cylinder != nullptr && std::abs(cylinder->radius - 0.09) < 1e-9) {
                cylinder->radius += 0.06e-3;
            }
        }
    }
    const std::string text = draft_text(draft_of(model), "press.step");
    CHECK(text.find("clearance = \"0.06 mm\"   # TO DO: half of the clearance in the drawing") != std::string::npos);
    CHECK(text.find("drawn_gap = \"0.1312 mm\"") != std::string::npos);
    CHECK(text.find("diameter = \"180.12 mm\"") != std::string::npos);
}
