#include "deadpoint/report/folder/table_style.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

bool is_styled(const fs::path& file) { return file.extension() == ".csv" && file.filename() != "points.csv"; }

}  // namespace

void style_tables(const fs::path& folder, CsvStyle style)
{
    if (style == CsvStyle::comments) {
        return;
    }
    Json heads = Json::object();
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (!is_styled(entry.path())) {
            continue;
        }
        const auto text = read_file(entry.path(), largest_result).value_or("");
        heads[entry.path().filename().string()] = csv_comments(text);
        write_file(entry.path(), csv_in_style(text, style));
        record_file(entry.path());
    }
    write_json(folder / table_heads_name, {{"style", style == CsvStyle::plain ? "plain" : "comma"}, {"heads", heads}});
    record_file(folder / table_heads_name);
}

std::string usual_table(const std::string& name, const std::string& text, const std::string& heads)
{
    if (text.starts_with('#')) {
        return text;
    }
    try {
        const auto json = Json::parse(heads);
        const auto style = csv_style(json.at("style").get<std::string>());
        const auto comments = json.at("heads").at(name).get<std::vector<std::string>>();
        return csv_with_comments(text, style, comments);
    } catch (const nlohmann::json::exception&) {
        throw InputError(
            fmt::format("{} does not tell the head of {}\n  help: compute the case again", table_heads_name, name));
    }
}

}  // namespace deadpoint::report
