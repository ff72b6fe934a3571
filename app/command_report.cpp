#include "commands.hpp"
#include "deadpoint/core/error.hpp"
#include "deadpoint/report/page.hpp"

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <vector>

using namespace deadpoint;
namespace fs = std::filesystem;

extern char** environ;

namespace {

struct ReportOptions {
    std::vector<fs::path> folders;
    std::string file;
    bool force = false;
};

/// The page of a single folder belongs to it and is renewed; a file named by the user is not overwritten unasked.
fs::path page_file(const ReportOptions& options)
{
    if (options.file.empty()) {
        if (options.folders.size() == 1) {
            return options.folders.front() / "report.html";
        }
        throw InputError("a page of several folders needs a name\n  help: add '-o compared.html'");
    }
    if (fs::exists(options.file) && !options.force) {
        throw IoError(
            fmt::format("'{}' exists\n  help: choose another name, or add --force to replace it", options.file));
    }
    return options.file;
}

void make_report(const ReportOptions& options)
{
    const auto file = page_file(options);
    report::write_report(file, report::report_sources(options.folders));
    fmt::print("the report is {}\n", file.string());
}

bool run_program(const std::string& name, const std::string& argument)
{
    std::string program = name, text = argument;
    std::array<char*, 3> arguments{program.data(), text.data(), nullptr};
    pid_t child = 0;
    if (posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments.data(), environ) != 0) {
        return false;
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool is_current(const fs::path& page, const fs::path& folder)
{
    if (!fs::exists(page)) {
        return false;
    }
    for (const char* name : {"summary.json", "loads.json"}) {
        if (fs::exists(folder / name) && fs::last_write_time(folder / name) > fs::last_write_time(page)) {
            return false;
        }
    }
    return true;
}

void open_report(const fs::path& folder)
{
    const auto page = folder / "report.html";
    if (!is_current(page, folder)) {
        report::write_report(page, report::report_sources(std::vector{folder}));
    }
    const auto shown = fs::absolute(page).lexically_normal().string();
    std::vector<std::string> openers{"xdg-open", "open", "wslview"};
    if (const char* browser = std::getenv("BROWSER"); browser && *browser) {
        openers.insert(openers.begin(), browser);
    }
    for (const auto& opener : openers) {
        if (run_program(opener, shown)) {
            fmt::print("opened {}\n", shown);
            return;
        }
    }
    fmt::print("found no browser to open; the page is {}\n", shown);
}

}  // namespace

void add_report(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("report", "put one or several results on one page (HTML) to read and send");
    const auto options = std::make_shared<ReportOptions>();
    command->add_option("folders", options->folders, "folders that 'run' or 'loads' wrote")
        ->required()
        ->type_name("DIR...");
    command->add_option("-o,--output", options->file, "the page; of a single folder it is DIR/report.html if not given")
        ->type_name("FILE");
    command->add_flag("--force", options->force, "replace the file if it exists");
    command->callback([options, &exit_code] {
        make_report(*options);
        exit_code = 0;
    });
}

void add_view(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("view", "open the page of a results folder in the browser");
    const auto folder = std::make_shared<fs::path>();
    command->add_option("folder", *folder, "a folder that 'run' or 'loads' wrote")->required()->type_name("DIR");
    command->callback([folder, &exit_code] {
        open_report(*folder);
        exit_code = 0;
    });
}
