#include "deadpoint/reduce/certificate/lowest.hpp"

#include "deadpoint/exchange/heat.hpp"

#include <algorithm>
#include <vector>

namespace deadpoint::reduce {
namespace {

struct Range {
    double from = 0, to = 0;
    void widen(double value)
    {
        from = std::min(from, value);
        to = std::max(to, value);
    }
    void scale(double least, double most)
    {
        from *= least;
        to *= most;
    }
};

struct JointRanges {
    Range a, b, oil;
    bool turns = false, changes_turning = false;
};

std::vector<JointRanges> ranges_of(const HeatProblem& base)
{
    std::vector<JointRanges> result;
    for (const auto& law : base.interfaces)
        result.push_back({{law.film_a, law.film_a}, {law.film_b, law.film_b}, {law.oil, law.oil}, law.turns_fully});
    for (const auto& segment : base.segments)
        for (std::size_t i = 0; i < segment.interfaces.size(); ++i) {
            const auto& law = segment.interfaces[i];
            result[i].a.widen(law.film_a);
            result[i].b.widen(law.film_b);
            result[i].oil.widen(law.oil);
            result[i].changes_turning |= law.turns_fully != result[i].turns;
        }
    return result;
}

void apply(const FreeCoefficient& free, std::vector<JointRanges>& ranges)
{
    using Kind = FreeCoefficient::Kind;
    for (std::size_t k = 0; k < free.members.size(); ++k) {
        const auto member = free.members[k];
        if (free.kind == Kind::side)
            (member % 2 == 0 ? ranges[member / 2].a : ranges[member / 2].b).scale(free.from, free.to);
        else if (free.kind == Kind::oil)
            ranges[member].oil = {free.from * free.base[k], free.to * free.base[k]};
    }
}

// The star a, b, oil of three conductances between its ends. Without oil's two it is a line of two equal halves.
InterfaceLaw star(double between, double to_oil_a, double to_oil_b, InterfaceLaw law)
{
    const double products = between * to_oil_a + between * to_oil_b + to_oil_a * to_oil_b;
    law.film_a = law.film_b = law.oil = 0;
    if (to_oil_a > 0 && to_oil_b > 0 && between > 0) {
        law.film_a = products / to_oil_b;
        law.film_b = products / to_oil_a;
        law.oil = products / between;
    } else if (between > 0) {
        law.film_a = law.film_b = 2 * between;
    } else {
        law.film_a = law.oil = 2 * to_oil_a;
        law.film_b = to_oil_a > 0 ? 0 : 1;
    }
    return law;
}

double share(double x, double y, double other) { return x > 0 && y > 0 ? x * y / (x + y + other) : 0; }

InterfaceLaw lowest(const JointRanges& ranges, const InterfaceLaw& law)
{
    const double between = ranges.changes_turning ? 0 : share(ranges.a.from, ranges.b.from, ranges.oil.to);
    return star(between, share(ranges.a.from, ranges.oil.from, ranges.b.to),
                share(ranges.b.from, ranges.oil.from, ranges.a.to), law);
}

std::vector<JointRanges> ranges_in(const HeatProblem& base, const Box& box)
{
    auto ranges = ranges_of(base);
    for (const auto& free : box)
        apply(free, ranges);
    return ranges;
}

}  // namespace

HeatProblem lowest_conduction(const HeatProblem& base, const Box& box)
{
    const auto ranges = ranges_in(base, box);
    auto result = base;
    result.segments.clear();
    for (const auto& free : box)
        for (std::size_t k = 0; k < free.members.size() && free.kind == FreeCoefficient::Kind::film; ++k)
            result.surfaces[free.members[k]].coefficient = free.from * free.base[k];
    for (std::size_t i = 0; i < ranges.size(); ++i)
        result.interfaces[i] = lowest(ranges[i], result.interfaces[i]);
    return result;
}

std::vector<double> highest_conduction(const HeatProblem& base, const Box& box)
{
    std::vector<double> result;
    for (const auto& [a, b, oil, turns, changes] : ranges_in(base, box)) {
        const double between = share(a.to, b.to, oil.from);
        result.insert(result.end(), {share(a.to, oil.to, b.from), share(b.to, oil.to, a.from),
                                     turns && !changes ? 0 : between, turns || changes ? between : 0});
    }
    const auto first_film = result.size();
    for (const auto& condition : base.surfaces)
        result.push_back(condition.kind == SurfaceCondition::Kind::film ? condition.coefficient : 0);
    for (const auto& free : box)
        for (std::size_t k = 0; k < free.members.size() && free.kind == FreeCoefficient::Kind::film; ++k)
            result[first_film + free.members[k]] = free.to * free.base[k];
    result.push_back(1);
    return result;
}

}  // namespace deadpoint::reduce
