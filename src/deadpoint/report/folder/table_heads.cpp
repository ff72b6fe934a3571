#include "deadpoint/report/folder/table_heads.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/csv_style.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <vector>

namespace deadpoint::report {

using Json = nlohmann::ordered_json;

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
