#include "commands.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/report/heat/heat_files.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <algorithm>
#include <memory>

using namespace deadpoint;

namespace {

void compute(const SegmentOptions& options)
{
    Console console(options.console);
    const auto read = read_case(options, console);
    full::Press press(read.value, options.size_scale);
    const auto& input = press.input();
    const int segment = options.segment >= 0 ? options.segment : std::max(0, press::first_running_segment(input));
    const auto folder = start_folder(options, read, console);
    const auto tables = press.heat_tables(segment, console);
    console.finish();
    report::write_heat_files(folder->path(), input, tables, console.warnings());
    commit(*folder, options.tables, console);
    print_out("{}\nheat tables are in {}\n", report::heat_text(input, tables), folder->target().string());
}

}  // namespace

void add_heat(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand(
        "heat", "show friction heat, contact conductances and convection coefficients without solving the field");
    const auto options = std::make_shared<SegmentOptions>();
    add_segment_options(*command, *options);
    command->callback([options, &exit_code] {
        compute(*options);
        exit_code = 0;
    });
}
