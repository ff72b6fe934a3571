#pragma once

#include "deadpoint/casefile/check.hpp"
#include "deadpoint/core/suggest.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Internal to casefile/: what checks of several files share.
namespace deadpoint::casefile {

/// Findings about names in a case, gathered one after the other.
class Findings {
public:
    explicit Findings(const Case& c) : c_(c) {}

    void add(Finding finding);
    std::vector<Finding> take() { return std::move(findings_); }
    void report(std::string code, std::string path, std::string message, std::string help);
    void warn(std::string code, std::string path, std::string message, std::string help);
    void report_unknown(const std::string& path, std::string_view kind, const std::string& name,
                        const std::vector<std::string>& names);
    template <class T>
    void refer(const std::string& path, std::string_view kind, const std::string& name,
               const std::map<std::string, T>& map)
    {
        if (!name.empty() && !map.contains(name)) {
            report_unknown(path, kind, name, names_of(map));
        }
    }
    /// A pattern that some part matches.
    void check_pattern(const std::string& path, const std::string& pattern);
    /// "part|part", each a pattern.
    void check_pair(const std::string& path, const std::string& pair);

protected:
    const Case& c_;

private:
    std::vector<Finding> findings_;
};

/// Foundation, preload, and what stress is asked for.
std::vector<Finding> check_elastic(const Case& c);

}  // namespace deadpoint::casefile
