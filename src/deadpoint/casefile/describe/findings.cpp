#include "deadpoint/casefile/describe/findings.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/names/suggest.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <span>

namespace deadpoint::casefile {
namespace {

constexpr std::size_t most_shown = 30;
constexpr std::size_t most_findings = 10'000;  // a case with errors everywhere must not fill memory

}  // namespace

void Findings::add(Finding finding)
{
    if (findings_.size() < most_findings) {
        findings_.push_back(std::move(finding));
    }
}

void Findings::report(std::string code, std::string path, std::string message, std::string help)
{
    add({std::move(code), std::move(path), std::move(message), std::move(help), false});
}

void Findings::warn(std::string code, std::string path, std::string message, std::string help)
{
    add({std::move(code), std::move(path), std::move(message), std::move(help), true});
}

void Findings::report_unknown(const std::string& path, std::string_view kind, const std::string& name,
                              const std::vector<std::string>& names)
{
    const std::string near = closest_name(name, names);
    std::string help = fmt::format("did you mean '{}'?", near);
    if (near.empty()) {
        const std::span shown(names.data(), std::min(names.size(), most_shown));
        help = names.empty()
                   ? fmt::format("the case has no {} at all", kind)
                   : fmt::format("known: {}{}", fmt::join(shown, ", "), shown.size() < names.size() ? ", ..." : "");
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
