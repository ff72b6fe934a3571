#include "deadpoint/report/page/run_folder.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/io/plain_reason.hpp"
#include "deadpoint/press/run/run_outputs.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_folder.hpp"
#include "deadpoint/report/folder/table_style.hpp"
#include "deadpoint/report/page/page.hpp"
#include "deadpoint/report/run/run_files.hpp"

#include <array>
#include <fmt/format.h>

namespace deadpoint::report {
namespace {

/// @return why there is none
std::string add_page(const ResultFolder& folder)
{
    const std::array sources{ReportSource{folder.path(), folder.target().filename().string()}};
    const auto page = folder.path() / "report.html";
    try {
        write_report(page, sources);
        return {};
    } catch (const std::exception& error) {
        std::error_code ignored;
        std::filesystem::remove(page, ignored);
        return fmt::format("report.html is missing: {}", plain_reason(error));
    }
}

}  // namespace

void write_along(press::RunOutputs& outputs, const std::string& folder, const casefile::Case& input,
                 const std::vector<std::string>& warnings)
{
    outputs.state_file = folder + "/state.bin";
    outputs.kept_checkpoint = folder + "/" + kept_checkpoint;
    outputs.field_folder = input.output.fields ? folder : std::string{};
    outputs.comments = file_comments(input, warnings);
    outputs.view = true;
}

std::string finish_run_folder(ResultFolder& folder, const casefile::Case& input, const Machine& machine,
                              const press::RunResult& result, const std::vector<std::string>& warnings, CsvStyle style)
{
    write_run_files(folder.path(), input, machine, result, warnings);
    write_manifest(folder.path());
    auto problem = add_page(folder);
    style_tables(folder.path(), style);
    folder.commit();
    return problem;
}

}  // namespace deadpoint::report
