#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/twin/calibrate/calibrate.hpp"
#include "deadpoint/twin/calibrate/forward.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

// How long a calibration takes: benchmark_calibration_speed cases/jl75g-60/oil.toml press.rom THREADS PROFILES SAMPLES
// Eight thermometers with a value each ten minutes, twelve unknowns and three runs of three hours. The data are those
// of the reduced press itself with other values and noise.

namespace {

using namespace deadpoint;

constexpr double noise = 0.2;  // [K]

casefile::CalibrationFile file_of(const casefile::Case& input)
{
    casefile::CalibrationFile file;
    file.name = "speed";
    for (const char* keys :
         {"friction.crank_bearings.*_part", "friction.crank_pin.*_part", "friction.link*_part", "friction.pivot_*_part",
          "friction.guide_*_part", "oil.crank_*", "oil.links_*", "oil.link_*", "oil.pivot_*", "oil.guide_*",
          "surfaces.crank_system.film.coefficient", "surfaces.frame_and_sliders.film.coefficient"}) {
        casefile::CalibrationParameter parameter;
        parameter.name = keys;
        parameter.keys = twin::keys_of(input, {keys}, keys);
        parameter.prior = std::log(1.5);
        file.parameters.push_back(std::move(parameter));
    }
    file.sensors.resize(1);
    file.sensors[0].sigma = noise;
    file.sensors[0].dimension = Dimension::temperature_difference;
    return file;
}

casefile::CalibrationRun measured(const casefile::Case& input, const casefile::CalibrationFile& file,
                                  const twin::ReducedPress& press, std::mt19937& random)
{
    std::normal_distribution<double> normal;
    std::vector<twin::CaseParameter> parameters;
    for (const auto& p : file.parameters)
        parameters.push_back({p.name, p.keys});
    Observer silent;
    const twin::ForwardModel model(input, press, parameters, {file.options.fixed_step, 1, nullptr});
    const auto found = model.run(std::vector<double>(parameters.size(), 0.2), false, silent);
    casefile::CalibrationRun run;
    run.name = std::to_string(input.operation.front().speed);
    run.input = std::make_shared<casefile::Case>(input);
    for (std::size_t o = 0; o < model.outputs().size(); ++o) {
        if (model.outputs()[o].kind != twin::ForwardOutput::Kind::probe)
            continue;
        casefile::MeasuredCurve curve{
            model.outputs()[o].name, model.outputs()[o].name, false, false, 0, {}, {}, "data"};
        for (std::size_t row = 5; row < found.time.size(); row += 5) {
            curve.time.push_back(found.time[row]);
            curve.value.push_back(found.value[o][row] + noise * normal(random));
        }
        run.curves.push_back(std::move(curve));
    }
    return run;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 6) {
        std::fprintf(stderr, "usage: benchmark_calibration_speed CASE PRESS.rom THREADS PROFILES SAMPLES\n");
        return 2;
    }
    const auto press = twin::read_reduced(argv[2]);
    std::mt19937 random(1);
    auto file = file_of(casefile::read_case(argv[1]).value);
    for (const char* speed : {"200 rpm", "300 rpm", "400 rpm"})
        file.runs.push_back(measured(casefile::read_case(argv[1], {std::string("operation.0.speed=") + speed}).value,
                                     file, press, random));
    file.options.profiles = std::atoi(argv[4]) != 0;
    file.options.samples = std::atoi(argv[5]);
    Observer silent;
    const auto start = std::chrono::steady_clock::now();
    const auto found = twin::calibrate(file, press, {}, std::atoi(argv[3]), silent).value();
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("%zu states, %zu unknowns, %zu curves: fit %.2f s (%d runs of all cases with derivatives, %zu starts), "
                "all with "
                "%s and %d samples %.1f s\n",
                press.states, found.parameters.size(), found.curves.size(), found.seconds, found.evaluations,
                found.starts, file.options.profiles ? "profiles" : "no profiles", file.options.samples, all);
    return 0;
}
