#include "deadpoint/report/folder/result_json.hpp"

#include "deadpoint/report/folder/json_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"

namespace deadpoint::report {

std::optional<nlohmann::ordered_json> read_json(const ResultFiles& files, const std::string& name)
{
    const auto text = files.read(name);
    return text ? std::optional(parse_json(*text, files.folder() / name)) : std::nullopt;
}

}  // namespace deadpoint::report
