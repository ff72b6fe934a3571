#include "deadpoint/casefile/check/check_bonds.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/core/names/pattern_pair.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::casefile {
namespace {

/// What a pair of patterns finds among the parts of a case.
struct Named {
    bool one_body = false;
    std::string body_a, body_b;  ///< of the last pair of two bodies; empty: no two parts at all
};

Named named_by(const Case& c, const PatternPair& pair)
{
    Named result;
    for (const auto& [a, part_a] : c.parts)
        for (const auto& [b, part_b] : c.parts) {
            if (a >= b || !pair.names(a, b))
                continue;
            if (part_a.body == part_b.body)
                return {true, {}, {}};
            result.body_a = part_a.body;
            result.body_b = part_b.body;
        }
    return result;
}

class BondChecker : private Findings {
public:
    explicit BondChecker(const Case& c) : Findings(c) {}

    std::vector<Finding> run()
    {
        for (const auto& [name, bond] : c_.bonds) {
            if (bond.between.empty())
                report("missing-key", fmt::format("bonds.{}.between", name), "the bond names no parts",
                       "write it like between = [\"motor|frame\"]");
            for (std::size_t i = 0; i < bond.between.size(); ++i)
                check(fmt::format("bonds.{}.between.{}", name, i), bond.between[i]);
        }
        return take();
    }

private:
    void check(const std::string& path, const std::string& text)
    {
        const auto pair = pattern_pair(text);
        if (!pair)
            return report("inconsistent", path, fmt::format("'{}' is not a pair of parts", text),
                          "write it like \"part|other_part\"");
        check_pattern(path, pair->first);
        check_pattern(path, pair->second);
        const bool both_known = has_part(pair->first) && has_part(pair->second);
        const auto found = named_by(c_, *pair);
        if (!both_known || found.one_body)
            return;
        if (found.body_a.empty())
            return report("inconsistent", path, fmt::format("'{}' names one part only", text),
                          "name the two parts that touch");
        report("inconsistent", path,
               fmt::format("'{}' belong to two bodies, '{}' and '{}'", text, found.body_a, found.body_b),
               "bonds are within a body: make the contact an interface of the joint that connects the bodies");
    }

    [[nodiscard]] bool has_part(const std::string& pattern) const
    {
        return std::ranges::any_of(c_.parts, [&](const auto& part) { return matches(pattern, part.first); });
    }
};

}  // namespace

std::vector<Finding> check_bonds(const Case& c) { return BondChecker(c).run(); }

}  // namespace deadpoint::casefile
