#include "deadpoint/report/folder/table_style.hpp"

#include "deadpoint/io/read_file.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/table_heads.hpp"

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

}  // namespace deadpoint::report
