#include "deadpoint/reduce/online/box.hpp"

#include "deadpoint/exchange/heat.hpp"

#include <cmath>
#include <functional>

namespace deadpoint::reduce {
namespace {

using Kind = FreeCoefficient::Kind;

constexpr double climate_time = 900;  // [s]
constexpr double share_without_oil = 0.2;

void for_each_laws(HeatProblem& problem, const std::function<void(std::vector<InterfaceLaw>&)>& change)
{
    change(problem.interfaces);
    for (auto& segment : problem.segments)
        if (!segment.interfaces.empty())
            change(segment.interfaces);
}

TimeCourse shifted(const TimeCourse& course, double difference)
{
    return course.plus([difference](double time) { return difference * (1 - std::exp(-time / climate_time)); },
                       climate_time / 8);
}

void shift_ambient(HeatProblem& problem, double difference)
{
    for (auto& segment : problem.segments)
        segment.ambient = shifted(segment.ambient, difference);
    for (auto& condition : problem.surfaces)
        if (condition.ambient)
            condition.ambient = shifted(condition.ambient, difference);
}

void shift_oil(HeatProblem& problem, double difference)
{
    for_each_laws(problem, [&](std::vector<InterfaceLaw>& laws) {
        for (auto& law : laws)
            law.oil_temperature += difference;
    });
    for (auto& circuit : problem.oil)
        circuit.inlet_temperature += difference;
}

void set_film(HeatProblem& problem, const FreeCoefficient& film, double factor)
{
    for (std::size_t k = 0; k < film.members.size(); ++k) {
        auto& condition = problem.surfaces[film.members[k]];
        condition.laws.clear();
        condition.emissivity = 0;
        condition.coefficient = factor * film.base[k];
    }
}

void set_joints(HeatProblem& problem, const FreeCoefficient& coefficient, double factor)
{
    for_each_laws(problem, [&](std::vector<InterfaceLaw>& laws) {
        for (std::size_t k = 0; k < coefficient.members.size(); ++k) {
            const auto member = coefficient.members[k];
            if (coefficient.kind == Kind::oil)
                laws[member].oil = factor * coefficient.base[k];
            else
                (member % 2 == 0 ? laws[member / 2].film_a : laws[member / 2].film_b) *= factor;
        }
    });
}

void set_value(HeatProblem& problem, const FreeCoefficient& coefficient, double value)
{
    switch (coefficient.kind) {
    case Kind::film:
        return set_film(problem, coefficient, value);
    case Kind::side:
    case Kind::oil:
        return set_joints(problem, coefficient, value);
    case Kind::heat:
        for (const auto source : coefficient.members)
            problem.sources[source].share *= value;
        return;
    case Kind::oil_temperature:
        return shift_oil(problem, value);
    case Kind::ambient:
        return shift_ambient(problem, value);
    }
}

bool is_even_in_logarithm(const FreeCoefficient& c)
{
    return (c.kind == Kind::film || c.kind == Kind::side || c.kind == Kind::heat) && c.from > 0;
}

}  // namespace

void set_values(HeatProblem& problem, const Box& box, const std::vector<double>& values)
{
    for (std::size_t k = 0; k < box.size(); ++k)
        set_value(problem, box[k], values[k]);
}

// SplitMix64 (Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014).
double Draws::next()
{
    state_ += 0x9e3779b97f4a7c15ULL;
    auto z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    z ^= z >> 31;
    return static_cast<double>(z >> 11) * 0x1p-53;
}

std::vector<double> Draws::values(const Box& box)
{
    const bool without_oil = next() < share_without_oil;
    std::vector<double> values;
    for (const auto& c : box) {
        const double place = next();
        if (c.kind == Kind::oil && without_oil)
            values.push_back(c.from);
        else if (is_even_in_logarithm(c))
            values.push_back(c.from * std::pow(c.to / c.from, place));
        else
            values.push_back(c.from + (c.to - c.from) * place);
    }
    return values;
}

}  // namespace deadpoint::reduce
