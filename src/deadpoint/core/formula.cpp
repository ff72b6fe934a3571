#include "deadpoint/core/formula.hpp"

#include "deadpoint/core/error.hpp"

#include <cmath>
#include <muParser.h>
#include <numbers>

namespace deadpoint {

struct Formula::Parser {
    std::string text;
    double x = 0, y = 0, z = 0, t = 0;
    mu::Parser parser;
};

Formula::Formula(const std::string& text) : parser_(std::make_unique<Parser>())
{
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
        throw InputError("'" + text + "' is not a formula: " + error.GetMsg() +
                         "; write it in x, y, z (metres) and t (seconds), like \"293.15 + 10*sin(pi*t/60)\"");
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

}  // namespace deadpoint
