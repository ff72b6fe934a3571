#include "deadpoint/full/run/run.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>
#include <numeric>

// What the play of the crank's bearings makes of the gap, on the starter press with a shaft that expands three times as
// much as its bushes.

using namespace deadpoint;
using verification::Case;

namespace {

struct Warnings : Observer {
    std::vector<std::string> texts;
    void warn(std::string_view text) override { texts.emplace_back(text); }
    [[nodiscard]] std::string about_play() const
    {
        std::string all;
        for (const auto& text : texts)
            if (text.find("the play of the bearings") != std::string::npos)
                all += text;
        return all;
    }
};

Case starter(const std::vector<std::string>& more = {})
{
    std::vector<std::string> overrides{"operation.0.duration=20 min", "numerics.time_tolerance=0.1 K",
                                       "numerics.max_step=5 min",     "materials.steel.expansion=3.6e-5 1/K",
                                       "output.field_times=[]",       "joints.crank_bearing.clearance=1 m"};
    overrides.insert(overrides.end(), more.begin(), more.end());
    return verification::read("../../../cases/starter/case", overrides);
}

struct Runs {
    Warnings observer;
    Machine machine = full::prepare_machine(starter(), 3, observer);
    full::SharedModel model{machine};

    press::RunResult run(const Case& input)
    {
        observer.texts.clear();
        full::RunOptions options;
        options.causes = true;
        return model.run(input, options, observer);
    }
};

double sum_by_part(const DriftSeries& drift, std::size_t row)
{
    return std::accumulate(drift.by_part.begin(), drift.by_part.end(), 0.0,
                           [row](double sum, const auto& part) { return sum + part[row]; });
}

}  // namespace

TEST_CASE("play of the crank's bearings: none, all of it, or until it is used up")
{
    Runs runs;
    const auto whole = runs.run(starter({"chain.bearing_play=paper"}));
    const auto& followed = whole.drift->clearance.value;
    // The bushes close: the crank, pressed upwards, comes down in them, and the slide with it, metre for metre.
    const double closed = followed.back();
    REQUIRE(closed > 4e-6);
    CHECK(runs.observer.about_play().empty());

    const auto none = runs.run(starter({"chain.bearing_play=none"}));
    CHECK(none.drift->clearance.value.back() == 0);
    CHECK(runs.observer.about_play().empty());

    // Half of that for the play on the radius, which a diameter has twice: the crank follows so far and no further.
    auto limited_case = starter();
    limited_case.joints.at("crank_bearing").clearance = closed;
    const auto limited = runs.run(limited_case);
    const auto& drift = *limited.drift;
    REQUIRE(drift.time.size() == whole.drift->time.size());
    bool used_up = false;
    for (std::size_t i = 0; i < drift.time.size(); ++i) {
        CAPTURE(i);
        // both bushes warm alike, within a few per cent: the second is used up a little later
        const double expected = std::min(followed[i], 0.5 * closed);
        const double ambiguous = std::abs(followed[i] - 0.5 * closed) < 0.1 * closed ? 0.05 * closed : 0;
        CHECK(std::abs(drift.clearance.value[i] - expected) <= ambiguous + 1e-12);
        const double rounding = 1e-9 * std::abs(drift.gap.value.back());
        CHECK(std::abs(drift.gap.value[i] - none.drift->gap.value[i] + drift.clearance.value[i]) <= rounding);
        CHECK(std::abs(drift.gap.value[i] - (drift.bearing_to_ground.value[i] - drift.table_to_ground.value[i] -
                                             drift.crank_to_slide.value[i] - drift.clearance.value[i])) <= rounding);
        CHECK(std::abs(sum_by_part(drift, i) - drift.gap.value[i]) <= rounding);
        used_up = used_up || followed[i] > 0.6 * closed;
    }
    CHECK(used_up);
    CHECK(drift.clearance.rate.back() == 0);
    CHECK(drift.play.value.back() == near(-0.5 * closed, 1e-9));
    // all corners go with the slide
    const auto corner = [](const press::RunResult& result) {
        return result.gaps.parallelism->corners[2].gap.value.back();
    };
    CHECK(corner(limited) - corner(none) == near(-0.5 * closed, 1e-6));
    CHECK(limited.adjoint_check->by_adjoint == near(limited.adjoint_check->by_deformation, 1e-7));
    CHECK(limited.adjoint_check->joint_opening < 1e-9 * closed);
    // The causes are those of the gap with what counts of the play: the films of the starter radiate, hence a
    // remainder.
    for (const auto* result : {&whole, &none, &limited}) {
        const auto& causes = result->causes.back();
        CHECK(causes.gap == result->drift->gap.value.back());
        CHECK(std::abs(causes.remainder) < 0.01 * std::abs(causes.gap));
    }
}

TEST_CASE("play that no case states: plain bearings follow it, rolling ones do not, and both are told with the effect")
{
    Runs runs;
    auto plain_case = starter();
    plain_case.joints.at("crank_bearing").clearance.reset();
    const auto plain = runs.run(plain_case);
    CHECK(plain.drift->clearance.value.back() > 4e-6);
    CHECK(runs.observer.about_play().find("all of it counts") != std::string::npos);
    CHECK(runs.observer.about_play().find("joints.crank_bearing.clearance") != std::string::npos);

    auto rolling_case = plain_case;
    std::get<casefile::CalibratedFriction>(rolling_case.friction.at("journals").law).kind = FrictionKind::rolling;
    const auto rolling = runs.run(rolling_case);
    CHECK(rolling.drift->clearance.value.back() == 0);
    CHECK(runs.observer.about_play().find("none of it counts") != std::string::npos);

    auto element_case = plain_case;
    element_case.joints.at("crank_bearing").elements = {
        {"front", deadpoint::casefile::JointElement::Type::rolling, 0, 0, 0}};
    CHECK(runs.run(element_case).drift->clearance.value.back() == 0);
}
