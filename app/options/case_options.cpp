#include "options/case_options.hpp"

#include "deadpoint/report/run/run_files.hpp"

#include <langinfo.h>
#include <locale.h>
#include <string_view>

using namespace deadpoint;

void add_console_options(CLI::App& command, Console::Options& options)
{
    command.add_flag("-q,--quiet", options.quiet, "show warnings and results only");
    command.add_flag("-v,--verbose", options.verbose, "show more details");
}

namespace {

/// By the decimal mark of the user's locale (LC_ALL, LC_NUMERIC, LANG); a locale that is not installed has a point.
CsvStyle style_of_locale()
{
    const locale_t locale = newlocale(LC_NUMERIC_MASK, "", nullptr);
    if (locale == nullptr) {
        return CsvStyle::plain;
    }
    const bool comma = std::string_view(nl_langinfo_l(RADIXCHAR, locale)) == ",";
    freelocale(locale);
    return comma ? CsvStyle::comma : CsvStyle::plain;
}

}  // namespace

void add_table_option(CLI::App& command, CsvStyle& style)
{
    command
        .add_option_function<std::string>(
            "--csv",
            [&style](const std::string& name) { style = name == "locale" ? style_of_locale() : csv_style(name); },
            "tables with comment lines (comments), without them (plain), without them and with semicolons and "
            "decimal commas (comma), or the last two by the locale (locale)")
        ->type_name("STYLE")
        ->check(CLI::IsMember({"comments", "plain", "comma", "locale"}));
}

void add_file_access(CLI::App& command, casefile::FileAccess& files)
{
    command.add_flag_callback(
        "--allow-outside", [&files] { files = casefile::FileAccess::anywhere; },
        "let the case name files outside its own folder");
}

void add_case_options(CLI::App& command, CaseOptions& options)
{
    command.add_option("CASE", options.path, "the case file")->required()->type_name("FILE");
    command
        .add_option("--set", options.overrides,
                    "change a value of the case, e.g. --set \"operation.0.speed=400 rpm\"; may be repeated")
        ->type_name("PATH=VALUE")
        ->take_all();
    command.add_option("--size", options.size_scale, "scale all cell sizes: 2 is coarser and faster, 0.5 finer")
        ->type_name("FACTOR")
        ->check(CLI::Range(0.01, 100.0));
    add_file_access(command, options.files);
    add_console_options(command, options.console);
}

casefile::ReadResult read_case(const CaseOptions& options, Console& console)
{
    auto result = casefile::read_case(options.path, options.overrides, options.files);
    for (const auto& warning : result.warnings) {
        console.warn(warning);
    }
    return result;
}

std::vector<std::filesystem::path> input_files(const casefile::ReadResult& read)
{
    auto files = read.files;
    for (const auto& [name, part] : read.value.parts) {
        for (const auto& file : {part.step, part.mesh}) {
            if (!file.empty()) {
                files.emplace_back(file);
            }
        }
    }
    return files;
}

const Machine& mesh_parts(full::Press& press, Console& console, MeshedParts* kept)
{
    const auto& machine = press.machine(console, kept);
    console.finish();
    return machine;
}

std::vector<std::string> file_comments(const casefile::Case& description, const Console& console)
{
    return report::file_comments(description, console.warnings());
}
