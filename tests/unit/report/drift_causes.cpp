#include "../../scratch_folder.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/report/run/drift_causes_text.hpp"
#include "near.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

DriftCauses at_end()
{
    DriftCauses causes;
    causes.time = 7200;
    causes.joints = {{"crank_pin", -20.04e-6}, {"guide", 3e-6}};
    causes.heat_sources = {{"motor", 0.01e-6}};
    causes.surfaces = {{"base", -1e-6}};
    causes.oil = 4.5e-6;
    causes.air = 0.24e-6;
    causes.remainder = -0.02e-6;
    causes.gap = -13.3e-6;
    return causes;
}

}  // namespace

TEST_CASE("causes of the drift in a line: strongest first, nothing that would read 0.0")
{
    CHECK(report::drift_causes_line({at_end()}) ==
          "  by cause at the end: crank_pin -20.0, oil +4.5, guide +3.0, base -1.0, air +0.2 um\n");
    CHECK(report::drift_causes_line({}).empty());
}

TEST_CASE("causes of the drift in JSON and CSV, in micrometres")
{
    auto before = at_end();
    before.time = 3600;
    before.joints[0].second = -10e-6;
    const auto json = report::drift_causes_json({before, at_end()});
    REQUIRE(json.size() == 2);
    CHECK(json[0]["time_s"] == 3600);
    CHECK(json[0]["friction"]["crank_pin"].get<double>() == near(-10, 1e-5));
    CHECK(json[1]["heat source"]["motor"].get<double>() == near(0.01, 1e-5));
    CHECK(json[1]["surface"]["base"].get<double>() == near(-1, 1e-5));
    CHECK(json[1]["oil"].get<double>() == near(4.5, 1e-5));

    const ScratchFolder folder;
    const std::vector<std::string> comments{"a comment"};
    report::write_drift_causes(folder.path / "causes.csv", comments, {before, at_end()});
    CHECK(content(folder.path / "causes.csv") ==
          "# a comment\n"
          "# columns: cause, name, share, share\n"
          "cause,name,share of E_SW after 3600 s [um],share of E_SW after 7200 s [um]\n"
          "friction,crank_pin,-10,-20.04\n"
          "friction,guide,3,3\n"
          "heat source,motor,0.01,0.01\n"
          "surface,base,-1,-1\n"
          "oil,,4.5,4.5\n"
          "air,,0.24,0.24\n"
          "start,,0,0\n"
          "remainder,,-0.02,-0.02\n");
}
