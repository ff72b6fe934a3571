#include "deadpoint/reduce/offline/typical_heat.hpp"

#include "deadpoint/reduce/offline/low_rank.hpp"
#include "deadpoint/reduce/offline/training.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

/// A term, and the first columns of its factor that stay.
struct CutTerm {
    LowRankTerm* term;
    Eigen::Index kept;
};

// In the order of PreparedTerms::each.
std::vector<CutTerm> in_order(DenseTerms& terms)
{
    std::vector<CutTerm> result;
    for (auto& joint : terms.joints)
        result.insert(result.end(), {{&joint.aa, 1}, {&joint.bb, 1}, {&joint.between, 0}, {&joint.turning, 0}});
    for (auto& film : terms.films)
        result.push_back({&film, 1});
    return result;
}

// The heat that states give off, summed over their moments.
double heat_of(const DenseTerms& terms, const std::vector<double>& coefficients, const Eigen::MatrixXd& moments)
{
    double sum = terms.solid.cwiseProduct(moments).sum();
    auto coefficient = coefficients.begin();
    const auto add = [&](const LowRankTerm& term) {
        if (const double c = *coefficient++; !term.is_missing())
            sum += c * term.factor.cwiseProduct(moments * term.factor).sum();
    };
    for (const auto& joint : terms.joints)
        for (const auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            add(*term);
    for (const auto& film : terms.films)
        add(film);
    return sum;
}

}  // namespace

TypicalHeat typical_heat(const DenseTerms& terms, const Training& training, std::vector<double> highest)
{
    const Eigen::VectorXd unit = terms.uniform.normalized();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(unit.size(), unit.size());
    for (const auto* moments : {&training.states, &training.duals}) {
        const Eigen::MatrixXd away = deviations(*moments, unit);
        if (const double heat = heat_of(terms, highest, away); heat > 0)
            sum += away / heat;
    }
    return {sum, std::move(highest)};
}

void cut_terms(DenseTerms& terms, const TypicalHeat& typical, double least)
{
    auto highest = typical.highest.begin();
    for (const auto& [term, kept] : in_order(terms))
        if (const double coefficient = *highest++; !term->is_missing())
            term->factor = cut(term->factor, kept, coefficient * typical.moments, least);
}

}  // namespace deadpoint::reduce
