/// Requirement: files and texts of a calibration show what it found, in the units that people read, and say in words
/// what data determine.
#include "../../scratch_folder.hpp"
#include "calibration_of_all.hpp"
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/report/calibration/calibration_files.hpp"
#include "near.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace deadpoint;
using namespace everything;

namespace {

bool has(const std::string& text, const std::string& piece)
{
    if (text.find(piece) != std::string::npos)
        return true;
    MESSAGE(text);
    return false;
}

}  // namespace

TEST_CASE("tables hold lengths in micrometres and temperatures in degrees where they are predicted")
{
    const ScratchFolder folder;
    report::write_calibration_files(folder.path, calibration_of_all());
    CHECK(has(content(folder.path / "parameters.csv"), "bias of E_SW,bias,um,2,1,3,"));
    CHECK(has(content(folder.path / "residuals.csv"), "slow,top,K,no,3600,303,302,297,301,303.5"));
    CHECK(has(content(folder.path / "residuals.csv"), "fast,E_SW,um,yes,3600,303,302,297,301,303.5"));
    CHECK(has(content(folder.path / "prediction_slow.csv"), "time [s],top [degC],top lower [degC]"));
    CHECK(has(content(folder.path / "prediction_slow.csv"), "\n0,20,19.85,20.85,20\n"));
    CHECK(has(content(folder.path / "prediction_fast_run.csv"), "\n60,2,1,3,1\n"));
    CHECK(has(content(folder.path / "posterior.csv"), "\n1,2,3\n"));
    const auto json = nlohmann::json::parse(content(folder.path / "calibration.json"));
    CHECK(json["curves"][1]["rms"] == near(0.7, 1e-5));
    CHECK(json["full_run"]["difference_um"] == near(0.1, 1e-5));
}

TEST_CASE("the calibrated values are a file that a case includes")
{
    const ScratchFolder folder;
    auto found = calibration_of_all();
    found.settings = {R"(operation.0.speed="90.0 rpm")"};
    report::write_calibration_files(folder.path, found);
    std::filesystem::copy_file(std::filesystem::path(DEADPOINT_SOURCE_DIR) / "cases/starter/case.toml",
                               folder.path / "base.toml");
    const auto with = folder.file("with.toml", "include = [\"base.toml\", \"calibrated.toml\"]\n");
    const auto set = casefile::read_case(folder.path / "base.toml", found.settings).value;
    CHECK(casefile::case_hash(casefile::read_case(with).value) == casefile::case_hash(set));
    CHECK(set.operation.front().speed == near(90 * 2 * 3.14159265358979 / 60, 1e-5));
}

TEST_CASE(
    "the text says what is prior only, that the model is wrong, and that the data determine nothing for this reason")
{
    const auto text = report::calibration_text(calibration_of_all());
    CHECK(text.find("Known by the data") == std::string::npos);
    CHECK(has(text, "Fixed by these data only if the model were right, which they contradict: pins, bias of E_SW."));
    CHECK(has(text, "Prior only, that is as uncertain as before: gibs."));
    CHECK(has(text, "If the model were right, the data would determine 1 of 2 combinations of the unknowns: pins."));
    CHECK(has(text, "The data would leave one as it was assumed: gibs"));
    CHECK(has(text, "The model does not explain the data within the stated errors (probability 0.001)."));
    CHECK(has(text, "top in slow (0.50 K)"));
    CHECK(has(
        text,
        "Held-out dimensions: 0.700 um rms, 4.00 with the unchanged case, 7.00 if nothing changed; 100 % of 2 values"));
    CHECK(has(text, "A full run of the calibrated case differs by at most 0.020 K and 0.10 um"));
    auto right = calibration_of_all();
    right.model_differs = false;
    right.parameters.front().known = right.after.front().known = twin::Knowledge::data;
    const auto of_right = report::calibration_text(right);
    CHECK(has(of_right, "the data do not contradict the model"));
    CHECK(has(of_right, "Known by the data: pins."));
    CHECK(has(of_right, "The data determine 1 of 2 combinations of the unknowns: pins."));
}

TEST_CASE("files say of each unknown and combination what is known of it, in the words of the text")
{
    const ScratchFolder folder;
    report::write_calibration_files(folder.path, calibration_of_all());
    const auto json = nlohmann::json::parse(content(folder.path / "calibration.json"));
    CHECK(json["parameters"][0]["known"] == "only if the model were right");
    CHECK(json["parameters"][1]["known"] == "prior only");
    CHECK(json["combinations"][0]["known"] == "only if the model were right");
    CHECK(has(content(folder.path / "parameters.csv"), ",0.95,only if the model were right,"));
    CHECK(has(content(folder.path / "combinations.csv"), "\npins,12,only if the model were right,1,0,0\n"));
}

TEST_CASE("shares of alternatives are told apart from unknowns: those that the data need, and those that they do not")
{
    auto found = calibration_of_all();
    auto mesh = factor_of("coarser mesh", 0.2, 0.95), films = factor_of("films by law", 0.9, 0.95);
    for (auto* p : {&mesh, &films}) {
        p->kind = twin::FittedParameter::Kind::alternative;
        p->unit = "share";
    }
    mesh.lower = -0.3;
    mesh.upper = 0.7;
    films.lower = 0.8;
    films.upper = 1;
    found.parameters = {factor_of("pins", 1.1, 0.95), mesh, films};
    const auto text = report::calibration_text(found);
    CHECK(has(text, "Known by the data: pins.\n"));
    CHECK(has(text, "The data ask for 0.900 (0.800 to 1.00) times the error that 'films by law' allows for"));
    CHECK(has(text,
              "Model errors that were allowed for, and of which the data need none: coarser mesh (-0.300 to 0.700)."));
}

TEST_CASE("a page of a plan holds its figures and, without scripts, its text")
{
    const ScratchFolder folder;
    report::write_plan_page(folder.path / "report.html", plan_of_all());
    const auto page = content(folder.path / "report.html");
    CHECK(has(page, "sensor at gib"));
    CHECK(has(page, "\"information_nat\":1.5"));
    CHECK(has(page, "Most would be gained by"));
    report::write_plan_files(folder.path, plan_of_all());
    CHECK(has(content(folder.path / "candidates.csv"), "sensor at gib,1.5,gibs,0.3"));
}

TEST_CASE("a plan says what would help most")
{
    const auto text = report::calibration_text(plan_of_all());
    CHECK(has(text, "The data will determine 1 of 2 combinations"));
    CHECK(has(text, "Most would be gained by 'sensor at gib' (1.50 nat), which tells most about 'gibs': its standard "
                    "deviation falls to 30 %."));
}
