#include "deadpoint/core/formula.hpp"

#include "deadpoint/error.hpp"

#include <cmath>
#include <muParser.h>
#include <numbers>
#include <string_view>

namespace deadpoint {

struct Formula::Parser {
    std::string text;
    double x = 0, y = 0, z = 0, t = 0;
    mu::Parser parser;
};

namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& reason)
{
    throw InputError("'" + text + "' is not a formula: " + reason +
                     "; write it in x, y, z (metres) and t (seconds), like \"293.15 + 10*sin(pi*t/60)\"");
}

/// An '=' that is not part of "==", "!=", "<=" or ">=".
bool has_assignment(const std::string& text)
{
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '=') {
            continue;
        }
        if (i + 1 < text.size() && text[i + 1] == '=') {
            ++i;
        } else if (i == 0 || std::string_view("!<>").find(text[i - 1]) == std::string_view::npos) {
            return true;
        }
    }
    return false;
}

}  // namespace

Formula::Formula(const std::string& text) : parser_(std::make_unique<Parser>())
{
    if (text.find_first_not_of(" \t") == std::string::npos) {
        refuse(text, "it is empty");
    }
    if (has_assignment(text)) {
        refuse(text, "it assigns a value, where it should only have one");
    }
    auto& p = *parser_;
    p.text = text;
    try {
        p.parser.DefineConst("pi", std::numbers::pi);
        p.parser.DefineConst("e", std::numbers::e);
        p.parser.DefineVar("x", &p.x);
        p.parser.DefineVar("y", &p.y);
        p.parser.DefineVar("z", &p.z);
        p.parser.DefineVar("t", &p.t);
        p.parser.SetExpr(text);
        p.parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
        refuse(text, error.GetMsg());
    }
    if (p.parser.GetNumResults() != 1) {
        refuse(text, "its commas divide it into " + std::to_string(p.parser.GetNumResults()) +
                         " results, but it needs one; a decimal mark is a point");
    }
}
Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;

double Formula::operator()(const Vec3& position, double time) const
{
    parser_->x = position[0];
    parser_->y = position[1];
    parser_->z = position[2];
    parser_->t = time;
    const double value = parser_->parser.Eval();
    if (!std::isfinite(value))
        throw DomainError("the formula '" + parser_->text + "' is not finite at x = " + std::to_string(position[0]) +
                          ", y = " + std::to_string(position[1]) + ", z = " + std::to_string(position[2]) +
                          ", t = " + std::to_string(time));
    return value;
}

bool Formula::depends_on_place() const
{
    const auto& used = parser_->parser.GetUsedVar();
    return used.contains("x") || used.contains("y") || used.contains("z");
}

}  // namespace deadpoint
