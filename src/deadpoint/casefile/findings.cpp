#include "deadpoint/casefile/findings.hpp"

#include "deadpoint/core/suggest.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::casefile {

bool matches(std::string_view pattern, std::string_view name)
{
    if (pattern.empty()) {
        return name.empty();
    }
    if (pattern.front() == '*') {
        return matches(pattern.substr(1), name) || (!name.empty() && matches(pattern, name.substr(1)));
    }
    return !name.empty() && pattern.front() == name.front() && matches(pattern.substr(1), name.substr(1));
}

void Findings::report(std::string code, std::string path, std::string message, std::string help)
{
    findings_.push_back({std::move(code), std::move(path), std::move(message), std::move(help), false});
}

void Findings::warn(std::string code, std::string path, std::string message, std::string help)
{
    findings_.push_back({std::move(code), std::move(path), std::move(message), std::move(help), true});
}

void Findings::report_unknown(const std::string& path, std::string_view kind, const std::string& name,
                              const std::vector<std::string>& names)
{
    const std::string near = closest_name(name, names);
    std::string help = fmt::format("did you mean '{}'?", near);
    if (near.empty()) {
        std::string list;
        for (const auto& known : names) {
            list += (list.empty() ? "" : ", ") + known;
        }
        help = names.empty() ? fmt::format("the case has no {} at all", kind) : fmt::format("known: {}", list);
    }
    report("unknown-name", path, fmt::format("there is no {} '{}'", kind, name), help);
}

void Findings::check_pattern(const std::string& path, const std::string& pattern)
{
    const bool found = std::ranges::any_of(c_.parts, [&](const auto& part) { return matches(pattern, part.first); });
    if (found) {
        return;
    }
    if (pattern.find('*') == std::string::npos) {
        return report_unknown(path, "part", pattern, names_of(c_.parts));
    }
    report("unknown-name", path, fmt::format("no part matches '{}'", pattern), "`*` stands for any letters");
}

void Findings::check_pair(const std::string& path, const std::string& pair)
{
    const auto bar = pair.find('|');
    if (bar == std::string::npos) {
        return report("inconsistent", path, fmt::format("'{}' is not a pair of parts", pair),
                      "write it like \"part|other_part\"");
    }
    check_pattern(path, pair.substr(0, bar));
    check_pattern(path, pair.substr(bar + 1));
}

}  // namespace deadpoint::casefile
