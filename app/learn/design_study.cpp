#include "learn/design_study.hpp"

#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/io/resources.hpp"
#include "deadpoint/report/design/studied_case.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <filesystem>
#include <utility>

using namespace deadpoint;
namespace fs = std::filesystem;

int DesignOptions::threads() const { return jobs > 0 ? jobs : usable_cores(); }

void add_design_options(CLI::App& command, DesignOptions& options, const std::string& section, const std::string& jobs)
{
    command.add_option("study", options.study, "the study file (TOML), with a section [" + section + "]")
        ->required()
        ->type_name("STUDY");
    command.add_option("--reduced", options.reduced, "the reduced model of the base case, from 'deadpoint reduce'")
        ->required()
        ->type_name("FILE");
    command.add_option("-o,--output", options.folder, "the folder to write into; it must not exist")
        ->required()
        ->type_name("DIR");
    command.add_flag("--force", options.force,
                     "replace a folder that deadpoint wrote, once the new results are complete");
    command.add_option("-j,--jobs", options.jobs, jobs)->check(CLI::Range(1, 1024));
    add_table_option(command, options.tables);
    add_file_access(command, options.files);
    add_console_options(command, options.console);
}

casefile::ReadResult read_base(const DesignOptions& options, const casefile::StudyFile& study, Console& console)
{
    auto read = casefile::read_case(study.base, study.set, options.files);
    for (const auto& warning : read.warnings) {
        console.warn(warning);
    }
    return read;
}

std::unique_ptr<report::ResultFolder> begin_folder(const DesignOptions& options, const casefile::ReadResult& base,
                                                   Console& console)
{
    using IfExists = report::ResultFolder::IfExists;
    auto inputs = input_files(base);
    inputs.emplace_back(options.study);
    inputs.emplace_back(options.reduced);
    return std::make_unique<report::ResultFolder>(claim_folder(options.folder, console),
                                                  options.force ? IfExists::replace : IfExists::refuse, inputs);
}

report::StudiedCase studied_case(const DesignOptions& options, const casefile::StudyFile& study,
                                 const casefile::Case& base, std::chrono::steady_clock::time_point start)
{
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    return {study, base.machine.name, casefile::case_hash(base), fs::path(options.reduced).filename().string(),
            seconds.count()};
}

void print_design(const std::string& text, const DesignOptions& options)
{
    print_out("{}\nresults are in {}\nthe page is {}\n", text, options.folder,
              (fs::path(options.folder) / "report.html").string());
}
