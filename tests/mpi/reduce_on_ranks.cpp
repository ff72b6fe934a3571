#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/reduce.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

// reduce_on_ranks CASE FILE SIZE LARGEST_FACTOR [path=value ...]: builds a reduced press on all ranks, with few fields
// and training runs, and writes, number by number: the ranks, the states of both models, E_SW of the case on the small
// one at the end [um], the stated errors of both models [K, um].

using namespace deadpoint;

namespace {

twin::Reduction reduction_of(const casefile::Case& input, double size, long long largest_factor)
{
    Observer silent;
    full::Press press(input, size);
    auto options = full::reduce_options(input);
    options.full_runs = 1;
    options.largest_factor = largest_factor;
    options.build.sets = 12;
    options.build.training_runs = 9;  // no multiple of two
    options.build.test_runs = 4;
    options.build.largest = 60;
    options.build.temperature = 1;
    options.build.gap = 1;
    return press.reduce(options, silent).value();
}

void write(const std::string& path, const casefile::Case& input, const twin::Reduction& reduction)
{
    Observer silent;
    const auto run =
        twin::run_reduced(input, reduction.small, {&reduction.large, nullptr}, twin::ReducedDetail::figures, silent);
    std::ofstream file(path);
    file.precision(17);
    file << fem::ranks() << '\n' << reduction.large.states << '\n' << reduction.small.states << '\n';
    file << 1e6 * run.drift->gap.value.back() << '\n';
    for (const auto* press : {&reduction.small, &reduction.large})
        for (const auto& error : press->errors)
            file << error.temperature << '\n' << 1e6 * error.gap << '\n';
}

}  // namespace

int main(int argc, char** argv)
{
    int none = 0;
    char** nothing = nullptr;
    const fem::Session session(none, nothing);
    try {
        const auto input = casefile::read_case(argv[1], {argv + 5, argv + argc}).value;
        const auto reduction = reduction_of(input, std::stod(argv[3]), std::stoll(argv[4]));
        if (session.rank() == 0)
            write(argv[2], input, reduction);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        fem::abort_ranks(1);
    }
    return 0;
}
