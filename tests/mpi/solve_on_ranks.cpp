#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/exchange/stress.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/refine/refine.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/full/run/run.hpp"
#include "deadpoint/observer.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

// solve_on_ranks CASE FILE [path=value ...]: solves a case on all ranks and writes, number by number, how many they
// are, the mismatch of the energy balance, the gap at the end [um], how far the deformation solved then and the adjoint
// differ in it, the last temperatures of probes, interface sides, parts and enclosures, the highest of each part, and
// forces and stress of the frame. What each joint, the oil and the air have done to the gap, over the gap, goes into
// FILE.causes. A case that states an accuracy is refined to it. Words that begin with two dashes: --checkpoint=FILE
// keeps the run there after each step, --stop=N ends it after N steps, --resume goes on from there.

using namespace deadpoint;

namespace {

struct Interruption {
    std::string checkpoint;
    int stop = -1;  ///< after so many steps; < 0: never
    bool resume = false;
};

// Takes the words with two dashes out of the arguments.
Interruption interruption_of(std::vector<std::string>& arguments)
{
    Interruption result;
    std::erase_if(arguments, [&](const std::string& word) {
        if (word.starts_with("--checkpoint="))
            result.checkpoint = word.substr(13);
        if (word.starts_with("--stop="))
            result.stop = std::stoi(word.substr(7));
        result.resume = result.resume || word == "--resume";
        return word.starts_with("--");
    });
    return result;
}

class StoppingObserver : public Observer {
public:
    explicit StoppingObserver(int steps) : left_(steps) {}
    void progress(double, std::string_view) override { --left_; }
    [[nodiscard]] bool cancelled() const override { return left_ == 0; }

private:
    int left_;
};

press::RunResult solve(const casefile::Case& input, const Interruption& interruption)
{
    StoppingObserver silent(interruption.stop);
    if (casefile::wanted_accuracy(input))
        return full::run_to_accuracy(input, 1, {}, silent).result;
    full::RunOptions options;
    options.causes = true;
    options.checkpoint_file = interruption.checkpoint;
    options.checkpoint_interval = 0;
    options.resume_from = interruption.resume ? interruption.checkpoint : std::string{};
    return full::Press(input).run(options, silent);
}

void write(const std::string& path, const press::RunResult& result)
{
    std::ofstream file(path);
    file.precision(17);
    file << result.ranks << '\n' << result.thermal.energy.mismatch() << '\n';
    const auto& check = result.adjoint_check;
    file << (result.drift ? 1e6 * result.drift->gap.value.back() : 0) << '\n'
         << (check ? 1e6 * (check->by_adjoint - check->by_deformation) : 0) << '\n';
    const auto& history = result.thermal;
    for (const auto* group : {&history.probes, &history.interface_a, &history.interface_b, &history.part_means})
        for (const auto& series : *group)
            file << series.value.back() << '\n';
    for (const auto& air : history.enclosures)
        file << air.temperature.value.back() << '\n';
    for (const double highest : history.part_highest)
        file << highest << '\n';
    // forces in kN and stress in MPa, of the size of the temperatures
    const auto frame = result.frame.value_or(press::FrameResult{});
    for (const auto& rod : frame.rods)
        file << 1e-3 * rod.start << '\n' << 1e-3 * rod.change.value.back() << '\n';
    for (const auto& bond : frame.bonds)
        file << 1e-3 * bond.start << '\n' << 1e-3 * bond.change.value.back() << '\n';
    for (const auto& peak : frame.stress)
        file << 1e-6 * peak.von_mises << '\n';
    if (result.causes.empty())
        return;
    const auto& causes = result.causes.back();
    std::ofstream shares(path + ".causes");
    shares.precision(17);
    for (const auto& [name, value] : causes.joints)
        shares << value / causes.gap << '\n';
    for (const double value : {causes.oil, causes.air, causes.remainder})
        shares << value / causes.gap << '\n';
}

}  // namespace

int main(int argc, char** argv)
{
    int none = 0;
    char** nothing = nullptr;
    const fem::Session session(none, nothing);
    try {
        std::vector<std::string> overrides(argv + 3, argv + argc);
        const auto interruption = interruption_of(overrides);
        const auto input = casefile::read_case(argv[1], overrides).value;
        const auto result = solve(input, interruption);
        if (session.rank() == 0)
            write(argv[2], result);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        fem::abort_ranks(1);
    }
    return 0;
}
