#include "commands.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/report/design/optimise_files.hpp"
#include "deadpoint/report/design/sensitivity_files.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/page/page.hpp"
#include "deadpoint/report/page/sweep_page.hpp"
#include "interrupt.hpp"
#include "options/result_options.hpp"
#include "output.hpp"
#include "results/open_page.hpp"
#include "results/pictures.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

struct ReportOptions {
    std::vector<fs::path> folders;
    std::string file;
    std::string pictures;
    bool force = false;
};

/// The page of a single folder belongs to it and is renewed.
fs::path page_file(const ReportOptions& options)
{
    if (options.file.empty() && options.folders.size() != 1) {
        throw InputError("a page of several folders needs a name\n  help: add '-o compared.html'");
    }
    return options.file.empty() ? options.folders.front() / "report.html" : fs::path(options.file);
}

/// A kind of study: the file by which its folder is known, and its page.
struct StudyKind {
    const char* file;
    void (*write)(const fs::path& page, const fs::path& folder, IfThere if_there);
};

constexpr std::array study_kinds{StudyKind{"sweep.json", report::write_sweep_report},
                                 StudyKind{"sensitivity.json", report::write_sensitivity_page},
                                 StudyKind{"optimise.json", report::write_optimise_page}};

/// Null for results of a run or of loads.
const StudyKind* kind_of(const fs::path& folder)
{
    const auto found =
        std::ranges::find_if(study_kinds, [&](const StudyKind& kind) { return fs::exists(folder / kind.file); });
    return found == study_kinds.end() ? nullptr : &*found;
}

/// The page of a study or of results.
void write_page_of(const std::vector<fs::path>& folders, const fs::path& file, IfThere if_there)
{
    Console console({});
    const auto claim = claim_folder_of(file, console);  // no other run may change the folder between reading and adding
    console.stage("page");
    const auto study = std::ranges::find_if(folders, kind_of);
    if (study == folders.end()) {
        report::write_report(file, report::report_sources(folders), if_there);
        return;
    }
    if (folders.size() > 1) {
        throw InputError(
            fmt::format("'{}' is a study, which has its own page\n  help: name it alone, or the folders of "
                        "its points, '{}'",
                        study->string(), (*study / "points" / "NAME").string()));
    }
    kind_of(*study)->write(file, *study, if_there);
}

int make_report(const ReportOptions& options)
{
    if (!options.pictures.empty() && kind_of(options.folders.front())) {
        throw InputError(
            "a study has no view of the machine to take pictures of\n  help: take them from one of its points");
    }
    const auto file = page_file(options);
    const auto if_there = report::if_there(file, options.force, options.file.empty());
    if (!options.pictures.empty()) {
        require_new_pictures(options.pictures, options.force);
    }
    write_page_of(options.folders, file, if_there);
    print_out("the report is {}\n", file.string());
    if (options.pictures.empty()) {
        return 0;
    }
    Console console({});
    if (!take_pictures(file, options.pictures, console)) {
        return interrupted_exit_code;
    }
    console.finish();
    print_out("pictures of the machine are in {}\n", options.pictures);
    return 0;
}

/// @throws InputError if a table or a figure was changed since deadpoint wrote it
void require_unchanged(const fs::path& folder)
{
    const report::ResultFiles files(folder);
    for (const auto& [name, written] : files.listed()) {
        // A study that goes on writes its points and shards anew; no page reads them.
        const bool grows = name == "points.csv" || name.find('/') != std::string::npos;
        if (!grows && (name.ends_with(".json") || name.ends_with(".csv"))) {
            files.check(name);
        }
    }
}

bool is_current(const fs::path& page, const fs::path& folder)
{
    if (!fs::exists(page)) {
        return false;
    }
    for (const char* name : {"summary.json", "loads.json", "sweep.json", "sensitivity.json", "optimise.json"}) {
        if (fs::exists(folder / name) && fs::last_write_time(folder / name) > fs::last_write_time(page)) {
            return false;
        }
    }
    return true;
}

void open_report(const fs::path& folder)
{
    const auto page = folder / "report.html";
    require_unchanged(folder);
    const auto if_there = report::if_there(page, false, true);
    if (!is_current(page, folder)) {
        write_page_of({folder}, page, if_there);
    }
    open_page(page);
}

}  // namespace

void add_report(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("report", "put one or several results on one page (HTML) to read and send");
    const auto options = std::make_shared<ReportOptions>();
    command
        ->add_option("folders", options->folders,
                     "folders that 'run' or 'loads' wrote, or one of 'sweep', 'sensitivity' or 'optimise'")
        ->required()
        ->type_name("DIR...");
    command->add_option("-o,--output", options->file, "the page; default for a single folder: DIR/report.html")
        ->type_name("FILE");
    command
        ->add_option("--pictures", options->pictures,
                     "also write pictures of the machine (PNG) into this folder; needs Chromium")
        ->type_name("DIR");
    command->add_flag("--force", options->force, "replace files that exist");
    command->callback([options, &exit_code] { exit_code = make_report(*options); });
}

void add_view(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("view", "open the page of a results folder in the browser");
    const auto folder = std::make_shared<fs::path>();
    command->add_option("folder", *folder, "a folder that 'run', 'loads' or 'sweep' wrote")
        ->required()
        ->type_name("DIR");
    command->callback([folder, &exit_code] {
        open_report(*folder);
        exit_code = 0;
    });
}
