#include "deadpoint/reduce/online/conduction_terms.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/films.hpp"

namespace deadpoint::reduce {

TermWeights conduction_terms(const DenseTerms& terms, const HeatProblem& problem, const std::vector<InterfaceLaw>& laws)
{
    TermWeights result;
    const auto add = [&](double coefficient, std::size_t term) {
        if (coefficient != 0)
            result.emplace_back(term, coefficient);
    };
    for (std::size_t i = 0; i < laws.size(); ++i) {
        const double a = laws[i].film_a, b = laws[i].film_b, oil = laws[i].oil, all = a + b + oil;
        const auto& joint = terms.joints[i];
        if ((laws[i].turns_fully ? joint.turning : joint.between).is_missing())
            throw InputError(laws[i].turns_fully ? "a joint turns fully that did not when its terms were made"
                                                 : "a joint does not turn fully that did when its terms were made");
        add(a * oil / all, 4 * i);
        add(b * oil / all, 4 * i + 1);
        add(a * b / all, 4 * i + (laws[i].turns_fully ? 3 : 2));
    }
    for (std::size_t s = 0; s < terms.films.size(); ++s)
        if (const auto& c = problem.surfaces[s];
            c.kind == SurfaceCondition::Kind::film && !heat::follows_temperature(c))
            add(c.coefficient, 4 * laws.size() + s);
    return result;
}

}  // namespace deadpoint::reduce
