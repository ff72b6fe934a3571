#include "deadpoint/crankshaft/shaft/check.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/warning.hpp"
#include "near.hpp"
#include "shafts.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <functional>

using namespace deadpoint;
using namespace deadpoint::crankshaft;

namespace {

/// The message with which a changed shaft is refused; empty if it is not.
std::string refusal(const std::function<void(Shaft&)>& change)
{
    Shaft shaft = shafts::small_shaft();
    change(shaft);
    try {
        check_shaft(shaft);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool warns(const Shaft& shaft, const std::string& part)
{
    const auto warnings = shaft_warnings(shaft);
    return std::any_of(warnings.begin(), warnings.end(),
                       [&](const auto& warning) { return mentions(warning.text, part); });
}

}  // namespace

TEST_CASE("check: a sound shaft passes without warnings")
{
    CHECK(refusal([](Shaft&) {}).empty());
    CHECK(shaft_warnings(shafts::small_shaft()).empty());
    CHECK(shaft_end(shafts::small_shaft()) == near(0.55, 1e-5));
}

TEST_CASE("check: what is wrong is named")
{
    CHECK(mentions(refusal([](Shaft& s) { s.bearings.clear(); }), "has no bearings"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings.pop_back(); }), "bearings at two positions"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[1].position = 0.05; }), "bearings at two positions"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[1].position = 0.56; }),
                   "bearing 'right': at 560 mm it is not on the shaft, which runs from 0 to 550 mm"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[1].position = std::nan(""); }), "bearing 'right'"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[0].stiffness = {}; }), "bearing 'left': the stiffness"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[0].stiffness[0][1] = 1e9; }), "resist motion"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[0].damping[0][0] = -1; }), "the damping"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[0].hertz_exponent = 0.5; }), "exponent"));
    CHECK(mentions(refusal([](Shaft& s) { s.bearings[0].hertz_exponent = 1.1; }), "load at which it was given"));
    CHECK(mentions(refusal([](Shaft& s) { s.disks[0].position = -0.1; }), "disk 1"));
    CHECK(mentions(refusal([](Shaft& s) { s.disks[0].polar_inertia = 3; }), "diametral"));
    CHECK(mentions(refusal([](Shaft& s) { s.unbalances = {{1.0, 0.1, 0}}; }), "unbalance 1"));
    CHECK(mentions(refusal([](Shaft& s) { s.sections[1].diameter = 0; }), "section 2: the diameter"));
    CHECK(mentions(refusal([](Shaft& s) { s.sections[1].bore = 0.12; }), "section 2: the bore"));
    CHECK(mentions(refusal([](Shaft& s) { s.sections[0].length = std::nan(""); }), "section 1: the length"));
    CHECK(mentions(refusal([](Shaft& s) { s.sections.clear(); }), "no sections"));
    CHECK(mentions(refusal([](Shaft& s) { s.youngs_modulus = -1; }), "Young's modulus"));
    CHECK(mentions(refusal([](Shaft& s) { s.modal_damping = 1.2; }), "modal damping"));
}

TEST_CASE("warnings: the paper's pulley is both a disk and a section; without its mass it is still too thick to bend")
{
    Shaft literal = shafts::table1("literal", 5e7);
    literal.modal_damping = 0.02;
    CHECK(warns(literal, "section 17 is 5.71 times"));
    CHECK(warns(literal, "disk 1 (512 kg) is at section 17, which weighs 850.5 kg itself"));
    CHECK(shaft_warnings(literal).size() == 2);
    Shaft middle = shafts::table1("elemmid", 5e7);
    middle.modal_damping = 0.02;
    CHECK(warns(middle, "section 17"));
    CHECK_FALSE(warns(middle, "counts twice"));
}

TEST_CASE("warnings: no damping, and none but the bearings'")
{
    Shaft shaft = shafts::small_shaft();
    shaft.modal_damping = 0;
    CHECK(warns(shaft, "only its bearings damp"));
    for (Bearing& bearing : shaft.bearings)
        bearing.damping = {};
    CHECK(warns(shaft, "nothing damps"));
    shaft.bearings[0].support_stiffness = shafts::isotropic(1e8);
    shaft.bearings[0].support_damping = shafts::isotropic(1e3);
    CHECK(warns(shaft, "only its bearings damp"));
}
