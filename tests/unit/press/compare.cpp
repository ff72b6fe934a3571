#include "deadpoint/press/compare/compare.hpp"

#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::press;
using casefile::ReferenceChain;
using casefile::ReferenceClaim;
using casefile::ReferenceCurve;
using casefile::ReferenceTime;
using Outcome = Verdict::Outcome;

namespace {

/// Two probes and a gap over four hours in rows of half an hour: the shaft is quick, the frame goes straight up, the
/// gap closes to -20 um after one hour and is back at -12 um in the end.
RunRecord record()
{
    RunRecord run;
    run.machine = "two probes";
    run.initial_temperature = 293.15;
    run.probes = {"frame", "shaft"};
    for (int k = 0; k <= 8; ++k) {
        const double t = 1800.0 * k;
        run.time.push_back(t);
        run.rises["frame"].push_back(k);
        run.rises["shaft"].push_back(k < 2 ? 8.0 * k : 16);
        run.chain["E_SW"].push_back(k <= 2 ? -10e-6 * k : -20e-6 + (k - 2) * (8e-6 / 6));
        run.chain["E_BG"].push_back(1e-6 * k);
    }
    run.has_loads = true;
    run.loads = {{"slide.stroke_mm", 80}, {"seat.peak_N", 12000}, {"modes.0", 3}};
    return run;
}

ReferenceClaim claim(ReferenceClaim::Kind kind)
{
    ReferenceClaim c;
    c.text = "said";
    c.kind = kind;
    return c;
}

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

}  // namespace

TEST_CASE("errors: rms, bias, the largest one and both baselines by hand")
{
    // Errors 1, -3, 4; squares 1 + 9 + 16 = 26. References 10, 20, 30: squares 1400; about their mean of 20: 200.
    const auto f = error_figures({11, 17, 34}, {10, 20, 30}, 0.0);
    CHECK(f.count == 3);
    CHECK(f.rms == near(std::sqrt(26.0 / 3), 1e-14));
    CHECK(f.bias == near(2.0 / 3, 1e-14));
    CHECK(f.largest == 4);
    CHECK(f.largest_at == 2);
    CHECK(error_figures({5, 1}, {9, 1}, 0.0).largest == -4);
    CHECK(*f.rms_nothing == near(std::sqrt(1400.0 / 3), 1e-14));
    CHECK(*f.rms_mean == near(std::sqrt(200.0 / 3), 1e-14));
    CHECK_FALSE(error_figures({1, 2}, {1, 2}, std::nullopt).rms_nothing);
    CHECK_FALSE(error_figures({1}, {2}, 0.0).rms_mean);       // of one value, its mean is the value
    CHECK(error_figures({0.08}, {80 * 1e-3}, 0.0).rms == 0);  // what the change of unit leaves is no error
    CHECK_THROWS_AS((void)error_figures({}, {}, 0.0), DomainError);
    CHECK_THROWS_AS((void)error_figures({1}, {1, 2}, 0.0), DomainError);
}

TEST_CASE("values are taken at their time, in the program's sign, and grouped by kind")
{
    casefile::ReferenceFile file;
    file.rises.emplace_back().time = 2700;  // half way between two rows
    file.rises[0].values = {{"frame", 2}, {"shaft", 12}};
    casefile::ReferenceChain chain;
    chain.dimension = "E_SW";
    chain.at = ReferenceChain::At::largest;
    chain.value = 25e-6;
    chain.opposite_sign = true;
    file.chain.push_back(chain);
    chain.at = ReferenceChain::At::end;
    chain.opposite_sign = false;
    chain.value = -12e-6;
    file.chain.push_back(chain);
    auto& peak = file.times.emplace_back();
    peak.of = ReferenceTime::Of::largest_E_SW;
    peak.value = 3000;
    auto& warm = file.times.emplace_back();
    warm.of = ReferenceTime::Of::share_of_rise;
    warm.probe = "shaft";
    warm.value = 3600;
    file.loads.emplace_back().quantity = "slide.stroke_mm";
    file.loads[0].length = 0.079;
    file.loads.emplace_back().quantity = "modes.0";
    file.loads[1].number = 0;

    const auto c = compare(record(), file);
    REQUIRE(c.values.size() == 8);
    CHECK(c.values[0].name == "frame at 0.75 h");
    CHECK(c.values[0].computed == near(1.5, 1e-5));
    CHECK(c.values[0].relative_error() == near(-0.25, 1e-5));
    CHECK(c.values[1].computed == near(12, 1e-5));
    CHECK(c.values[2].computed == near(-20e-6, 1e-5));
    CHECK(c.values[2].reference == near(-25e-6, 1e-5));
    CHECK(c.values[3].error() == near(0, 0, 1e-12));
    CHECK(c.values[4].computed == 3600);
    CHECK(c.values[5].computed == 3600);
    CHECK(c.values[6].error() == near(0.001, 1e-5));                 // 80 mm against 79 mm
    CHECK_FALSE(c.values[7].relative_error());                       // of a reference of 0
    REQUIRE(c.groups.size() == 5);                                   // lengths and numbers of loads.json apart
    CHECK(c.groups[0].figures.rms == near(std::sqrt(0.125), 1e-5));  // errors -0.5 and 0
    CHECK(*c.groups[0].figures.rms_nothing == near(std::sqrt((4 + 144) / 2.0), 1e-5));
    CHECK(*c.groups[1].figures.rms_nothing == near(1e-6 * std::sqrt((25 * 25 + 12 * 12) / 2.0), 1e-5));
    CHECK_FALSE(c.groups[2].figures.rms_nothing);
    CHECK(c.warnings.empty());

    file.rises[0].group = "second reading";
    const auto apart = compare(record(), file);
    CHECK(apart.values[0].group == "second reading");
    CHECK(apart.groups[0].group == "second reading");
    file.rises.push_back(file.rises[0]);
    file.rises[1].group = "";
    CHECK(compare(record(), file).groups.size() == 6);
    file.rises.pop_back();

    auto without = record();
    without.has_loads = false;
    without.loads.clear();
    const auto d = compare(without, file);
    CHECK(d.values.size() == 6);
    REQUIRE(d.warnings.size() == 1);
    CHECK(has(d.warnings[0], "2 figures of loads.json"));
}

TEST_CASE("a rise that the case was fitted to is calibrated, at the same time and in the same case only")
{
    auto run = record();
    run.calibrated_on = {"oil.pins"};
    run.calibrated_time = 7200;
    run.calibrated_probes = {"frame"};
    casefile::ReferenceFile file;
    for (const double time : {7200.0, 3600.0}) {
        file.rises.emplace_back().time = time;
        file.rises.back().values = {{"frame", 4}, {"shaft", 16}};
    }
    const auto status = [&] {
        std::vector<bool> result;
        for (const auto& value : compare(run, file).values) {
            result.push_back(value.calibrated);
        }
        return result;
    };
    CHECK(status() == std::vector<bool>{true, false, false, false});
    CHECK(compare(run, file).groups.size() == 2);
    file.rises[0].point = "elsewhere";
    CHECK(status() == std::vector<bool>{false, false, false, false});
    file.rises[1].calibrated = true;
    CHECK(status() == std::vector<bool>{false, false, true, true});
    run.calibrated_on.clear();
    file.rises[0].point = "";
    CHECK(status() == std::vector<bool>{false, false, true, true});
}

TEST_CASE("curves: temperatures, rises and dimensions against rows of a file")
{
    casefile::ReferenceFile file;
    auto& curve = file.curves.emplace_back();
    curve.measures = ReferenceCurve::Measures::temperature;
    curve.probe = "frame";
    curve.time = {0, 900, 3600};
    curve.value = {293.15, 294.15, 295.15};  // 0, 1 and 2 K; computed 0, 0.5 and 2 K
    auto gap = casefile::ReferenceCurve{};
    gap.measures = ReferenceCurve::Measures::E_SW;
    gap.time = {3600};
    gap.value = {-21e-6};
    file.curves.push_back(gap);
    const auto c = compare(record(), file);
    REQUIRE(c.curves.size() == 2);
    CHECK(c.curves[0].figures.largest == near(-0.5, 1e-9));
    CHECK(c.curves[0].figures.largest_at == 1);
    CHECK(*c.curves[0].figures.rms_nothing == near(std::sqrt(5.0 / 3), 1e-9));
    CHECK(c.curves[1].figures.bias == near(1e-6, 1e-5));
}

TEST_CASE("claims of temperature")
{
    const auto run = record();
    auto c = claim(ReferenceClaim::Kind::hottest);
    c.probes = {"shaft"};
    CHECK(judge(run, c).outcome == Outcome::holds);
    CHECK(has(judge(run, c).evidence, "warmest after 4 h: shaft 16.00 K, frame 8.00 K"));
    c.probes = {"frame"};
    CHECK(judge(run, c).outcome == Outcome::fails);

    c = claim(ReferenceClaim::Kind::warmer);
    c.probes = {"shaft"};
    c.than = {"frame"};
    CHECK(judge(run, c).outcome == Outcome::holds);
    std::swap(c.probes, c.than);
    CHECK(judge(run, c).outcome == Outcome::fails);

    c = claim(ReferenceClaim::Kind::slower);  // 95 %: frame after 4 h, shaft after 1 h
    c.probes = {"frame"};
    c.than = {"shaft"};
    CHECK(judge(run, c).outcome == Outcome::holds);
    CHECK(has(judge(run, c).evidence, "frame 4 h"));
    CHECK(has(judge(run, c).evidence, "shaft 1 h"));
    std::swap(c.probes, c.than);
    CHECK(judge(run, c).outcome == Outcome::fails);

    c = claim(ReferenceClaim::Kind::steady);
    c.at_most = 3.5 * 3600;
    CHECK(judge(run, c).outcome == Outcome::fails);  // the frame is last
    CHECK(has(judge(run, c).evidence, "frame"));
    c.probes = {"shaft"};
    CHECK(judge(run, c).outcome == Outcome::holds);
    c.at_least = 2 * 3600;
    CHECK(judge(run, c).outcome == Outcome::fails);
    c.at_least = 3600;
    CHECK(judge(run, c).outcome == Outcome::holds);

    c = claim(ReferenceClaim::Kind::share_reached);  // after 2 h: frame 50 %, shaft 100 %
    c.probes = {"frame", "shaft"};
    c.time = 2 * 3600;
    c.share = 0.5;
    CHECK(judge(run, c).outcome == Outcome::holds);
    c.share = 0.51;
    CHECK(judge(run, c).outcome == Outcome::fails);
    CHECK(has(judge(run, c).evidence, "frame 50.0 %"));
}

TEST_CASE("claims of the gap")
{
    const auto run = record();
    auto c = claim(ReferenceClaim::Kind::peak_within);
    c.at_most = 3600;
    CHECK(judge(run, c).outcome == Outcome::holds);
    CHECK(has(judge(run, c).evidence, "-20 um, after 1 h"));
    c.at_most = 3500;
    CHECK(judge(run, c).outcome == Outcome::fails);
    CHECK(judge(run, claim(ReferenceClaim::Kind::declines)).outcome == Outcome::holds);
    c = claim(ReferenceClaim::Kind::declines);
    c.share = 0.6;  // 12 of 20 um is not less
    CHECK(judge(run, c).outcome == Outcome::fails);
    c = claim(ReferenceClaim::Kind::slows);
    c.time = 3600;
    CHECK(judge(run, c).outcome == Outcome::holds);
    CHECK(has(judge(run, c).evidence, "-20 um/h on average until 1 h, by +2.667 um/h after"));
    CHECK(judge(run, claim(ReferenceClaim::Kind::closes)).outcome == Outcome::holds);
    CHECK(judge(run, claim(ReferenceClaim::Kind::opens)).outcome == Outcome::fails);
    c = claim(ReferenceClaim::Kind::unchecked);
    c.reason = "takes two runs";
    CHECK(judge(run, c).outcome == Outcome::unchecked);
    CHECK(judge(run, c).evidence == "takes two runs");
}

TEST_CASE("another run as baseline: its values and its errors stand beside")
{
    casefile::ReferenceFile file;
    file.rises.emplace_back().time = 3600;
    file.rises[0].values = {{"frame", 1}, {"shaft", 20}};
    file.loads.emplace_back().quantity = "seat.peak_N";
    file.loads[0].force = 10000;
    auto& curve = file.curves.emplace_back();
    curve.measures = ReferenceCurve::Measures::rise;
    curve.probe = "frame";
    curve.time = {3600};
    curve.value = {1};
    auto other = record();
    other.folder = "other";
    other.has_loads = false;
    for (double& rise : other.rises["frame"]) {
        rise *= 2;
    }
    const auto c = compare(record(), file, "", &other);
    CHECK(c.baseline == "other");
    REQUIRE(c.values.size() == 3);
    CHECK(*c.values[0].baseline == 4);  // twice the 2 K of the run
    CHECK(*c.values[1].baseline == 16);
    CHECK_FALSE(c.values[2].baseline);  // it has no loads
    // Errors of the run: 1 and -4; of the baseline: 3 and -4.
    CHECK(c.groups[0].figures.rms == near(std::sqrt(17.0 / 2), 1e-5));
    CHECK(*c.groups[0].figures.rms_baseline == near(std::sqrt(25.0 / 2), 1e-5));
    CHECK_FALSE(c.groups[1].figures.rms_baseline);
    CHECK(*c.curves[0].figures.rms_baseline == near(3, 1e-5));
    CHECK_FALSE(compare(record(), file).groups[0].figures.rms_baseline);
}

TEST_CASE("agreement: each set once, errors over the measured change, fitted values only where there are no others")
{
    Comparison c;
    CHECK(!agreement(c));
    ComparedGroup group;
    group.figures.rms = 3;
    group.figures.rms_nothing = 10;
    c.groups.push_back(group);
    CHECK(agreement(c)->value == near(0.7, 1e-14));
    ComparedCurve curve;
    curve.figures.count = 1000;
    curve.figures.rms = 4e-6;
    curve.figures.rms_nothing = 10e-6;
    c.curves.push_back(curve);
    // 0.3^2 + 0.4^2 = 0.5^2: sqrt(0.25 / 2) is off.
    CHECK(agreement(c)->value == near(1 - 0.5 / std::sqrt(2.0), 1e-14));
    CHECK(agreement(c)->sets == 2);
    ComparedGroup without;  // times have no "nothing changes"
    without.figures.rms = 100;
    c.groups.push_back(without);
    group.calibrated = true;
    group.figures.rms = 0;
    c.groups.push_back(group);
    CHECK(agreement(c)->sets == 2);
    CHECK(!agreement(c)->calibrated);
    c.groups.erase(c.groups.begin());
    c.curves.clear();
    CHECK(agreement(c)->value == 1);
    CHECK(agreement(c)->calibrated);
}
