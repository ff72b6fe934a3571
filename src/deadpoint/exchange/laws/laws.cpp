#include "deadpoint/exchange/laws/laws.hpp"

#include "deadpoint/core/hash.hpp"

#include <cstdio>

namespace deadpoint {

std::string text_of(const LawFormula& formula)
{
    std::string text = formula.name;
    const char* separator = ": ";
    for (const auto& [name, value] : formula.parameters) {
        char number[32];
        std::snprintf(number, sizeof number, "%.17g", value);
        text += separator + name + " = " + number;
        separator = ", ";
    }
    return text;
}

std::string hash_of(const LawFormula& formula) { return stable_hash(text_of(formula)); }

}  // namespace deadpoint
