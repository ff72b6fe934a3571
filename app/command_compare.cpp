#include "commands.hpp"
#include "console.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/compare/compare.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/compare/compare_files.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <optional>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct CompareOptions {
    std::string folder;
    std::string reference;
    std::string output;
    std::string point;
    std::string baseline;
    bool force = false;
    Console::Options console;
};

/// Whether the result was computed at the operating point: its settings must not change the case of the result.
std::optional<std::string> point_warning(const press::RunRecord& run, const casefile::ReferencePoint& point,
                                         const std::string& name)
{
    const fs::path file = fs::path(run.folder) / "case.toml";
    report::ResultFiles(run.folder).check("case.toml");
    try {
        const auto as_set = casefile::read_case(file, point.set, casefile::FileAccess::anywhere).value;
        if (casefile::case_hash(as_set) == run.hash) {
            return std::nullopt;
        }
    } catch (const Error& error) {
        return fmt::format("'{}' cannot be read, so that it is not known whether the result belongs to the operating "
                           "point '{}': {}",
                           file.string(), name, error.what());
    }
    return fmt::format("the result was not computed at the operating point '{}' of the reference: its settings ({}) "
                       "would change the case",
                       name, fmt::join(point.set, ", "));
}

/// DIR/compare, or the name given without .json or .md.
fs::path output_stem(const CompareOptions& options)
{
    if (options.output.empty()) {
        return fs::path(options.folder) / "compare";
    }
    fs::path stem = options.output;
    if (stem.extension() == ".json" || stem.extension() == ".md") {
        stem.replace_extension();
    }
    return stem;
}

/// Whether files of these names are replaced: those in the folder of results are renewed, others are the user's.
/// @throws IoError if they are there and must stay
IfThere replaced_files(const CompareOptions& options, const fs::path& stem)
{
    auto result = IfThere::refuse;
    for (const char* ending : report::compare_endings) {
        auto file = stem;
        file += ending;
        if (report::if_there(file, options.force, options.output.empty()) == IfThere::replace) {
            result = IfThere::replace;
        }
    }
    return result;
}

void compare(const CompareOptions& options)
{
    Console console(options.console);
    const auto stem = output_stem(options);
    const auto if_there = replaced_files(options, stem);
    const auto claim = claim_folder_of(stem, console);  // no other run may change the folder between reading and adding
    console.stage("reading the results");
    const auto run = report::read_result(options.folder);
    const auto contents = press::contents(run);
    const auto reference = casefile::read_reference(options.reference, options.point, &contents);
    std::optional<press::RunRecord> baseline;
    if (!options.baseline.empty()) {
        baseline = report::read_result(options.baseline);
        const auto offered = press::contents(*baseline);
        (void)casefile::read_reference(options.reference, options.point, &offered);
    }
    console.stage("comparison");
    auto comparison = press::compare(run, reference, options.point, baseline ? &*baseline : nullptr);
    if (!options.point.empty()) {
        if (auto warning = point_warning(run, reference.points.at(options.point), options.point)) {
            comparison.warnings.push_back(std::move(*warning));
        }
    }
    for (const auto& warning : comparison.warnings) {
        console.warn(warning);
    }
    console.finish();
    report::write_compare_files(stem, run, comparison, if_there);
    print_out("{}\ncomparison is in {}.md and {}.json\n", report::compare_text(run, comparison), stem.string(),
              stem.string());
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("compare", "compare a result with measured or published values");
    const auto options = std::make_shared<CompareOptions>();
    command->add_option("DIR", options->folder, "a folder that 'run' has written")->required();
    command->add_option("REFERENCE", options->reference, "the reference file")->required()->type_name("FILE");
    command
        ->add_option("--point", options->point,
                     "use the values of this operating point of the reference; default: values without one")
        ->type_name("NAME");
    command
        ->add_option("--baseline", options->baseline,
                     "also show the errors of another result, such as that of the base case")
        ->type_name("DIR");
    command
        ->add_option("-o,--output", options->output,
                     "write FILE.json and FILE.md instead of DIR/compare.json and DIR/compare.md")
        ->type_name("FILE");
    command->add_flag("--force", options->force, "replace the files that --output names if they exist");
    command->add_flag("-q,--quiet", options->console.quiet, "show warnings and results only");
    command->callback([options, &exit_code] {
        compare(*options);
        exit_code = 0;
    });
}
