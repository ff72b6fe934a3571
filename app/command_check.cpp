#include "case_options.hpp"
#include "commands.hpp"
#include "deadpoint/report/plan_text.hpp"

#include <fmt/format.h>
#include <memory>

namespace {

void check(const CaseOptions& options)
{
    Console console(options.console);
    const auto description = read_case(options, console);
    const auto machine = mesh_case(description, options, console);
    fmt::print("{}\n", deadpoint::report::plan_text(description, machine));
    std::fflush(stdout);
    for (const auto& warning : deadpoint::report::plan_warnings(description, machine)) {
        console.warn(warning);
    }
    const auto count = console.warnings().size();
    fmt::print("{}: no errors, {} warning{}\n", options.path, count, count == 1 ? "" : "s");
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
