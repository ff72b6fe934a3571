#include "commands.hpp"
#include "deadpoint/report/files/loads_files.hpp"
#include "deadpoint/report/text/plan_text.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "deadpoint/study/result/loads_result.hpp"
#include "options/case_options.hpp"
#include "output.hpp"

#include <memory>
#include <string>

using namespace deadpoint;

namespace {

void summarise(const CaseOptions& options, const Console& console)
{
    const auto count = console.warnings().size();
    print_out("{}: no errors, {} warning{}\n", options.path, count, count == 1 ? "" : "s");
}

/// The plan, at once: what follows may take a while, or fail.
void show(const CaseOptions& options, const std::string& plan)
{
    if (!options.console.quiet) {
        print_out("{}\n", plan);
        flush_out();
    }
}

void check(const CaseOptions& options)
{
    Console console(options.console);
    study::Press press(read_case(options, console).value, options.size_scale);
    const auto& description = press.input();
    Observer silent;
    if (description.parts.empty()) {
        show(options, report::linkage_plan_text(description));
        press.check(silent);  // does the linkage move?
        return summarise(options, console);
    }
    const auto& machine = mesh_parts(press, console);
    show(options, report::plan_text(description, machine));
    for (const auto& warning : report::plan_warnings(description, machine)) {
        console.warn(warning);
    }
    press.check(silent);
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
