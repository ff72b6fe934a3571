/// Requirement: a run ends with what its user wants first; the rest comes with --verbose.
#include "deadpoint/report/run/run_text.hpp"

#include "everything.hpp"

#include <doctest/doctest.h>
#include <utility>

using namespace everything;

namespace {

bool has(const std::string& text, const std::string& piece) { return text.find(piece) != std::string::npos; }

}  // namespace

TEST_CASE("the short text of a run: gap, causes, warm-up and temperatures, and nothing else")
{
    auto input = case_of_all();
    input.machine.initial_temperature = 293.15;
    input.chain->drift_rate_limit = 1e-6 / 3600;
    auto result = run_of_all(input);
    result.accuracy.reset();
    const auto reduced = *std::exchange(result.reduced, std::nullopt);
    // Its rates are zero at the steps. In the last it moves by 5 um, at 6 s (1 - s) times 0.989 um/h over its share s:
    // at 1 um/h when s = 0.785, 16095 s after the start.
    CHECK(has(run_text(input, result, Detail::short_text),
              "  warm after 4 h 28 min: from then on the gap drifts by less than 1.00 um/h\n"));
    result.drift->gap.rate.assign(3, 1e-9);
    CHECK(run_text(input, result, Detail::short_text) ==
          "\nslider-crank, after 5 h 33 min\n\n"
          "  gap E_SW at the end: +10.0 um (+ opens); largest: +10.0 um after 5 h 33 min\n"
          "  by cause at the end: pin +1.0, motor +1.0, base +1.0 um\n"
          "  what moves the gap at the end: +10 % friction.pin -2.00, +1 K ambient +1.00 um\n"
          "  not warm at the end: the gap still drifts by more than 1.00 um/h\n"
          "  static, apart from heat: 2 um/kN open the gap, 500 kN/mm of solid parts alone\n"
          "    at 20 kN: 40.0 um, left to right +1.0 um/m, front to back -2.0 um/m\n"
          "    elements of first order bend too little: numerics.deformation_order = 2 finds more\n"
          "\n"
          "  probe  rise [K]  published [K]  95 % after\n"
          "  ─────  ────────  ─────────────  ──────────\n"
          "  top        6.85           3.00  4 h 34 min\n"
          "  off by 142.04 K rms; predicting no rise would be off by 3.00 K (a book)\n");
    input.numerics.deformation_order = 2;
    CHECK_FALSE(has(run_text(input, result, Detail::short_text), "elements of first order"));
    result.reduced = reduced;
    CHECK(run_text(input, result, Detail::short_text)
              .ends_with("\ncomputed on a reduced model of 200 states; its error, after the first minute:\n"
                         "  0.020 K, 0.002 um: this run, to a full run\n"
                         "  0.010 K, 0.001 um: this run\n"
                         "  no certified bound: reason\n"
                         "measured when it was built, the gap without the play of the crank's bearings:\n"
                         "  0.100 K, 0.050 um: anywhere in the box\n"
                         "  outside its range: ambient: 25 to 25\n"));
    result.reduced->certified = press::Certified{{}, 2e-7, {{"A", 0.1}, {"B", 0.05}}};
    CHECK(has(run_text(input, result, Detail::short_text),
              "\n  at most 0.2 um of the gap, 0.1 K of probes at the end of the run: certified\n"));
    result.reduced->certified->gap.reset();  // a case without a chain has no gap, and no bound of 0 um
    CHECK(has(run_text(input, result, Detail::short_text),
              "\n  at most 0.1 K of probes at the end of the run: certified\n"));
    result.accuracy = accuracy();
    CHECK(has(run_text(input, result, Detail::short_text), "accuracy of "));  // what was asked for
}

TEST_CASE("the whole text of a run: parts, loads, friction, preload, oil, enclosed air and energy too")
{
    const auto input = case_of_all();
    const auto result = run_of_all(input);
    const auto text = run_text(input, result, Detail::all);
    CHECK(text.starts_with("\nslider-crank, after 5 h 33 min\n\n  gap E_SW at the end"));
    for (const char* piece :
         {"  by part at the end: bed +10.0 um\n", "slide against table", "loads: stroke", "friction heat [W]",
          "held closed", "oil main: ", "air in crank_case: ", "MJ generated", "accuracy of "}) {
        CHECK_MESSAGE(has(text, piece), piece);
    }
}

TEST_CASE("a run without a dimension chain tells of its temperatures alone")
{
    const auto input = case_of_all();
    press::RunResult result;
    result.thermal = thermal();
    result.probes = {{"top", result.thermal.probes[0]}};
    const auto text = run_text(input, result, Detail::short_text);
    CHECK_FALSE(has(text, "E_SW"));
    CHECK(has(text, "  probe  rise [K]"));
    CHECK(has(run_text(input, result, Detail::all), "MJ generated"));
}
