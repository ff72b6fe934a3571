#include "commands.hpp"
#include "deadpoint/report/files/loads_files.hpp"
#include "deadpoint/report/text/plan_text.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "deadpoint/study/result/loads_result.hpp"
#include "options/case_options.hpp"
#include "output.hpp"

#include <memory>
#include <string>
#include <string_view>

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

/// Passes on warnings and nothing else.
class Warnings : public Observer {
public:
    explicit Warnings(Console& console) : console_(console) {}
    void warn(std::string_view text) override { console_.warn(text); }
    [[nodiscard]] bool cancelled() const override { return console_.cancelled(); }

private:
    Console& console_;
};

void check(const CaseOptions& options)
{
    Console console(options.console);
    study::Press press(read_case(options, console).value, options.size_scale);
    const auto& description = press.input();
    Warnings warnings(console);
    if (description.parts.empty()) {
        show(options, report::linkage_plan_text(description));
        press.check(warnings);  // does the linkage move?
        return summarise(options, console);
    }
    const auto& machine = mesh_parts(press, console);
    show(options, report::plan_text(description, machine));
    for (const auto& warning : report::plan_warnings(description, machine)) {
        console.warn(warning);
    }
    press.check(warnings);
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
