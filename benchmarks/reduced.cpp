#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/observer.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>

// Builds a reduced model of a case and compares it with full runs:
//   benchmark_reduced case.toml [size_scale [full_runs [largest [sets [training_runs]]]]]

namespace {

using namespace deadpoint;
using Clock = std::chrono::steady_clock;

class Printed : public Observer {
public:
    void stage(std::string_view name) override
    {
        std::printf("%8.1f s  %.*s\n", std::chrono::duration<double>(Clock::now() - start_).count(),
                    static_cast<int>(name.size()), name.data());
        std::fflush(stdout);
    }
    void warn(std::string_view text) override
    {
        std::printf("warning: %.*s\n", static_cast<int>(text.size()), text.data());
    }

private:
    Clock::time_point start_ = Clock::now();
};

double number(int count, char** arguments, int place, double otherwise)
{
    return place < count ? std::atof(arguments[place]) : otherwise;
}

}  // namespace

int main(int count, char** arguments)
{
    fem::Session session(count, arguments);
    Printed observer;
    full::ReduceOptions options;
    options.full_runs = static_cast<int>(number(count, arguments, 3, 4));
    options.build.largest = static_cast<std::size_t>(number(count, arguments, 4, 300));
    options.build.sets = static_cast<int>(number(count, arguments, 5, options.build.sets));
    options.build.training_runs = static_cast<int>(number(count, arguments, 6, options.build.training_runs));
    options.build.temperature = options.build.gap = 0;
    options.build.threads = 2;
    full::Press press(casefile::read_case(arguments[1]).value, number(count, arguments, 2, 1));
    const auto built = press.reduce(options, observer).value();
    observer.stage("end");
    std::printf("%zu free coefficients, large model %zu states, small model %zu states\n", built.small.box.size(),
                built.large.states, built.small.states);
    for (const auto& [states, temperature, gap] : built.small.sizes)
        std::printf("  %zu states to large: %8.4f K %9.4f um\n", states, temperature, 1e6 * gap);
    for (const auto* model : {&built.large, &built.small})
        for (const auto& error : model->errors)
            std::printf("  %-6s %-46s %8.4f K %9.4f um\n", model == &built.large ? "large" : "small", error.of.c_str(),
                        error.temperature, 1e6 * error.gap);
}
