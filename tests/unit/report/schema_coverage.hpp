#pragma once

#include "deadpoint/report/schema/schema.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// What a file holds against what the schema says of it.
namespace deadpoint::report {

using Steps = std::vector<std::string>;

inline Steps steps_of(const std::string& path)
{
    Steps steps;
    std::istringstream in(path);
    for (std::string step; std::getline(in, step, '/');) {
        steps.push_back(step);
    }
    return steps;
}

/// A value without names of its own: a number, a text, a list of them.
inline bool is_leaf(const nlohmann::ordered_json& value)
{
    return !value.is_object() && std::ranges::none_of(value, [](const auto& entry) { return entry.is_object(); });
}

/// Paths of everything in a document, with "[]" for each entry of a list.
inline void collect(const nlohmann::ordered_json& value, const Steps& steps, std::set<Steps>& found)
{
    if (is_leaf(value)) {
        found.insert(steps);
        return;
    }
    for (const auto& [name, entry] : value.items()) {
        auto below = steps;
        below.push_back(value.is_array() ? "[]" : name);
        collect(entry, below, found);
    }
}

/// Whether a path is of a pattern, or ends on the way to it: what is empty ends early.
inline bool fits(const Steps& steps, const Steps& pattern, bool to_its_end)
{
    if (steps.size() > pattern.size() || (to_its_end && steps.size() < pattern.size())) {
        return false;
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i] != pattern[i] && (!pattern[i].starts_with('{') || steps[i] == "[]")) {
            return false;
        }
    }
    return true;
}

/// Collects what was written, file by file.
class SchemaCoverage {
public:
    /// @return what the schema does not know
    std::vector<std::string> document(const std::string& file, const nlohmann::ordered_json& json)
    {
        std::set<Steps> found;
        collect(json, {}, found);
        std::vector<std::string> unknown;
        for (const auto& steps : found) {
            bool known = false;
            for (const auto& key : schema::file(file).keys) {
                const auto pattern = steps_of(key.path);
                known = known || fits(steps, pattern, false);
                if (fits(steps, pattern, true)) {
                    seen_[schema::file(file).name].insert(key.path);
                }
            }
            if (!known) {
                std::string path = file + ":";
                for (const auto& step : steps) {
                    path += "/" + step;
                }
                unknown.push_back(path);
            }
        }
        return unknown;
    }
    std::vector<std::string> table(const std::string& file, const std::string& text)
    {
        const std::string mark = "# columns: ";
        const auto at = text.rfind(mark) + mark.size();
        std::istringstream line(text.substr(at, text.find('\n', at) - at));
        std::vector<std::string> unknown;
        for (std::string kind; line >> kind;) {
            kind = kind.substr(0, kind.find(','));
            if (schema::file(file).column(kind) == nullptr) {
                unknown.push_back(file + ": " + kind);
            }
            seen_[schema::file(file).name].insert(kind);
        }
        return unknown;
    }
    /// What the schema names and nobody has written.
    [[nodiscard]] std::vector<std::string> unwritten() const
    {
        std::vector<std::string> left;
        for (const auto& file : schema::files()) {
            const auto seen = seen_.contains(file.name) ? seen_.at(file.name) : std::set<std::string>();
            for (const auto& key : file.keys) {
                if (!seen.contains(key.path)) {
                    left.push_back(file.name + ": " + key.path);
                }
            }
            for (const auto& column : file.columns) {
                if (!seen.contains(std::string(column.kind))) {
                    left.push_back(file.name + ": " + std::string(column.kind));
                }
            }
        }
        return left;
    }

private:
    std::map<std::string, std::set<std::string>> seen_;
};

}  // namespace deadpoint::report
