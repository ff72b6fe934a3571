#include "commands.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/probe/probe_fields.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"
#include "options/case_options.hpp"
#include "output.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct ProbeOptions {
    std::string folder;
    std::vector<std::string> at;
    std::string output;
    bool force = false;
    CsvStyle tables = CsvStyle::comments;
    Console::Options console;
};

/// What the answer rests on, and how to know more.
void say_what_is_known(const report::ProbedFields& fields, Console& console)
{
    const auto count = fields.times.size();
    console.note(fmt::format("the run wrote fields at {} {}, {:.6g} s{}; between and beyond them nothing is known. For "
                             "more times run it with output.field_times = [\"10 min\", ...]",
                             count, count == 1 ? "time" : "times", fields.times.front(),
                             count == 1 ? "" : fmt::format(" to {:.6g} s", fields.times.back())));
    for (const auto& probed : fields.places) {
        if (probed.outside > 0) {
            console.note(fmt::format("'{}' is {:.3g} mm off the flat faces of its cells; the nearest place in them "
                                     "stands for it",
                                     probed.place.name, 1e3 * probed.outside));
        }
        if (probed.displacement.empty()) {
            console.note(fmt::format("there is no displacement of '{}': the case has no [chain]", probed.place.name));
        }
    }
}

/// The chart beside a table. @throws InputError if the table has its name
fs::path chart_beside(const fs::path& table)
{
    auto chart = table;
    if (chart.replace_extension(".svg") == table) {
        throw InputError(fmt::format("'{}' is the name of the chart beside the table\n  help: give the table another "
                                     "one, like probe.csv",
                                     table.string()));
    }
    return chart;
}

void probe(const ProbeOptions& options)
{
    Console console(options.console);
    const fs::path table = options.output;
    const auto chart = options.output.empty() ? fs::path() : chart_beside(table);
    if (!options.output.empty()) {
        (void)report::if_there(table, options.force);
        (void)report::if_there(chart, options.force);
    }
    const auto places = report::probe_places(options.at);
    const report::ResultFiles results(options.folder);
    results.check("case.toml");
    const auto input =
        casefile::read_case(fs::path(options.folder) / "case.toml", {}, casefile::FileAccess::anywhere).value;
    console.stage("reading the fields");
    const auto fields = report::probe_fields(results, input, places);
    say_what_is_known(fields, console);
    console.finish();
    const auto comments = file_comments(input, console);
    const auto text = csv_in_style(report::csv_text(comments, report::probe_columns(fields)), options.tables);
    if (options.output.empty()) {
        print_out("{}", text);
        return;
    }
    write_file(table, text);
    report::write_svg_chart(chart, report::probe_chart(fields, input.machine.name), comments);
    print_out("values are in {}, their chart is in {}\n", table.string(), chart.string());
}

}  // namespace

void add_probe(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("probe", "tell the temperature of any place from the fields of a run");
    const auto options = std::make_shared<ProbeOptions>();
    command->add_option("DIR", options->folder, "a folder that 'run' has written")->required();
    command
        ->add_option("--at", options->at,
                     "a place: part and coordinates, --at \"frame,0 mm,120 mm,-30 mm\" or --at \"tip=frame,...\"; may "
                     "be repeated")
        ->type_name("PLACE")
        ->required()
        ->take_all();
    command
        ->add_option("-o,--output", options->output,
                     "write the table to this file and a chart beside it, .svg; default: the table to the terminal")
        ->type_name("FILE");
    add_table_option(*command, options->tables);
    command->add_flag("--force", options->force, "replace the files that --output names if they exist");
    command->add_flag("-q,--quiet", options->console.quiet, "show warnings and results only");
    command->callback([options, &exit_code] {
        probe(*options);
        exit_code = 0;
    });
}
