#include "commands.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/report/loads/loads_files.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <memory>

using namespace deadpoint;

namespace {

int segment_of(const SegmentOptions& options, const casefile::Case& input)
{
    if (options.segment >= 0) {
        return options.segment;
    }
    const int first = press::first_running_segment(input);
    if (first < 0) {
        throw InputError("the press runs in no segment of [[operation]]\n  help: give one a speed");
    }
    return first;
}

void compute(const SegmentOptions& options)
{
    Console console(options.console);
    const auto read = read_case(options, console);
    full::Press press(read.value, options.size_scale);
    const auto& input = press.input();
    const int segment = segment_of(options, input);
    const auto folder = start_folder(options, read, console);
    const auto loads = press.loads(segment, console);
    console.finish();
    report::write_loads_files(folder->path(), input, loads, console.warnings());
    commit(*folder, options.tables, console);
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
