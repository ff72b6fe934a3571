#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/calibration_file.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/study/learn/calibrate.hpp"
#include "deadpoint/study/learn/forward.hpp"
#include "deadpoint/study/reduce/reduced_press.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>

// Whether intervals of calibrate hold the truth as often as they say, and whether it notices a wrong model:
//   benchmark_calibration_coverage case.toml model.rom finer.rom draws [line]
// The truths are drawn from the prior and computed on the reduced press of a finer mesh. Each is fitted by the first
// one to a warm-up, which then predicts a duty cycle of other speeds and stops that was held out.
//   same laws:    the truth has the model's laws
//   other films:  natural convection and radiation by law in place of the model's constant films
//   wrong law:    oil takes heat from pins and guides, which the model's press does not have
// Prints for each the share of true values in their 90 % intervals, how often the model was called wrong, and how far
// the duty cycles are off: temperatures [K], and the gap as a share of its range over each cycle, root mean squares
// over all draws.

namespace {

using namespace deadpoint;
using casefile::CalibrationFile;

constexpr double noise = 0.1, gap_noise = 5e-7;  // [K], [m]
constexpr const char* duty_cycle =
    R"(operation=[{name="first shift", duration="80 min", speed="60 rpm", force="100 kN"},)"
    R"( {name="break", duration="20 min", speed="0 rpm"}, {name="slow", duration="60 min", speed="45 rpm", force="100 kN"},)"
    R"( {name="tool change", duration="40 min", speed="0 rpm"},)"
    R"( {name="second shift", duration="60 min", speed="55 rpm", force="100 kN"}])";

casefile::CalibrationParameter unknown(const casefile::Case& input, const std::string& name, const std::string& keys,
                                       double prior)
{
    casefile::CalibrationParameter result;
    result.name = name;
    result.keys = study::keys_of(input, {keys}, name);
    result.prior = prior;
    result.place = "coverage";
    if (name == "room") {
        result.kind = casefile::CalibrationParameter::Kind::shift;
        result.dimension = Dimension::temperature_difference;
    }
    return result;
}

CalibrationFile file_of(const casefile::Case& input)
{
    CalibrationFile file;
    file.name = "coverage";
    file.parameters = {unknown(input, "journals", "friction.journals.*_part", std::log(1.5)),
                       unknown(input, "pins", "friction.pins.*_part", std::log(1.5)),
                       unknown(input, "guides", "friction.gibs.*_part", std::log(1.5)),
                       unknown(input, "room", "machine.ambient", 1),
                       unknown(input, "films", "surfaces.air_*.film.coefficient", std::log(1.5))};
    file.sensors.resize(3);
    for (auto& sensor : file.sensors) {
        sensor.sigma = noise;
        sensor.dimension = Dimension::temperature_difference;
    }
    file.sensors[1].bias_sigma = 0.5;
    file.sensors[2].sigma = gap_noise;
    file.sensors[2].dimension = Dimension::length;
    file.options.starts = 0;
    file.options.profiles = false;
    return file;
}

/// Sums over all draws of one kind of truth.
struct Tally {
    int draws = 0, flagged = 0;
    std::vector<int> inside;          ///< by unknown
    double temperature = 0, gap = 0;  ///< sums of mean squares of held-out curves [K^2], [1]
    int temperatures = 0, gaps = 0;   ///< how many curves
};

constexpr study::ForwardOptions steps{120, 1, nullptr};

class Study {
public:
    Study(std::string path, const study::ReducedPress& model, const study::ReducedPress& finer)
        : path_(std::move(path)), input_(casefile::read_case(path_).value), model_(model), finer_(finer)
    {}

    void run(const char* name, const std::vector<std::string>& laws, bool films_known, int draws, double model_error)
    {
        auto file = file_of(input_);
        for (auto& sensor : file.sensors)
            sensor.model_sigma = sensor.dimension == Dimension::length ? 1e-5 * model_error : model_error;
        std::vector<study::CaseParameter> parameters;
        for (const auto& p : file.parameters)
            if (films_known || p.name != "films")
                parameters.push_back(
                    {p.name, p.keys,
                     p.name == "room" ? study::CaseParameter::Kind::shift : study::CaseParameter::Kind::factor});
        const study::ForwardModel warm_up(casefile::read_case(path_, laws).value, finer_, parameters, steps);
        auto with_cycle = laws;
        with_cycle.emplace_back(duty_cycle);
        const study::ForwardModel cycle(casefile::read_case(path_, with_cycle).value, finer_, parameters, steps);
        Tally tally;
        tally.inside.assign(file.parameters.size() + 1, 0);
        for (; tally.draws < draws; ++tally.draws)
            one(file, warm_up, cycle, tally);
        std::printf("%s: %d draws, called wrong %d; held out: %.2f K, gap %.1f %%; in the interval:", name, draws,
                    tally.flagged, std::sqrt(tally.temperature / tally.temperatures),
                    100 * std::sqrt(tally.gap / tally.gaps));
        for (std::size_t k = 0; k < tally.inside.size(); ++k)
            if (films_known || k != 4)
                std::printf(" %s %.1f %%", k < file.parameters.size() ? file.parameters[k].name.c_str() : "bias",
                            100.0 * tally.inside[k] / draws);
        std::printf("\n");
        std::fflush(stdout);
    }

private:
    void one(CalibrationFile file, const study::ForwardModel& warm_up, const study::ForwardModel& cycle, Tally& tally)
    {
        std::mt19937 random(static_cast<unsigned>(tally.draws));
        std::normal_distribution<double> normal;
        std::vector<double> theta;
        for (const auto& p : file.parameters)
            theta.push_back(p.prior * normal(random));
        theta.push_back(file.sensors[1].bias_sigma * normal(random));
        const auto noisy = [&](double sigma) { return sigma * normal(random); };
        const auto exact = [](double) { return 0.0; };
        file.runs = {measured("warm-up", input_, file, warm_up, theta, noisy),
                     measured("duty cycle", casefile::read_case(path_, {duty_cycle}).value, file, cycle, theta, exact)};
        file.runs.back().hold_out = true;
        const auto result = study::calibrate(file, model_, 2, observer_);
        for (std::size_t k = 0; k < theta.size(); ++k) {
            const auto& p = result.parameters[k];
            tally.inside[k] += std::abs(p.theta - theta[k]) < 1.6449 * p.deviation ? 1 : 0;
        }
        tally.flagged += result.model_differs ? 1 : 0;
        for (const auto& curve : result.curves)
            if (curve.hold_out)
                add(curve, tally);
    }

    static void add(const study::FittedCurve& curve, Tally& tally)
    {
        if (!curve.of_gap) {
            tally.temperature += curve.rms * curve.rms;
            ++tally.temperatures;
            return;
        }
        const auto [least, most] = std::ranges::minmax(curve.measured);
        tally.gap += std::pow(curve.rms / (most - least), 2);
        ++tally.gaps;
    }

    /// @param theta       of all unknowns, then the bias of the second sensor [K]
    /// @param noise_of    a draw of noise of a standard deviation
    template <class Noise>
    [[nodiscard]] casefile::CalibrationRun measured(const char* name, const casefile::Case& input,
                                                    const CalibrationFile& file, const study::ForwardModel& truth,
                                                    const std::vector<double>& theta, const Noise& noise_of)
    {
        const auto found = truth.run(
            {theta.begin(), theta.begin() + static_cast<std::ptrdiff_t>(truth.parameters().size())}, false, observer_);
        casefile::CalibrationRun run;
        run.name = name;
        run.input = std::make_shared<casefile::Case>(input);
        const std::vector<std::pair<std::string, std::size_t>> sensors{
            {"bearing_front", 1}, {"slide", 0}, {"upright", 0}, {"E_SW", 2}};
        for (const auto& [output, sensor] : sensors) {
            const auto at = std::ranges::find(truth.outputs(), output, &study::ForwardOutput::name);
            const auto& values = found.value[static_cast<std::size_t>(at - truth.outputs().begin())];
            casefile::MeasuredCurve curve{output, output, sensor == 2, false, sensor, {}, {}, "data"};
            for (std::size_t row = 3; row < found.time.size(); row += 3) {
                curve.time.push_back(found.time[row]);
                curve.value.push_back(values[row] + noise_of(file.sensors[sensor].sigma) +
                                      (sensor == 1 ? theta.back() : 0));
            }
            run.curves.push_back(std::move(curve));
        }
        return run;
    }

    std::string path_;
    casefile::Case input_;
    const study::ReducedPress& model_;
    const study::ReducedPress& finer_;
    Observer observer_;
};

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 5 && argc != 6) {
        std::fprintf(stderr, "usage: benchmark_calibration_coverage CASE MODEL.rom FINER.rom DRAWS [LINE]\n");
        return 2;
    }
    const auto model = study::read_reduced(argv[2]), finer = study::read_reduced(argv[3]);
    const int draws = std::atoi(argv[4]);
    Study study(argv[1], model, finer);
    const std::vector<std::string> films{
        R"(surfaces.air_frame.film={law="vertical", length="1 m", emissivity=0.6})",
        R"(surfaces.air_moving.film={law="vertical", length="0.4 m", emissivity=0.6})"};
    const std::vector<std::string> oil{"oil.pins=300 W/m^2/K", "oil.gibs=300 W/m^2/K"};
    const int only = argc == 6 ? std::atoi(argv[5]) : 0;
    const auto wanted = [&](int number) { return only == 0 || only == number; };
    if (wanted(1))
        study.run("same laws", {}, true, draws, 0);
    if (wanted(2))
        study.run("same laws, model error 0.2 K and 2 um stated", {}, true, draws, 0.2);
    if (wanted(3))
        study.run("other films, model error 0.2 K and 2 um stated", films, false, draws, 0.2);
    if (wanted(4))
        study.run("wrong law", oil, true, std::min(draws, 20), 0);
    if (wanted(5))
        study.run("wrong law, model error 0.2 K and 2 um stated", oil, true, std::min(draws, 20), 0.2);
    return 0;
}
