#include "deadpoint/press/result/sensitivities.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/report/run/sensitivities_text.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <iterator>

using namespace deadpoint;

namespace {

press::Sensitivities at_end()
{
    return {7200,
            true,
            {"A", "B"},
            {{"operation.speed", 200, "rpm", 20, -0.45e-6, {0.1, 0.04}},
             {"oil temperature", 20, "degC", 1, -3.4e-6, {0.5, -0.7}},
             {"friction.pin", 1, "", 0.1, 4e-6, {1, 2}}}};
}

}  // namespace

TEST_CASE("sensitivities in a line: a tenth more of coefficients, 1 K more of temperatures")
{
    CHECK(report::sensitivities_line(at_end()) ==
          "  what moves the gap at the end: +10 % operation.speed -9.00, +1 K oil "
          "temperature -3.40, +10 % friction.pin +0.40 um\n");
    auto without_chain = at_end();
    without_chain.has_gap = false;
    CHECK(report::sensitivities_line(without_chain) ==
          "  what moves the probes at the end: +10 % operation.speed +2.00, +1 K oil temperature -0.70, +10 % "
          "friction.pin +0.20 K\n");
}

TEST_CASE("sensitivities in a table and in JSON, with E_SW in micrometres")
{
    const ScratchFolder folder;
    const auto path = folder.path / "sensitivities.csv";
    const std::vector<std::string> comments{"made up"};
    report::write_sensitivities(path, comments, at_end());
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    CHECK(text == "# made up\n"
                  "# columns: coefficient, value, unit, change, gap_per_unit, gap_effect, probe_per_unit, "
                  "probe_effect, probe_per_unit, probe_effect\n"
                  "coefficient,value,unit,change,E_SW per unit [um],E_SW by change [um],A per unit [K],A by change "
                  "[K],B per unit [K],B by change [K]\n"
                  "operation.speed,200,rpm,20,-0.45,-9,0.1,2,0.04,0.8\n"
                  "oil temperature,20,degC,1,-3.4,-3.4,0.5,0.5,-0.7,-0.7\n"
                  "friction.pin,1,,0.1,4,0.4,1,0.1,2,0.2\n");
    const auto json = report::sensitivities_json(at_end());
    CHECK(json["time_s"] == 7200);
    CHECK(json["strongest"].size() == 3);
    CHECK(json["strongest"][1]["largest_probe_K"].get<double>() == near(-0.7, 1e-5));
    CHECK(json["strongest"][0]["E_SW_um"].get<double>() == near(-9, 1e-5));
}
