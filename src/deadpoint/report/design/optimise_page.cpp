#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/csv_table.hpp"
#include "deadpoint/report/design/optimise_files.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_json.hpp"
#include "deadpoint/report/folder/result_table.hpp"
#include "deadpoint/report/page/page_parts.hpp"
#include "deadpoint/report/page/page_shell.hpp"
#include "deadpoint/report/page/page_tables.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <array>
#include <fmt/format.h>

namespace deadpoint::report {

void write_optimise_page(const std::filesystem::path& file, const std::filesystem::path& folder, IfThere if_there)
{
    using Json = nlohmann::ordered_json;
    const ResultFiles files(folder);
    const auto found = read_json(files, "optimise.json");
    const auto table = files.read("search.csv");
    if (!found || !table)
        throw IoError(fmt::format("there is no '{}'\n  help: run the study again",
                                  (folder / (found ? "search.csv" : "optimise.json")).string()));
    PageContent content;
    content.data = {{"version", version},
                    {"schema", Json::parse(schema::script_json())},
                    {"runs", Json::array()},
                    {"optimise", *found},
                    {"courses", files.read("courses.csv").value_or("")}};
    try {
        content.title = found->at("study").at("name").get<std::string>();
    } catch (const Json::exception&) {
        throw InputError(fmt::format("{}: a figure is missing or of another kind\n  help: it is from another version "
                                     "of the program; run the study again",
                                     (folder / "optimise.json").string()));
    }
    content.without_scripts =
        "<p>This page draws its charts with scripts, which are switched off here; they are missing below.</p>\n" +
        table_html("Search", ResultTable(*table, (folder / "search.csv").string()).csv());
    const std::array scripts{page_data_script(), page_charts_script(), page_optimise_script()};
    write_page(file, content, scripts, if_there);
}

}  // namespace deadpoint::report
