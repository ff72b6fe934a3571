#include "deadpoint/casefile/read.hpp"
#include "deadpoint/fem/session.hpp"
#include "deadpoint/study/prepare.hpp"
#include "deadpoint/study/refine.hpp"

#include <exception>
#include <fstream>
#include <iostream>

// solve_on_ranks CASE FILE [path=value ...]: solves a case on all ranks and writes, number by number, how many they
// are, the mismatch of the energy balance, and the last temperatures of probes, interface sides and parts. A case that
// states an accuracy is refined to it.

using namespace deadpoint;

namespace {

study::RunResult solve(const casefile::Case& input)
{
    Observer silent;
    if (casefile::wanted_accuracy(input))
        return study::run_to_accuracy(input, 1, {}, silent).result;
    const auto machine = study::prepare_machine(input, 1, silent);
    return study::run_case(input, machine, {}, silent);
}

void write(const std::string& path, const study::RunResult& result)
{
    std::ofstream file(path);
    file.precision(17);
    file << result.ranks << '\n' << result.thermal.energy.mismatch() << '\n';
    const auto& history = result.thermal;
    for (const auto* group : {&history.probes, &history.interface_a, &history.interface_b, &history.part_means})
        for (const auto& series : *group)
            file << series.value.back() << '\n';
}

}  // namespace

int main(int argc, char** argv)
{
    int none = 0;
    char** nothing = nullptr;
    const fem::Session session(none, nothing);
    try {
        const auto input = casefile::read_case(argv[1], {argv + 3, argv + argc}).value;
        const auto result = solve(input);
        if (session.rank() == 0)
            write(argv[2], result);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        fem::abort_ranks(1);
    }
    return 0;
}
