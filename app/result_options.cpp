#include "result_options.hpp"

using deadpoint::report::ResultFolder;

void add_result_options(CLI::App& command, ResultOptions& options)
{
    add_case_options(command, options);
    command.add_option("-o,--output", options.folder, "the folder to write into; it must not exist")
        ->required()
        ->type_name("DIR");
    command.add_flag("--force", options.force, "replace the folder if it exists, once the results are complete");
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

std::unique_ptr<ResultFolder> start_folder(const ResultOptions& options)
{
    using enum ResultFolder::IfExists;
    return std::make_unique<ResultFolder>(options.folder, options.force ? replace : refuse);
}
