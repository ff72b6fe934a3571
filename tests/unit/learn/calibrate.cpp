/// Requirement: a calibration finds the values that made the data, says what data determine, and does not hide a wrong
/// model in them.
#include "deadpoint/twin/calibrate/calibrate.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/twin/calibrate/calibration_figures.hpp"
#include "deadpoint/twin/calibrate/forward.hpp"
#include "near.hpp"
#include "starter_press.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

using namespace deadpoint;
using namespace deadpoint::press;
using namespace deadpoint::twin;
using namespace deadpoint::full;
using casefile::CalibrationFile;
using casefile::CalibrationParameter;
using casefile::CalibrationRun;

namespace {

constexpr double noise = 0.05;  // [K]

CalibrationParameter factor(const std::string& name, const std::vector<std::string>& patterns, double uncertainty)
{
    CalibrationParameter result;
    result.name = name;
    result.keys = keys_of(starter_press::input(), patterns, name);
    result.prior = std::log(uncertainty);
    result.place = "c.toml:1";
    return result;
}

/// A run whose data are those of a case with these values, with noise.
CalibrationRun measured(const CalibrationFile& file, const std::vector<std::string>& set,
                        const std::vector<double>& truth, const std::vector<std::string>& outputs, unsigned seed,
                        const std::vector<std::string>& other_laws = {})
{
    CalibrationRun run;
    run.name = "run " + std::to_string(seed);
    run.input = std::make_shared<casefile::Case>(starter_press::input(set));
    auto true_set = set;
    true_set.insert(true_set.end(), other_laws.begin(), other_laws.end());
    std::vector<CaseParameter> parameters;
    for (const auto& p : file.parameters)
        parameters.push_back({p.name, p.keys, CaseParameter::Kind::factor});
    Observer quiet;
    const ForwardModel model(starter_press::input(true_set), starter_press::press(), parameters, {120, 1, nullptr});
    const auto found = model.run(truth, false, quiet);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (std::size_t o = 0; o < model.outputs().size(); ++o) {
        const auto& output = model.outputs()[o];
        if (std::ranges::find(outputs, output.name) == outputs.end())
            continue;
        casefile::MeasuredCurve curve{
            output.name, output.name, output.kind == ForwardOutput::Kind::dimension, false, 0, {}, {}, "log.csv"};
        curve.sensor = curve.of_gap ? 1 : 0;
        for (std::size_t row = 2; row < found.time.size(); row += 2) {
            curve.time.push_back(found.time[row]);
            curve.value.push_back(found.value[o][row] + (curve.of_gap ? 2e-7 : noise) * normal(random));
        }
        run.curves.push_back(std::move(curve));
    }
    return run;
}

CalibrationFile file_of(const std::vector<CalibrationParameter>& parameters)
{
    CalibrationFile file;
    file.name = "test";
    file.parameters = parameters;
    file.sensors.resize(2);
    file.sensors[0].sigma = noise;
    file.sensors[0].dimension = Dimension::temperature_difference;
    file.sensors[1].sigma = 2e-7;
    file.sensors[1].dimension = Dimension::length;
    file.options.starts = 2;
    file.options.profiles = false;
    return file;
}

CalibrationFile two_unknowns()
{
    return file_of({factor("friction", {"friction.*.viscous_part", "friction.*.load_part"}, 2),
                    factor("air", {"surfaces.air_*.film.coefficient"}, 2)});
}

/// The press without its stated error, which here compares the model with itself.
const ReducedPress& exact_press()
{
    static const auto press = [] {
        auto result = starter_press::press();
        result.errors.clear();
        return result;
    }();
    return press;
}

Calibration calibrated(const CalibrationFile& file)
{
    Observer quiet;
    return calibrate(file, exact_press(), {}, 2, quiet).value();
}

}  // namespace

TEST_CASE("the values that made the data lie within the intervals, and held-out data within the bands")
{
    auto file = two_unknowns();
    const std::vector<double> truth{0.3, -0.4};
    file.runs.push_back(measured(file, {}, truth, {"slide", "bearing_front", "upright", "E_SW"}, 1));
    file.runs.push_back(measured(file, {"operation.0.speed=90 rpm"}, truth, {"slide", "upright"}, 2));
    file.runs.back().hold_out = true;
    file.options.profiles = true;
    const auto found = calibrated(file);
    CHECK(found.converged);
    CHECK_FALSE(found.model_differs);
    REQUIRE(found.parameters.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        const auto& p = found.parameters[k];
        // 4 standard deviations: a probability of 6e-5 to fail by chance.
        CHECK(std::abs(p.theta - truth[k]) < 4 * p.deviation);
        CHECK(p.estimate == near(std::exp(p.theta), 1e-5));
        CHECK(p.by_profile);
        CHECK(p.lower < p.estimate);
        CHECK(p.upper > p.estimate);
        // Nearly linear: the profile is that of the normal distribution to a tenth.
        CHECK(std::log(p.upper) - p.theta == near(1.645 * p.deviation, 0.1));
    }
    CHECK(found.parameters[0].shrinkage > 0.9);
    CHECK(found.after.front().known == Knowledge::data);
    for (const auto& curve : found.curves) {
        CHECK(curve.rms < 1.5 * (curve.of_gap ? 2e-7 : noise));
        CHECK(curve.inside > 0.6);
        CHECK(curve.rms_before > curve.rms);
        CHECK(curve.hold_out == (curve.run == "run 2"));
        CHECK(curve.rms_mean.has_value() == curve.hold_out);  // one run is fitted
    }
    CHECK(found.predictions.size() == 2);
    CHECK(found.settings.size() == file.parameters[0].keys.size() + file.parameters[1].keys.size());
    CHECK(found.cost < found.cost_before);
}

TEST_CASE("biases and lags of sensors are found beside the unknowns of the case")
{
    auto file = two_unknowns();
    file.parameters.pop_back();
    file.sensors[0].bias_sigma = 1;
    file.runs.push_back(measured(file, {}, {0.2}, {"slide", "bearing_front"}, 3));
    for (double& value : file.runs.front().curves.front().value)
        value += 0.7;  // of the slide's or the bearing's sensor, the first in the order of outputs
    const auto biased = file.runs.front().curves.front().output;
    const auto found = calibrated(file);
    const auto bias = std::ranges::find(found.parameters, "bias of " + biased, &FittedParameter::name);
    REQUIRE(bias != found.parameters.end());
    CHECK(bias->unit == "K");
    CHECK(std::abs(bias->estimate - 0.7) < 4 * bias->deviation);
    CHECK(bias->deviation < 0.1);
    CHECK(std::abs(found.parameters[0].theta - 0.2) < 4 * found.parameters[0].deviation);
    CHECK(found.parameters[0].values.size() == file.parameters[0].keys.size());
    CHECK(bias->values.empty());
}

TEST_CASE("a wrong law is reported, and intervals grow with it")
{
    auto right = two_unknowns(), wrong = right;
    right.runs.push_back(measured(right, {}, {0.1, 0.1}, {"slide", "bearing_front", "upright"}, 4));
    // The truth has oil that takes the pins' heat, which the case's oil does by far less.
    wrong.runs.push_back(measured(wrong, {}, {0.1, 0.1}, {"slide", "bearing_front", "upright"}, 4,
                                  {"oil.pins=3000 W/m^2/K", "oil.gibs=2000 W/m^2/K"}));
    wrong.runs.back().name = "other laws";
    const auto good = calibrated(right), bad = calibrated(wrong);
    CHECK_FALSE(good.model_differs);
    CHECK(bad.model_differs);
    CHECK(bad.parameters[0].deviation > 2 * good.parameters[0].deviation);
    // Nothing is called known by data that contradict the model.
    const auto by_data = [](const auto& one) { return one.known == Knowledge::data; };
    const auto if_right = [](const auto& one) { return one.known == Knowledge::if_model_right; };
    CHECK(std::ranges::any_of(good.parameters, by_data));
    CHECK(std::ranges::any_of(good.after, by_data));
    CHECK(std::ranges::none_of(good.parameters, if_right));
    CHECK(std::ranges::none_of(bad.parameters, by_data));
    CHECK(std::ranges::none_of(bad.after, by_data));
    CHECK(std::ranges::none_of(bad.before, by_data));
    CHECK(std::ranges::any_of(bad.after, if_right));
    CHECK(std::ranges::any_of(bad.warnings, [](const auto& text) { return text.find("do not explain") != text.npos; }));
    CHECK(std::ranges::any_of(bad.curves, [](const auto& curve) { return curve.model_error > noise; }));
}

TEST_CASE("a shrinkage is knowledge only where the model explains the data")
{
    CHECK(knowledge_of(0.9, false) == Knowledge::data);
    CHECK(knowledge_of(0.89, false) == Knowledge::partly);
    CHECK(knowledge_of(0.19, false) == Knowledge::prior);
    CHECK(knowledge_of(0.99, true) == Knowledge::if_model_right);
    CHECK(knowledge_of(0.2, true) == Knowledge::if_model_right);
    CHECK(knowledge_of(0.19, true) == Knowledge::prior);
}

TEST_CASE("a calibration that is told to stop ends without a result, also within a run")
{
    class Stopping : public Observer {
    public:
        explicit Stopping(int asked) : left_(asked) {}
        [[nodiscard]] bool cancelled() const override { return --left_ < 0; }

    private:
        mutable std::atomic<int> left_;
    };
    auto file = two_unknowns();
    file.runs.push_back(measured(file, {}, {0.1, 0.1}, {"slide", "bearing_front", "upright"}, 4));
    for (const int asked : {0, 5, 100}) {
        Stopping observer(asked);
        CHECK_FALSE(calibrate(file, exact_press(), {}, 2, observer).has_value());
    }
    Stopping observer(0);
    CHECK_FALSE(plan_calibration(file, exact_press(), {}, 2, observer).has_value());
}

TEST_CASE("a model error that is stated beforehand widens intervals although the residuals look right")
{
    auto file = two_unknowns();
    file.runs.push_back(measured(file, {}, {0.1, 0.1}, {"slide", "bearing_front", "upright"}, 8));
    const auto perfect = calibrated(file);
    file.sensors[0].model_sigma = 10 * noise;
    const auto careful = calibrated(file);
    CHECK_FALSE(careful.model_differs);
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(careful.parameters[k].deviation > 3 * perfect.parameters[k].deviation);
}

namespace {

/// Data with other laws, and a calibration that allows for them by an alternative of this share.
CalibrationFile with_alternative(double share)
{
    const std::vector<std::string> laws{"oil.pins=3000 W/m^2/K", "oil.gibs=2000 W/m^2/K"};
    auto file = two_unknowns();
    file.runs.push_back(measured(file, {}, {0.1, 0.1}, {"slide", "bearing_front", "upright"}, 4, laws));
    file.alternatives = {{"more oil", "", laws, share, "c.toml:20"}};
    file.runs.back().alternatives = {std::make_shared<casefile::Case>(starter_press::input(laws))};
    return file;
}

}  // namespace

TEST_CASE("an alternative takes up what the model lacks, and says so, in place of the unknowns")
{
    auto file = with_alternative(0);
    const auto found = calibrated(file);
    CHECK_FALSE(found.model_differs);
    REQUIRE(found.parameters.size() == 3);
    const auto& share = found.parameters[2];
    CHECK(share.kind == FittedParameter::Kind::alternative);
    // The data have all of the difference: a share of 1, and the unknowns are right.
    CHECK(std::abs(share.theta - 1) < 4 * share.deviation);
    CHECK(share.deviation < 0.2);
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(std::abs(found.parameters[k].theta - 0.1) < 4 * found.parameters[k].deviation);
    // The predicted course has the share in it, as the measured values have.
    const auto& slide = found.predictions.front().curves;
    const auto at = std::ranges::find(slide, found.curves.front().output, &PredictedCurve::output);
    CHECK(std::abs(at->value.back() - found.curves.front().measured.back()) < 5 * noise);
    // Half of the share's deviation: the same error is twice as many of them.
    file = with_alternative(0.5);
    CHECK(calibrated(file).parameters[2].theta == near(2 * share.theta, 0.1));
}

TEST_CASE("the error of a mesh is by the cell sizes of two: of first order")
{
    auto file = with_alternative(0);
    auto coarser = std::make_shared<ReducedPress>(exact_press());
    coarser->cells = exact_press().cells * 8 / 27;  // cells of one and a half times the size: h / (1.5 h - h) = 2
    Observer quiet;
    const auto found = calibrate(file, exact_press(), {coarser}, 2, quiet).value();
    CHECK(found.parameters[2].theta == near(0.5, 0.1));  // twice the difference, of which the data have one
    coarser->cells = exact_press().cells * 9 / 10;
    CHECK_THROWS_WITH_AS((void)calibrate(file, exact_press(), {coarser}, 2, quiet),
                         doctest::Contains("c.toml:20: the alternative 'more oil' has nearly the same mesh"),
                         InputError);
}

TEST_CASE("an alternative that changes nothing is refused with its place")
{
    auto file = with_alternative(0);
    file.runs.back().alternatives = {file.runs.back().input};
    CHECK_THROWS_WITH_AS(calibrated(file),
                         doctest::Contains("c.toml:20: the alternative 'more oil' changes no measured"), InputError);
}

TEST_CASE("a parameter without influence is refused with its place")
{
    auto file = two_unknowns();
    file.parameters.push_back(factor("play", {"joints.crank_bearing.clearance"}, 2));
    file.parameters.back().place = "c.toml:12";
    file.runs.push_back(measured(file, {}, {0, 0, 0}, {"slide"}, 5));
    CHECK_THROWS_WITH_AS(calibrated(file), doctest::Contains("c.toml:12: the parameter 'play' has no influence"),
                         InputError);
}

TEST_CASE("samples of the posterior agree with the normal distribution about the fit")
{
    auto file = two_unknowns();
    file.runs.push_back(measured(file, {}, {0.2, 0.1}, {"slide", "bearing_front", "upright"}, 6));
    file.options.samples = 20000;
    const auto found = calibrated(file);
    REQUIRE(found.samples);
    CHECK(found.samples->surrogate_error < 0.05);
    for (std::size_t k = 0; k < 2; ++k) {
        // 20 000 correlated draws: quantiles to some percent of the interval's width.
        const double width = found.parameters[k].upper - found.parameters[k].lower;
        CHECK(std::abs(found.samples->intervals[k].first - found.parameters[k].lower) < 0.15 * width);
        CHECK(std::abs(found.samples->intervals[k].second - found.parameters[k].upper) < 0.15 * width);
    }
}

TEST_CASE("a plan foretells what the fit then determines, and what a further sensor adds")
{
    auto file = two_unknowns();
    file.runs.push_back(measured(file, {}, {0, 0}, {"slide"}, 7));
    casefile::CalibrationCandidate bearing, twice;
    bearing.name = "bearing";
    bearing.measure = {"bearing_front"};
    twice.name = "faster";
    twice.set = {"operation.0.speed=90 rpm"};
    twice.input = std::make_shared<casefile::Case>(starter_press::input({"operation.0.speed=90 rpm"}));
    file.candidates = {bearing, twice};
    Observer quiet;
    const auto plan = plan_calibration(file, exact_press(), {}, 2, quiet).value();
    const auto fit = calibrated(file);
    for (std::size_t k = 0; k < 2; ++k)
        CHECK(plan.parameters[k].shrinkage == near(fit.parameters[k].expected, 1e-9));
    REQUIRE(plan.candidates.size() == 2);
    CHECK(plan.candidates[0].information >= plan.candidates[1].information);

    // What the bearing adds is what a plan with it has in addition: ln det of both covariances.
    auto more = file;
    auto run = more.runs.front();
    run.name = "also";
    casefile::MeasuredCurve curve{"bearing_front", "bearing_front", false, false, 0, {}, {}, {}};
    for (int k = 1; k <= 6; ++k)
        curve.time.push_back(600.0 * k);
    run.curves = {curve};
    more.runs.push_back(run);
    const auto with = plan_calibration(more, exact_press(), {}, 2, quiet).value();
    const auto log_det = [](const CalibrationPlan& of) {
        double sum = 0;
        for (const auto& c : of.combinations)
            sum += std::log(1 + c.singular_value * c.singular_value);
        return 0.5 * sum;
    };
    const auto gain = std::ranges::find(plan.candidates, "bearing", &CandidateGain::name)->information;
    CHECK(gain == near(log_det(with) - log_det(plan), 1e-6));
}
