#include "deadpoint/report/design/studied_case.hpp"

#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/report/design/studied_json.hpp"

#include <fmt/format.h>

namespace deadpoint::report {

std::vector<std::string> comments_of(const StudiedCase& studied, const std::vector<std::string>& warnings)
{
    std::vector<std::string> lines{fmt::format("deadpoint {}", version),
                                   fmt::format("study {}, base case {}", studied.study.name, studied.study.base),
                                   fmt::format("machine {}, case hash {}", studied.machine, studied.hash),
                                   fmt::format("computed on the reduced model {}", studied.reduced_model)};
    for (const auto& warning : warnings)
        lines.push_back("warning: " + warning);
    return lines;
}

nlohmann::ordered_json json_of(const StudiedCase& studied, const std::vector<std::string>& warnings)
{
    nlohmann::ordered_json json{{"version", version}, {"case", {{"name", studied.machine}, {"hash", studied.hash}}}};
    json["study"] = {{"name", studied.study.name},
                     {"note", studied.study.note},
                     {"base", studied.study.base},
                     {"overrides", studied.study.set}};
    json["reduced_model"] = studied.reduced_model;
    json["warnings"] = warnings;
    json["seconds"] = studied.seconds;
    return json;
}

}  // namespace deadpoint::report
