#include "options/result_options.hpp"

#include "deadpoint/report/folder/table_style.hpp"

#include <unistd.h>

using namespace deadpoint;
using report::FolderClaim;
using report::ResultFolder;

void add_result_options(CLI::App& command, ResultOptions& options)
{
    add_case_options(command, options);
    command.add_option("-o,--output", options.folder, "the folder to write into; it must not exist")
        ->required()
        ->type_name("DIR");
    command.add_flag("--force", options.force,
                     "replace a folder that deadpoint wrote, once the new results are complete");
    add_table_option(command, options.tables);
}

void add_segment_options(CLI::App& command, SegmentOptions& options)
{
    add_result_options(command, options);
    command
        .add_option("--segment", options.segment,
                    "segment of the operation, counted from 0; else the first in which the press runs")
        ->type_name("N")
        ->check(CLI::Range(0, 9999));
}

FolderClaim claim_folder(const std::filesystem::path& target, Console& console)
{
    FolderClaim claim(target);
    for (const auto& note : claim.take_notes()) {
        console.note(note);
    }
    return claim;
}

std::optional<FolderClaim> claim_folder_of(const std::filesystem::path& file, Console& console)
{
    const auto folder = report::folder_above(file);
    if (!report::is_whole(folder)) {
        return std::nullopt;
    }
    const auto whole = std::filesystem::canonical(folder);
    if (access(whole.parent_path().c_str(), W_OK) != 0) {
        return std::nullopt;
    }
    return claim_folder(whole, console);
}

std::unique_ptr<ResultFolder> start_folder(const ResultOptions& options, const casefile::ReadResult& read,
                                           Console& console)
{
    using enum ResultFolder::IfExists;
    return std::make_unique<ResultFolder>(claim_folder(options.folder, console), options.force ? replace : refuse,
                                          input_files(read));
}

void commit(ResultFolder& folder, CsvStyle tables, Console& console)
{
    report::style_tables(folder.path(), tables);
    folder.commit();
    for (const auto& note : folder.take_notes()) {
        console.note(note);
    }
}
