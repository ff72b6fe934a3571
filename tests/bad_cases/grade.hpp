#pragma once

#include <algorithm>
#include <cstddef>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

/// How good the answer to a mistake is, by what a user needs to go on.
namespace grade {

/// What an answer has to say about a mistake.
struct Demands {
    std::vector<std::string> what;    ///< texts that say what is wrong: the user's own value or name, and the limit
    std::vector<std::string> remedy;  ///< texts of the help: the value, key or deed that mends it
    std::string place;                ///< a key, part, file or option; empty: a line that was changed
};

struct Grade {
    bool said = false;
    bool what = false;
    bool place = false;
    bool remedy = false;

    /// 3: says what is wrong, where, and what to do; 2: one of these is missing; 1: two are, or what is said misleads;
    /// 0: nothing is said.
    [[nodiscard]] int points() const
    {
        return said ? std::max(1, static_cast<int>(what) + static_cast<int>(place) + static_cast<int>(remedy)) : 0;
    }
};

/// Whether all texts stand in one of the paragraphs.
inline bool holds_all(const std::string& text, const std::vector<std::string>& wanted)
{
    return std::ranges::all_of(wanted, [&](const auto& one) { return text.find(one) != std::string::npos; });
}

/// @param answer   the standard error of the command
/// @param changed  lines of the case that hold the mistake, from 1
inline Grade of(const std::string& answer, const Demands& demands, const std::set<int>& changed)
{
    std::string said, help;
    Grade grade;
    std::istringstream lines(answer);
    for (std::string line; std::getline(lines, line);) {
        const auto begin = line.find("help: ");
        const bool shown = std::regex_search(line, std::regex(R"(^ *\d* \| )"));  // the case itself
        help += begin != std::string::npos ? line.substr(begin) + "\n" : "";
        said += shown ? "" : line.substr(0, begin) + "\n";
        std::smatch place;
        if (std::regex_search(line, place, std::regex(R"(\.toml:(\d+):)"))) {
            grade.place = grade.place || (demands.place.empty() && changed.contains(std::stoi(place[1])));
        }
    }
    grade.said = !answer.empty();
    grade.what = !demands.what.empty() && holds_all(said, demands.what);
    grade.remedy = !demands.remedy.empty() && holds_all(help, demands.remedy);
    if (!demands.place.empty()) {
        grade.place = (said + help).find(demands.place) != std::string::npos;
    }
    return grade;
}

}  // namespace grade
