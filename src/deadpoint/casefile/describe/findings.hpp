#pragma once

#include "deadpoint/core/names/suggest.hpp"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Mistakes found in a case, and the list that collects them.
namespace deadpoint::casefile {

struct Case;

/// No press is colder [K]; a formula with a lower result was probably meant in degC.
inline constexpr double coldest_meant = 150;

/// A mistake in how the sections of a case refer to each other.
struct Finding {
    std::string code;
    std::string path;  ///< of the key at fault: "joints.crank_pin.bodies.1"
    std::string message;
    std::string help;
    bool warning = false;
};

/// Collects findings about names in a case.
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

}  // namespace deadpoint::casefile
