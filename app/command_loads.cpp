#include "commands.hpp"
#include "deadpoint/core/error.hpp"
#include "deadpoint/report/files/loads_files.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <memory>
#include <optional>

using namespace deadpoint;

namespace {

int segment_of(const SegmentOptions& options, const casefile::Case& input)
{
    if (options.segment >= 0) {
        return options.segment;
    }
    const int first = study::first_running_segment(input);
    if (first < 0) {
        throw InputError("the press runs in no segment of [[operation]]\n  help: give one a speed");
    }
    return first;
}

void compute(const SegmentOptions& options)
{
    Console console(options.console);
    const auto read = read_case(options, console);
    const auto& input = read.value;
    const int segment = segment_of(options, input);
    const auto folder = start_folder(options, read, console);
    std::optional<Machine> machine;
    if (study::loads_need_machine(input)) {
        machine = mesh_case(input, options, console);
    }
    console.stage("loads");
    const auto loads = study::compute_loads(input, machine ? &*machine : nullptr, segment);
    console.finish();
    for (const auto& warning : loads.warnings) {
        console.warn(warning);
    }
    report::write_loads_files(folder->path(), input, loads, console.warnings());
    commit(*folder, console);
    print_out("{}\nloads are in {}\n", report::loads_text(input, loads), folder->target().string());
}

}  // namespace

void add_loads(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("loads", "compute motion, joint forces and crankshaft loads over a turn");
    const auto options = std::make_shared<SegmentOptions>();
    add_segment_options(*command, *options);
    command->callback([options, &exit_code] {
        compute(*options);
        exit_code = 0;
    });
}
