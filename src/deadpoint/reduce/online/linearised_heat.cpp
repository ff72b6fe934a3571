#include "deadpoint/reduce/online/linearised_heat.hpp"

#include "deadpoint/exchange/heat.hpp"

namespace deadpoint::reduce {
namespace {

constexpr double ring_difference_step = 1e-4;  // [K]

bool is_film(const SurfaceCondition& condition) { return condition.kind == SurfaceCondition::Kind::film; }

// Of vectors that are empty where there is no such term.
double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) { return a.size() == 0 ? 0 : a.dot(b); }

JointScalars unit(std::size_t scalar)
{
    std::array<double, 4> x{};
    x[scalar] = 1;
    return {x[0], x[1], x[2], x[3]};
}

void add_product(double coefficient, const LowRankTerm& term, const Eigen::VectorXd& products, Eigen::VectorXd& sum)
{
    if (coefficient != 0 && !term.is_missing())
        sum.noalias() += coefficient * (term.factor * products);
}

// 1 - factor matrix.
Eigen::MatrixXd one_less(double factor, const Eigen::MatrixXd& matrix)
{
    return Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()) - factor * matrix;
}

}  // namespace

LinearisedHeat::LinearisedHeat(const DenseTerms& terms, const HeatProblem& problem, std::size_t segment)
    : terms_(&terms), problem_(&problem), laws_(&problem.segments[segment]), segment_(segment),
      joints_(problem, terms.geometry), films_(problem, terms.geometry), self_(problem.sources.size(), 0.0)
{
    joints_.enter(*laws_);
    films_.enter(*laws_);
    for (std::size_t i = 0; i < joints_.laws().size(); ++i)
        if (const double share = film_share(i); share > 0)
            self_[static_cast<std::size_t>(joints_.laws()[i].source)] +=
                share * share / (joints_.area(i) * joints_.film_sum(i));
    add_stiffness();
    loads_ = Eigen::MatrixXd::Zero(terms.uniform.size(), static_cast<Eigen::Index>(self_.size()));
    for (std::size_t r = 0; r < self_.size(); ++r)
        for (const auto& [functional, weight] : joints_.source_load(r))
            loads_.col(static_cast<Eigen::Index>(r)) += weight * row(functional);
}

Eigen::VectorXd LinearisedHeat::row(std::size_t functional) const
{
    return terms_->functionals.row(static_cast<Eigen::Index>(functional)).transpose();
}

void LinearisedHeat::add_stiffness()
{
    stiffness_ = terms_->solid;
    const auto add = [&](double coefficient, const LowRankTerm& term) {
        if (coefficient != 0 && !term.is_missing())
            stiffness_ += coefficient * (term.factor * term.factor.transpose());
    };
    for (std::size_t i = 0; i < joints_.laws().size(); ++i) {
        const auto& law = joints_.laws()[i];
        const double sum = joints_.film_sum(i);
        const auto [aa, bb, coupling] = joint_terms(i);
        add(law.film_a * law.oil / sum, *aa);
        add(law.film_b * law.oil / sum, *bb);
        add(law.film_a * law.film_b / sum, *coupling);
    }
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s)
        if (is_film(problem_->surfaces[s]))
            add(problem_->surfaces[s].coefficient, terms_->films[s]);
}

std::array<const LowRankTerm*, 3> LinearisedHeat::joint_terms(std::size_t i) const
{
    const auto& joint = terms_->joints[i];
    return {&joint.aa, &joint.bb, joints_.laws()[i].turns_fully ? &joint.turning : &joint.between};
}

double LinearisedHeat::film_share(std::size_t i) const
{
    const auto& law = joints_.laws()[i];
    return law.source >= 0 && law.heat_part < 0 ? joints_.heat_share(i) : 0;
}

// Per unit of the source's share.
double LinearisedHeat::zoned_heat(std::size_t i) const
{
    const auto& law = joints_.laws()[i];
    if (law.source < 0 || !law.load_zone)
        return 0;
    return laws_->zoned_heat[static_cast<std::size_t>(law.source)] * joints_.heat_share(i);
}

TermProducts LinearisedHeat::products(const Eigen::VectorXd& vector) const
{
    const auto product_of = [&](const LowRankTerm& term) -> Eigen::VectorXd {
        if (term.is_missing())
            return {};
        return term.factor.transpose() * vector;
    };
    TermProducts result;
    for (std::size_t i = 0; i < terms_->joints.size(); ++i) {
        const auto [aa, bb, coupling] = joint_terms(i);
        result.joints.push_back({product_of(*aa), product_of(*bb), product_of(*coupling)});
    }
    for (const auto& film : terms_->films)
        result.films.push_back(product_of(film));
    return result;
}

LinearisedState LinearisedHeat::at(double time, const Eigen::VectorXd& temperature) const
{
    LinearisedState result;
    const Eigen::VectorXd values = terms_->functionals * temperature;
    result.values.assign(values.begin(), values.end());
    std::vector<double> watts(result.values.size(), 0.0);
    joints_.evaluate(result.values, result.balance, watts);
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s)
        result.faced.push_back(is_film(problem_->surfaces[s]) ? films_.surroundings(s, time, {}) : 0);
    result.heat_slopes = heat_slopes(result.balance, temperature);
    result.products = products(temperature);
    return result;
}

Eigen::VectorXd LinearisedHeat::ring_functional(std::size_t r) const
{
    const auto mean = [&](const std::vector<InterfaceSide>& sides) {
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(terms_->uniform.size());
        double area = 0;
        for (const auto& side : sides) {
            const auto i = static_cast<std::size_t>(side.interface);
            sum += joints_.area(i) * row(terms_->geometry.layout.mean(i, side.b));
            area += joints_.area(i);
        }
        return Eigen::VectorXd(sum / area);
    };
    const auto& source = problem_->sources[r];
    return mean(source.inner_rings) - mean(source.outer_rings);
}

// Derivative of a source's heat by the ring temperature difference [W/K].
double LinearisedHeat::heat_by_rings(std::size_t r, double difference, double source_slope) const
{
    const auto& law = laws_->ring_heat[r];
    const double step = ring_difference_step;
    const double slope = (law(difference + step) - law(difference - step)) / (2 * step);
    return problem_->sources[r].share * slope * (1 + self_[r] * source_slope);
}

Eigen::MatrixXd LinearisedHeat::heat_slopes(const heat::HeatBalance& balance, const Eigen::VectorXd& temperature) const
{
    Eigen::MatrixXd result = loads_;
    for (std::size_t r = 0; r < self_.size(); ++r) {
        auto column = result.col(static_cast<Eigen::Index>(r));
        column *= balance.source_slope[r];
        if (!laws_->heat[r] || laws_->ring_heat.empty() || !laws_->ring_heat[r])
            continue;
        const auto rings = ring_functional(r);
        column += heat_by_rings(r, rings.dot(temperature), balance.source_slope[r]) * rings;
    }
    return result;
}

double LinearisedHeat::heat_by_share(std::size_t r, const LinearisedState& at) const
{
    return at.balance.source_heat[r] / problem_->sources[r].share * (1 + self_[r] * at.balance.source_slope[r]);
}

double LinearisedHeat::heat_change(std::size_t i, const LinearisedState& at, const JointScalars& change) const
{
    const auto& law = joints_.laws()[i];
    const double share = film_share(i), sum = joints_.film_sum(i);
    if (share == 0)
        return 0;
    const auto& layout = terms_->geometry.layout;
    const auto r = static_cast<std::size_t>(law.source);
    const double on_a = at.values[layout.mean(i, false)], on_b = at.values[layout.mean(i, true)];
    const double mean = (law.film_a * on_a + law.film_b * on_b + law.oil * law.oil_temperature) / sum;
    const double mean_change = (change.film_a * (on_a - mean) + change.film_b * (on_b - mean) +
                                change.oil * (law.oil_temperature - mean) + law.oil * change.oil_temperature) /
                               sum;
    const double sum_change = change.film_a + change.film_b + change.oil;
    const double self_change = -share * share / (joints_.area(i) * sum * sum) * sum_change;
    return at.balance.source_slope[r] * (share * mean_change + self_change * at.balance.source_heat[r]);
}

LinearisedHeat::JointEffect LinearisedHeat::effect(std::size_t i, const LinearisedState& at,
                                                   const JointScalars& change) const
{
    const auto& law = joints_.laws()[i];
    const double sum = joints_.film_sum(i), sum_change = change.film_a + change.film_b + change.oil;
    const auto share_change = [&](double x, double dx) { return (dx - x / sum * sum_change) / sum; };
    const double oil_share = share_change(law.oil, change.oil);
    const double oil_change = change.oil * law.oil_temperature + law.oil * change.oil_temperature;
    double heat = joints_.area(i) * law.oil * law.oil_temperature, zoned = 0;
    if (film_share(i) > 0) {
        const auto r = static_cast<std::size_t>(law.source);
        heat += film_share(i) * at.balance.source_heat[r];
        zoned = zoned_heat(i) * problem_->sources[r].share;
    }
    JointEffect result;
    result.heat = heat_change(i, at, change);
    for (const bool side_b : {false, true}) {
        const double side = side_b ? law.film_b : law.film_a, side_change = side_b ? change.film_b : change.film_a;
        result.side[side_b] =
            heat * share_change(side, side_change) + joints_.area(i) * oil_change * joints_.side_share(i, side_b);
        result.zone[side_b] = zoned * share_change(side, side_change);
        result.term[side_b] = side_change * law.oil / sum + side * oil_share;
    }
    result.term[2] = change.film_a * law.film_b / sum + law.film_a * share_change(law.film_b, change.film_b);
    return result;
}

// Of the heat by load zone.
LinearisedHeat::JointEffect LinearisedHeat::effect_of_share(std::size_t i) const
{
    JointEffect result;
    if (joints_.laws()[i].heat_part >= 0)
        result.zone[0] = zoned_heat(i);
    else
        for (const bool side_b : {false, true})
            result.zone[side_b] = zoned_heat(i) * joints_.side_share(i, side_b);
    return result;
}

void LinearisedHeat::add_effect(std::size_t i, const LinearisedState& at, const JointEffect& effect,
                                RateParts& sum) const
{
    const auto& layout = terms_->geometry.layout;
    if (const int source = joints_.laws()[i].source; source >= 0)
        sum.heat[source] += effect.heat;
    for (const bool side_b : {false, true}) {
        sum.watts[static_cast<Eigen::Index>(layout.mean(i, side_b))] += effect.side[side_b];
        sum.watts[static_cast<Eigen::Index>(layout.zone(i, side_b))] += effect.zone[side_b];
    }
    const auto of_joint = joint_terms(i);
    for (std::size_t t = 0; t < of_joint.size(); ++t)
        add_product(-effect.term[t], *of_joint[t], at.products.joints[i][t], sum.states);
}

void LinearisedHeat::add_joints(const LinearisedState& at, const HeatScalars& change, RateParts& sum) const
{
    for (std::size_t i = 0; i < joints_.laws().size(); ++i) {
        if (change.joints[i] != JointScalars{})
            add_effect(i, at, effect(i, at, change.joints[i]), sum);
        if (zoned_heat(i) == 0)
            continue;
        auto by_share = effect_of_share(i);
        for (auto& watts : by_share.zone)
            watts *= change.shares[static_cast<std::size_t>(joints_.laws()[i].source)];
        add_effect(i, at, by_share, sum);
    }
    for (std::size_t r = 0; r < self_.size(); ++r)
        sum.heat[static_cast<Eigen::Index>(r)] += heat_by_share(r, at) * change.shares[r];
}

void LinearisedHeat::add_films(const LinearisedState& at, const HeatScalars& change, RateParts& sum) const
{
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s)
        if (const auto& condition = problem_->surfaces[s]; is_film(condition)) {
            sum.watts[static_cast<Eigen::Index>(terms_->geometry.layout.surface(s))] +=
                change.films[s] * at.faced[s] + condition.coefficient * change.surroundings[s];
            add_product(-change.films[s], terms_->films[s], at.products.films[s], sum.states);
        }
}

Eigen::VectorXd LinearisedHeat::rate_change(const LinearisedState& at, const HeatScalars& change) const
{
    RateParts sum{Eigen::VectorXd::Zero(terms_->functionals.rows()), Eigen::VectorXd::Zero(loads_.cols()),
                  Eigen::VectorXd::Zero(terms_->uniform.size())};
    add_joints(at, change, sum);
    add_films(at, change, sum);
    return sum.states + terms_->functionals.transpose() * sum.watts + loads_ * sum.heat;
}

HeatScalars LinearisedHeat::scalar_weights(const LinearisedState& at, const Eigen::VectorXd& weights) const
{
    const auto& layout = terms_->geometry.layout;
    const Eigen::VectorXd by_functional = terms_->functionals * weights, by_source = loads_.transpose() * weights;
    const auto weight_of = [&](std::size_t functional) { return by_functional[static_cast<Eigen::Index>(functional)]; };
    const auto by_term = products(weights);
    const auto weigh = [&](std::size_t i, const JointEffect& effect) {
        const int source = joints_.laws()[i].source;
        double sum = source >= 0 ? effect.heat * by_source[source] : 0;
        for (const bool side_b : {false, true})
            sum += effect.side[side_b] * weight_of(layout.mean(i, side_b)) +
                   effect.zone[side_b] * weight_of(layout.zone(i, side_b));
        for (std::size_t t = 0; t < effect.term.size(); ++t)
            sum -= effect.term[t] * product(by_term.joints[i][t], at.products.joints[i][t]);
        return sum;
    };
    HeatScalars result;
    for (std::size_t r = 0; r < self_.size(); ++r)
        result.shares.push_back(heat_by_share(r, at) * by_source[static_cast<Eigen::Index>(r)]);
    for (std::size_t i = 0; i < joints_.laws().size(); ++i) {
        const auto by = [&](std::size_t scalar) { return weigh(i, effect(i, at, unit(scalar))); };
        result.joints.push_back({by(0), by(1), by(2), by(3)});
        if (zoned_heat(i) != 0)
            result.shares[static_cast<std::size_t>(joints_.laws()[i].source)] += weigh(i, effect_of_share(i));
    }
    for (std::size_t s = 0; s < problem_->surfaces.size(); ++s) {
        const auto& condition = problem_->surfaces[s];
        const double weight = is_film(condition) ? weight_of(layout.surface(s)) : 0;
        result.films.push_back(weight * at.faced[s] - product(by_term.films[s], at.products.films[s]));
        result.surroundings.push_back(condition.coefficient * weight);
    }
    return result;
}

Eigen::MatrixXd LinearisedHeat::apply(const LinearisedState& at, const Eigen::MatrixXd& x) const
{
    return loads_ * (at.heat_slopes.transpose() * x) - stiffness_ * x;
}

Eigen::MatrixXd LinearisedHeat::apply_transposed(const LinearisedState& at, const Eigen::MatrixXd& x) const
{
    return at.heat_slopes * (loads_.transpose() * x) - stiffness_ * x;
}

const LinearisedHeat::Factored& LinearisedHeat::factored(double factor)
{
    auto [found, is_new] = factors_.try_emplace(factor);
    if (is_new) {
        Eigen::MatrixXd matrix = factor * stiffness_;
        matrix.diagonal().array() += 1;
        found->second.matrix.compute(matrix);
        found->second.solved_loads = found->second.matrix.solve(loads_);
    }
    return found->second;
}

Eigen::MatrixXd LinearisedHeat::solve(double factor, const LinearisedState& at, const Eigen::MatrixXd& right)
{
    const auto& [matrix, solved_loads] = factored(factor);
    Eigen::MatrixXd result = matrix.solve(right);
    if (loads_.cols() == 0)
        return result;
    const auto small = one_less(factor, at.heat_slopes.transpose() * solved_loads);
    result += factor * solved_loads * small.partialPivLu().solve(at.heat_slopes.transpose() * result);
    return result;
}

Eigen::MatrixXd LinearisedHeat::solve_transposed(double factor, const LinearisedState& at, const Eigen::MatrixXd& right)
{
    const auto& [matrix, solved_loads] = factored(factor);
    if (loads_.cols() == 0)
        return matrix.solve(right);
    const auto small = one_less(factor, solved_loads.transpose() * at.heat_slopes);
    const Eigen::MatrixXd heat = small.partialPivLu().solve(solved_loads.transpose() * right);
    return matrix.solve(right + factor * at.heat_slopes * heat);
}

}  // namespace deadpoint::reduce
