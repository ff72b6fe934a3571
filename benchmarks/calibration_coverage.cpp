#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/twin/calibrate/calibrate.hpp"
#include "deadpoint/twin/calibrate/forward.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <random>
#include <string>

// Whether intervals of calibrate hold the truth as often as they say, and whether it notices a wrong model:
//   benchmark_calibration_coverage CASE MODEL.rom COARSER.rom DRAWS LINE FINER.rom...
// The truths are drawn from the prior and computed on reduced presses of finer meshes, each in turn. Each is fitted by
// MODEL.rom to a warm-up, which then predicts a duty cycle of other speeds and stops that was held out.
//   same laws:    the truth has the model's laws
//   other films:  natural convection by law in place of constant films
//   wrong law:    oil takes heat from pins and guides, which the model's press does not have
// The model errors that a line allows for are alternatives of the calibration file: the coarser mesh, and films by a
// law (which is not that of the truth). Prints an object of JSON for the line: for each unknown the share of true
// values in their 90 % intervals and their ranks in ten classes, how often the model was called wrong, and how far the
// duty cycles are off: temperatures [K], and the gap as a share of its range over each cycle, root mean squares over
// all draws.

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
    result.keys = twin::keys_of(input, {keys}, name);
    result.prior = prior;
    result.place = "coverage";
    if (name == "room") {
        result.kind = casefile::CalibrationParameter::Kind::shift;
        result.dimension = Dimension::temperature_difference;
    }
    return result;
}

/// What a line varies.
struct Line {
    const char* name;
    std::vector<std::string> laws;  ///< of the truth
    bool films_known;               ///< whether the truth has the factor on both films
    std::vector<std::string> alternatives;
    double model_error;  ///< stated for all sensors [K]; a kelvin is 10 um of the gap
};

const std::vector<std::string> constant_films{R"(surfaces.air_frame.film.coefficient="3.1 W/m^2/K")",
                                              R"(surfaces.air_moving.film.coefficient="3.5 W/m^2/K")"};
const std::vector<std::string> films_by_law{
    R"(surfaces.air_frame.film={law="vertical", length="1 m", emissivity=0.6})",
    R"(surfaces.air_moving.film={law="vertical", length="0.4 m", emissivity=0.6})"};
/// Alternatives by name. Their law of films is not that of the truth.
const std::map<std::string, std::vector<std::string>> sets_of_alternatives{
    {"mesh", {}},
    {"frame film", {R"(surfaces.air_frame.film={law="horizontal_up", length="0.3 m", emissivity=0.6})"}},
    {"moving film", {R"(surfaces.air_moving.film={law="horizontal_up", length="0.3 m", emissivity=0.6})"}}};
const std::vector<std::string> mesh_and_films{"mesh", "frame film", "moving film"};
const std::vector<std::string> oil{"oil.pins=300 W/m^2/K", "oil.gibs=300 W/m^2/K"};
const std::vector<Line> lines{
    {"same laws, no model error", {}, true, {}, 0},
    {"same laws, coarser mesh", {}, true, {"mesh"}, 0},
    {"same laws, coarser mesh and other films", {}, true, mesh_and_films, 0},
    {"other films, coarser mesh", films_by_law, false, {"mesh"}, 0},
    {"other films, coarser mesh and other films", films_by_law, false, mesh_and_films, 0},
    {"wrong law, no model error", oil, true, {}, 0},
    {"wrong law, coarser mesh", oil, true, {"mesh"}, 0},
    {"wrong law, coarser mesh and other films", oil, true, mesh_and_films, 0},
    {"wrong law, model error 0.2 K and 2 um stated", oil, true, {}, 0.2},
};

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
    std::vector<int> inside;                 ///< by unknown
    std::vector<std::array<int, 10>> ranks;  ///< by unknown
    double temperature = 0, gap = 0;         ///< sums of mean squares of held-out curves [K^2], [1]
    int temperatures = 0, gaps = 0;          ///< how many curves
};

constexpr twin::ForwardOptions steps{120, 1, nullptr};

std::vector<std::string> joined(std::vector<std::string> some, const std::vector<std::string>& more)
{
    some.insert(some.end(), more.begin(), more.end());
    return some;
}

class Study {
public:
    Study(std::string path, const twin::ReducedPress& model, std::shared_ptr<const twin::ReducedPress> coarser,
          const std::vector<twin::ReducedPress>& truths)
        : path_(std::move(path)), input_(read({})), model_(model), coarser_(std::move(coarser)), truths_(truths)
    {}

    void run(const Line& line, int draws)
    {
        auto file = file_of(input_);
        for (auto& sensor : file.sensors)
            sensor.model_sigma = sensor.dimension == Dimension::length ? 1e-5 * line.model_error : line.model_error;
        twin::OtherPresses others;
        for (const auto& name : line.alternatives) {
            file.alternatives.push_back({name, "", sets_of_alternatives.at(name), 0, "coverage"});
            others.push_back(name == "mesh" ? coarser_ : nullptr);
        }
        std::vector<twin::CaseParameter> parameters;
        for (const auto& p : file.parameters)
            if (line.films_known || p.name != "films")
                parameters.push_back(
                    {p.name, p.keys,
                     p.name == "room" ? twin::CaseParameter::Kind::shift : twin::CaseParameter::Kind::factor});
        std::vector<twin::ForwardModel> warm_up, cycle;
        for (const auto& press : truths_) {
            warm_up.emplace_back(read(line.laws), press, parameters, steps);
            cycle.emplace_back(read(joined(line.laws, {duty_cycle})), press, parameters, steps);
        }
        Tally tally;
        tally.inside.assign(file.parameters.size() + 1, 0);
        tally.ranks.assign(file.parameters.size() + 1, {});
        for (; tally.draws < draws; ++tally.draws) {
            const auto of = static_cast<std::size_t>(tally.draws) % truths_.size();
            one(file, others, warm_up[of], cycle[of], tally);
        }
        print(line, file, tally);
    }

private:
    [[nodiscard]] casefile::Case read(const std::vector<std::string>& set) const
    {
        return casefile::read_case(path_, joined(constant_films, set)).value;
    }

    static void print(const Line& line, const CalibrationFile& file, const Tally& tally)
    {
        std::printf(R"({"name": "%s", "draws": %d, "wrong": %d, "temperature": %.3f, "gap": %.4f, "unknowns": [)",
                    line.name, tally.draws, tally.flagged, std::sqrt(tally.temperature / tally.temperatures),
                    std::sqrt(tally.gap / tally.gaps));
        const char* comma = "";
        for (std::size_t k = 0; k < tally.inside.size(); ++k) {
            const auto name = k < file.parameters.size() ? file.parameters[k].name : "bias";
            if (name == "films" && !line.films_known)
                continue;
            std::printf(R"(%s{"name": "%s", "inside": %d, "ranks": [)", comma, name.c_str(), tally.inside[k]);
            for (std::size_t r = 0; r < 10; ++r)
                std::printf("%s%d", r == 0 ? "" : ", ", tally.ranks[k][r]);
            std::printf("]}");
            comma = ", ";
        }
        std::printf("]}\n");
        std::fflush(stdout);
    }

    [[nodiscard]] casefile::CalibrationRun with_alternatives(casefile::CalibrationRun run, const CalibrationFile& file,
                                                             const std::vector<std::string>& set) const
    {
        for (const auto& alternative : file.alternatives)
            run.alternatives.push_back(std::make_shared<casefile::Case>(read(joined(set, alternative.set))));
        return run;
    }

    void one(CalibrationFile file, const twin::OtherPresses& others, const twin::ForwardModel& warm_up,
             const twin::ForwardModel& cycle, Tally& tally)
    {
        std::mt19937 random(static_cast<unsigned>(tally.draws));
        std::normal_distribution<double> normal;
        std::vector<double> theta;
        for (const auto& p : file.parameters)
            theta.push_back(p.prior * normal(random));
        theta.push_back(file.sensors[1].bias_sigma * normal(random));
        const auto noisy = [&](double sigma) { return sigma * normal(random); };
        const auto exact = [](double) { return 0.0; };
        file.runs = {with_alternatives(measured("warm-up", input_, file, warm_up, theta, noisy), file, {}),
                     with_alternatives(measured("duty cycle", read({duty_cycle}), file, cycle, theta, exact), file,
                                       {duty_cycle})};
        file.runs.back().hold_out = true;
        const auto result = twin::calibrate(file, model_, others, 1, observer_).value();
        for (std::size_t k = 0; k < theta.size(); ++k) {
            const auto& p = result.parameters[k];
            const double off = (theta[k] - p.theta) / p.deviation;
            tally.inside[k] += std::abs(off) < 1.6449 ? 1 : 0;
            const double rank = 0.5 * std::erfc(-off / std::sqrt(2.0));
            ++tally.ranks[k][static_cast<std::size_t>(std::min(9.0, 10 * rank))];
        }
        tally.flagged += result.model_differs ? 1 : 0;
        for (const auto& curve : result.curves)
            if (curve.hold_out)
                add(curve, tally);
        if (std::getenv("COVERAGE_TRACE"))
            trace(result, theta);
    }

    static void trace(const twin::Calibration& result, const std::vector<double>& theta)
    {
        std::fprintf(stderr, "p %.2g:", result.model_probability);
        for (std::size_t k = 0; k < result.parameters.size(); ++k) {
            const auto& p = result.parameters[k];
            std::fprintf(stderr, " %s %.3f+-%.3f", p.name.c_str(), p.theta, p.deviation);
            if (k < theta.size())
                std::fprintf(stderr, " (%+.2f)", (theta[k] - p.theta) / p.deviation);
        }
        for (const auto& curve : result.curves)
            std::fprintf(stderr, " | %s %.3g %.3g", curve.output.c_str(), curve.rms, curve.model_error);
        std::fprintf(stderr, "\n");
    }

    static void add(const twin::FittedCurve& curve, Tally& tally)
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
                                                    const CalibrationFile& file, const twin::ForwardModel& truth,
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
            const auto at = std::ranges::find(truth.outputs(), output, &twin::ForwardOutput::name);
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
    const twin::ReducedPress& model_;
    std::shared_ptr<const twin::ReducedPress> coarser_;
    const std::vector<twin::ReducedPress>& truths_;
    Observer observer_;
};

}  // namespace

int main(int argc, char** argv)
{
    const auto count = static_cast<int>(lines.size());
    const int line = argc > 6 ? std::atoi(argv[5]) : 0;
    if (line < 1 || line > count) {
        std::fprintf(stderr,
                     "usage: benchmark_calibration_coverage CASE MODEL.rom COARSER.rom DRAWS LINE FINER.rom...\n");
        for (int k = 0; k < count; ++k)
            std::fprintf(stderr, "LINE %d: %s\n", k + 1, lines[static_cast<std::size_t>(k)].name);
        return 2;
    }
    const auto model = twin::read_reduced(argv[2]);
    auto coarser = std::make_shared<twin::ReducedPress>(twin::read_reduced(argv[3]));
    std::vector<twin::ReducedPress> truths;
    for (int k = 6; k < argc; ++k)
        truths.push_back(twin::read_reduced(argv[k]));
    Study(argv[1], model, std::move(coarser), truths)
        .run(lines[static_cast<std::size_t>(line - 1)], std::atoi(argv[4]));
    return 0;
}
