#include "commands.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/syntax/diagnostics.hpp"
#include "deadpoint/casefile/syntax/document.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/full/model/sketch.hpp"
#include "deadpoint/machine/parts/meshed_parts.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/report/loads/loads_files.hpp"
#include "deadpoint/report/mesh/plan_text.hpp"
#include "deadpoint/report/page/check_page.hpp"
#include "deadpoint/report/page/named_things.hpp"
#include "options/case_options.hpp"
#include "output.hpp"
#include "results/open_page.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct CheckOptions {
    CaseOptions input;
    bool view = false;
    std::string file;
    bool force = false;
};

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

/// Progress without warnings: what a picture needs is built again, and was warned about.
class Progress : public Observer {
public:
    explicit Progress(Console& console) : console_(console) {}
    void stage(std::string_view name) override { console_.stage(name); }
    void progress(double fraction, std::string_view detail) override { console_.progress(fraction, detail); }
    [[nodiscard]] bool cancelled() const override { return console_.cancelled(); }

private:
    Console& console_;
};

/// @param meshed  becomes the machine as soon as it is there
/// @param kept    gets the meshes of parts; may be null
void check_press(const CaseOptions& options, full::Press& press, const Machine*& meshed, MeshedParts* kept,
                 Console& console)
{
    const auto& description = press.input();
    Warnings warnings(console);
    if (description.parts.empty()) {
        show(options, report::linkage_plan_text(description));
        press.check(warnings);  // does the linkage move?
        return summarise(options, console);
    }
    const auto& machine = mesh_parts(press, console, kept);
    meshed = &machine;
    show(options, report::plan_text(description, machine));
    press.check(warnings);
    summarise(options, console);
}

void check(const CaseOptions& options)
{
    Console console(options.console);
    full::Press press(read_case(options, console).value, options.size_scale);
    const Machine* meshed = nullptr;
    check_press(options, press, meshed, nullptr, console);
}

// ---------------------------------------------------------------- with a picture

fs::path page_file(const CheckOptions& options)
{
    return options.file.empty() ? fs::path(options.input.path).replace_extension(".check.html")
                                : fs::path(options.file);
}

/// The page next to the case is renewed as long as nobody has changed it. @throws IoError if the file must stay
IfThere page_there(const CheckOptions& options)
{
    const auto page = page_file(options);
    const bool renews = options.file.empty() && report::is_unchanged_page(page);
    return renews ? IfThere::replace : report::if_there(page, options.force);
}

/// A case as far as it can be read.
casefile::Case read_partly(const CaseOptions& options)
{
    casefile::Case result;
    casefile::Diagnostics found;
    casefile::read_case(options.path, options.overrides, result, found, options.files);
    return result;
}

/// What an error says of the case.
std::vector<Diagnostic> diagnostics_of(const Error& error)
{
    if (const auto* diagnosed = dynamic_cast<const Diagnosed*>(&error)) {
        return diagnosed->diagnostics();
    }
    const auto said = split_help(error.what());
    return {{{}, {}, DiagnosticSeverity::error, {}, said.message, said.help}};
}

/// All that can be drawn of a case, which is meshed already or has mistakes.
press::CaseSketch sketch(const CaseOptions& options, const casefile::Case& input, const Machine* meshed,
                         MeshedParts& kept, Console& console)
{
    if (meshed != nullptr) {
        return full::sketch_of(*meshed);
    }
    Progress progress(console);
    auto result = full::sketch_case(input, options.size_scale, progress, kept);
    console.finish();
    return result;
}

/// Writes and opens the page.
/// @param found  besides the warnings of the console
void draw(const CheckOptions& options, const casefile::Case& input, const press::CaseSketch& sketch,
          std::vector<Diagnostic> found, const Console& console)
{
    for (const auto& warning : console.warnings()) {
        found.push_back(report::taken_apart(warning));
    }
    report::write_check_page(page_file(options), input, sketch, found, page_there(options));
    open_page(page_file(options));
}

/// As check(), with the page in any case; then the errors.
void check_and_draw(const CheckOptions& all)
{
    const auto& options = all.input;
    (void)page_there(all);  // refused before anything is meshed
    Console console(options.console);
    std::unique_ptr<full::Press> press;
    const Machine* meshed = nullptr;
    MeshedParts kept;
    try {
        press = std::make_unique<full::Press>(read_case(options, console).value, options.size_scale);
        check_press(options, *press, meshed, &kept, console);
    } catch (const IoError&) {
        throw;
    } catch (const Error& error) {
        console.finish();
        const auto input = press ? press->input() : read_partly(options);
        if (input.parts.empty() && input.joints.empty()) {
            console.note("no page is written: nothing of the case can be read");
            throw;
        }
        draw(all, input, sketch(options, input, meshed, kept, console), diagnostics_of(error), console);
        throw;
    }
    draw(all, press->input(), sketch(options, press->input(), meshed, kept, console), {}, console);
}

}  // namespace

void add_check(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("check", "check a case without solving it, and print the plan");
    const auto options = std::make_shared<CheckOptions>();
    add_case_options(*command, options->input);
    auto* view = command->add_flag("--view", options->view,
                                   "draw the machine on a page and open it, also where the case has mistakes");
    command
        ->add_option("-o,--output", options->file, "the page of --view; default: next to the case, as CASE.check.html")
        ->type_name("FILE")
        ->needs(view);
    command->add_flag("--force", options->force, "replace the page if it exists")->needs(view);
    command->callback([options, &exit_code] {
        options->view ? check_and_draw(*options) : check(options->input);
        exit_code = 0;
    });
}
