#include "commands.hpp"
#include "deadpoint/report/files/loads_files.hpp"
#include "deadpoint/report/text/plan_text.hpp"
#include "options/case_options.hpp"
#include "output.hpp"

#include <memory>

namespace {

void summarise(const CaseOptions& options, const Console& console)
{
    const auto count = console.warnings().size();
    print_out("{}: no errors, {} warning{}\n", options.path, count, count == 1 ? "" : "s");
}

void check(const CaseOptions& options)
{
    Console console(options.console);
    const auto description = read_case(options, console).value;
    if (description.parts.empty()) {
        print_out("{}\n", deadpoint::report::linkage_plan_text(description));
        flush_out();
        if (const int segment = deadpoint::study::first_running_segment(description); segment >= 0) {
            deadpoint::study::compute_loads(description, nullptr, segment);  // does the linkage move?
        }
        return summarise(options, console);
    }
    const auto machine = mesh_case(description, options, console);
    print_out("{}\n", deadpoint::report::plan_text(description, machine));
    flush_out();
    for (const auto& warning : deadpoint::report::plan_warnings(description, machine)) {
        console.warn(warning);
    }
    summarise(options, console);
}

}  // namespace

void add_check(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("check", "check a case without solving it, and print the plan");
    const auto options = std::make_shared<CaseOptions>();
    add_case_options(*command, *options);
    command->callback([options, &exit_code] {
        check(*options);
        exit_code = 0;
    });
}
