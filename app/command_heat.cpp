#include "commands.hpp"
#include "deadpoint/report/files/heat_files.hpp"
#include "deadpoint/study/pipeline/heat_tables.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <algorithm>
#include <memory>
#include <optional>

using namespace deadpoint;

namespace {

std::optional<study::LoadsResult> loads_of(const casefile::Case& input, const Machine* machine, Console& console)
{
    const int running = study::first_running_segment(input);
    if (running < 0 || !study::has_loads(input)) {
        return std::nullopt;
    }
    console.stage("loads");
    auto loads = study::compute_loads(input, machine, running);
    for (const auto& warning : loads.warnings) {
        console.warn(warning);
    }
    return loads;
}

void compute(const SegmentOptions& options)
{
    Console console(options.console);
    const auto read = read_case(options, console);
    const auto& input = read.value;
    const int segment = options.segment >= 0 ? options.segment : std::max(0, study::first_running_segment(input));
    const auto folder = start_folder(options, read, console);
    std::optional<Machine> machine;
    if (!input.parts.empty()) {
        machine = mesh_case(input, options, console);
    }
    const auto loads = loads_of(input, machine ? &*machine : nullptr, console);
    const auto tables = study::heat_tables(input, machine ? &*machine : nullptr, loads ? &*loads : nullptr, segment);
    console.finish();
    for (const auto& warning : tables.warnings) {
        console.warn(warning);
    }
    report::write_heat_files(folder->path(), input, tables, console.warnings());
    commit(*folder, console);
    print_out("{}\nheat tables are in {}\n", report::heat_text(input, tables), folder->target().string());
}

}  // namespace

void add_heat(CLI::App& app, int& exit_code)
{
    auto* command =
        app.add_subcommand("heat", "show friction heat, conductances and film coefficients without solving the field");
    const auto options = std::make_shared<SegmentOptions>();
    add_segment_options(*command, *options);
    command->callback([options, &exit_code] {
        compute(*options);
        exit_code = 0;
    });
}
