#include "deadpoint/reduce/sensitivity/changed_rates.hpp"

#include "deadpoint/reduce/sensitivity/passing_changes.hpp"
#include "deadpoint/reduce/sensitivity/rate_effects.hpp"

namespace deadpoint::reduce {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

const LowRankTerm& term_at(const DenseTerms& terms, std::size_t index)
{
    if (index >= 4 * terms.joints.size())
        return terms.films[index - 4 * terms.joints.size()];
    const auto& joint = terms.joints[index / 4];
    switch (index % 4) {
    case 0:
        return joint.aa;
    case 1:
        return joint.bb;
    case 2:
        return joint.between;
    default:
        return joint.turning;
    }
}

}  // namespace

ChangedRates::ChangedRates(const LinearisedHeat& heat, const std::vector<Direction>& directions)
    : heat_(&heat), directions_(&directions)
{
    for (const auto& direction : directions)
        for (const auto& [scalar, change] : direction.lasting[heat.segment()])
            if (index_.try_emplace(scalar, lasting_.size()).second)
                lasting_.push_back({scalar, term_changes(scalar, heat), 0});
}

const MatrixXd& ChangedRates::factor(std::size_t term)
{
    const auto [found, is_new] = factors_.try_emplace(term);
    if (is_new)
        found->second = heat_->into_basis(term_at(heat_->prepared().terms, term).factor);
    return found->second;
}

void ChangedRates::add_effect(std::size_t scalar, double change, const LinearisedState& state,
                              Eigen::Ref<VectorXd> states, Eigen::Ref<VectorXd> inner) const
{
    const auto effect = effect_of(scalar, *heat_, state);
    for (const auto& [functional, watts] : effect.watts)
        states += change * watts * heat_->functionals().row(static_cast<Eigen::Index>(functional)).transpose();
    for (const auto& [place, value] : effect.inner)
        inner[place] += change * value;
}

Derivatives ChangedRates::at(const LinearisedState& state)
{
    const auto count = static_cast<Eigen::Index>(lasting_.size());
    Derivatives by_scalar{MatrixXd::Zero(state.states.size(), count), MatrixXd::Zero(heat_->inner().count(), count)};
    for (Eigen::Index k = 0; k < count; ++k) {
        const auto& [scalar, terms, weight] = lasting_[static_cast<std::size_t>(k)];
        add_effect(scalar, 1, state, by_scalar.states.col(k), by_scalar.inner.col(k));
        for (const auto& [term, change] : terms) {
            const auto& of_term = factor(term);
            by_scalar.states.col(k).noalias() -= of_term * (change * (of_term.transpose() * state.states));
        }
    }
    const auto directions = static_cast<Eigen::Index>(directions_->size());
    Derivatives result{MatrixXd::Zero(by_scalar.states.rows(), directions),
                       MatrixXd::Zero(by_scalar.inner.rows(), directions)};
    for (Eigen::Index k = 0; k < directions; ++k) {
        const auto& direction = (*directions_)[static_cast<std::size_t>(k)];
        for (const auto& [scalar, change] : direction.lasting[heat_->segment()]) {
            const auto column = static_cast<Eigen::Index>(index_.at(scalar));
            result.states.col(k) += change * by_scalar.states.col(column);
            result.inner.col(k) += change * by_scalar.inner.col(column);
        }
        for (const auto& [scalar, change] : passing_changes(direction, *heat_, state))
            add_effect(scalar, change, state, result.states.col(k), result.inner.col(k));
    }
    return result;
}

double ChangedRates::weight_of(std::size_t scalar, const LinearisedState& state, const VectorXd& by_functional,
                               const MatrixXd& by_inner) const
{
    const auto effect = effect_of(scalar, *heat_, state);
    double sum = 0;
    for (const auto& [functional, watts] : effect.watts)
        sum += watts * by_functional[static_cast<Eigen::Index>(functional)];
    for (const auto& [place, value] : effect.inner)
        sum += value * by_inner(place, 0);
    return sum;
}

void ChangedRates::add_weighted(const LinearisedState& state, const Derivatives& weights, std::vector<double>& sums)
{
    const VectorXd by_functional = heat_->functionals() * weights.states.col(0);
    for (auto& lasting : lasting_)
        lasting.weight += weight_of(lasting.scalar, state, by_functional, weights.inner);
    for (std::size_t k = 0; k < sums.size(); ++k)
        for (const auto& [scalar, change] : passing_changes((*directions_)[k], *heat_, state))
            sums[k] += change * weight_of(scalar, state, by_functional, weights.inner);
    weights_.emplace_back(weights.states.col(0));
    states_.push_back(state.states);
}

// The products y . K_t x of all times with a term K_t are those of its entries with the sum of y x^T.
void ChangedRates::finish(std::vector<double>& sums)
{
    const auto times = static_cast<Eigen::Index>(weights_.size());
    MatrixXd weights(heat_->functionals().cols(), times), states(weights.rows(), times);
    for (Eigen::Index k = 0; k < times; ++k) {
        weights.col(k) = weights_[static_cast<std::size_t>(k)];
        states.col(k) = states_[static_cast<std::size_t>(k)];
    }
    const MatrixXd products = heat_->from_basis(weights) * heat_->from_basis(states).transpose();
    const SymmetricMatrix symmetric(0.5 * (products + products.transpose()));
    std::map<std::size_t, double> by_term;
    for (auto& lasting : lasting_)
        for (const auto& [term, change] : lasting.terms) {
            const auto [found, is_new] = by_term.try_emplace(term);
            if (is_new)
                found->second = heat_->prepared().each[term].matrix().product(symmetric);
            lasting.weight -= change * found->second;
        }
    for (std::size_t k = 0; k < sums.size(); ++k)
        for (const auto& [scalar, change] : (*directions_)[k].lasting[heat_->segment()])
            sums[k] += change * lasting_[index_.at(scalar)].weight;
    weights_.clear();
    states_.clear();
    for (auto& lasting : lasting_)
        lasting.weight = 0;
}

}  // namespace deadpoint::reduce
