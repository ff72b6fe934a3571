#include "deadpoint/reduce/online/dense_system.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/heat/adjoint.hpp"
#include "deadpoint/heat/run.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

template class deadpoint::heat::HeatRun<deadpoint::reduce::DenseSystem>;
template class deadpoint::heat::HeatAdjoint<deadpoint::reduce::DenseSystem>;

namespace deadpoint::reduce {
namespace {

static_assert(heat::AdjointSystem<DenseSystem>);

constexpr std::size_t most_factors = 16;  // number of factors kept; step sizes change by factors of two

void require_fit(const DenseTerms& terms, const HeatProblem& problem)
{
    if (terms.geometry.layout.surfaces != problem.surfaces.size())
        throw InputError("the terms of a dense system differ in size");
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s) {
        const auto kind = problem.surfaces[s].kind;
        if (kind == SurfaceCondition::Kind::temperature)
            throw InputError("a dense system takes no prescribed temperature; state a film with a high coefficient");
        if (kind == SurfaceCondition::Kind::film && terms.films[s].is_missing())
            throw InputError("surface '" + problem.surfaces[s].name + "' has a film but no term in the dense system");
    }
}

void add_term(double coefficient, const LowRankTerm& term, Eigen::MatrixXd& sum)
{
    sum.selfadjointView<Eigen::Lower>().rankUpdate(term.factor, coefficient);
}

void add_joint(const DenseJoint& joint, const InterfaceLaw& law, Eigen::MatrixXd& sum)
{
    const auto& [a, b, oil] = std::tuple(law.film_a, law.film_b, law.oil);
    const auto& between = law.turns_fully ? joint.turning : joint.between;
    if (between.is_missing())
        throw InputError(law.turns_fully ? "a joint turns fully that did not when its terms were made"
                                         : "a joint does not turn fully that did when its terms were made");
    const double all = a + b + oil;
    add_term(a * b / all, between, sum);
    add_term(a * oil / all, joint.aa, sum);
    add_term(b * oil / all, joint.bb, sum);
}

void fill_upper(Eigen::MatrixXd& matrix) { matrix.triangularView<Eigen::StrictlyUpper>() = matrix.transpose(); }

}  // namespace

DenseSystem::DenseSystem(DenseTerms terms, const HeatProblem& problem, double reference)
    : terms_(std::move(terms)), problem_(&problem), reference_(reference),
      follows_(std::ranges::any_of(problem.surfaces, heat::follows_temperature))
{
    conserve_heat(terms_);
    require_fit(terms_, problem);
    films_ = Eigen::MatrixXd::Zero(terms_.solid.rows(), terms_.solid.cols());
}

void DenseSystem::combine(const std::vector<heat::Scaled<Vector>>& sum, Vector& result) const
{
    result.setZero();
    for (const auto& [factor, vector] : sum)
        result += factor * *vector;
}

double DenseSystem::largest(const Vector& vector) const
{
    const auto& layout = geometry().layout;
    const Vector values = (terms_.functionals * vector).cwiseAbs();
    const auto largest_of = [&](std::size_t begin, std::size_t end) {
        double result = 0;
        for (std::size_t k = begin; k < end; ++k)
            result = std::max(result, values[static_cast<Eigen::Index>(k)]);
        return result;
    };
    double result =
        std::max({largest_of(layout.mean(0, false), layout.zone(0, false)),
                  largest_of(layout.part(0), layout.surface(0)), largest_of(layout.probe(0), layout.count())});
    for (std::size_t s = 0; s < layout.surfaces; ++s)
        if (const double area = geometry().surface_area[s]; area > 0)
            result = std::max(result, values[static_cast<Eigen::Index>(layout.surface(s))] / area);
    return result;
}

std::vector<double> DenseSystem::evaluate(std::span<const std::size_t> which, const Vector& vector) const
{
    std::vector<double> values;
    values.reserve(which.size());
    for (const std::size_t index : which)
        values.push_back(terms_.functionals.row(static_cast<Eigen::Index>(index)).dot(vector));
    return values;
}

void DenseSystem::add_loads(const std::vector<double>& watts, Vector& vector) const
{
    const Eigen::Map<const Vector> by_functional(watts.data(), static_cast<Eigen::Index>(watts.size()));
    vector.noalias() += terms_.functionals.transpose() * by_functional;
}

std::vector<double> DenseSystem::observe(const Vector& vector, const Vector&, bool is_slope) const
{
    if (terms_.observed.size() == 0)
        return {};
    Vector values = terms_.observed * vector;
    if (!is_slope)
        values -= reference_ * (terms_.observed * terms_.uniform);
    return {values.begin(), values.end()};
}

// By the means of the parts.
void DenseSystem::widen(const Vector& temperature, std::vector<double>& lowest, std::vector<double>& highest) const
{
    for (std::size_t p = 0; p < lowest.size(); ++p) {
        const double mean =
            terms_.functionals.row(static_cast<Eigen::Index>(geometry().layout.part(p))).dot(temperature);
        lowest[p] = std::min(lowest[p], mean);
        highest[p] = std::max(highest[p], mean);
    }
}

void DenseSystem::forget_factors()
{
    factors_.clear();
    factor_ = -1;
}

void DenseSystem::set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads)
{
    stiffness_ = terms_.solid;
    for (std::size_t i = 0; i < laws.size(); ++i)
        add_joint(terms_.joints[i], laws[i], stiffness_);
    for (std::size_t s = 0; s < terms_.films.size(); ++s)
        if (const auto& c = problem_->surfaces[s];
            c.kind == SurfaceCondition::Kind::film && !heat::follows_temperature(c))
            add_term(c.coefficient, terms_.films[s], stiffness_);
    fill_upper(stiffness_);
    loads_.setZero(terms_.uniform.size(), static_cast<Eigen::Index>(source_loads.size()));
    for (std::size_t r = 0; r < source_loads.size(); ++r)
        for (const auto& [functional, weight] : source_loads[r])
            loads_.col(static_cast<Eigen::Index>(r)) +=
                weight * terms_.functionals.row(static_cast<Eigen::Index>(functional)).transpose();
    forget_factors();
}

double DenseSystem::mean(std::size_t surface, const Vector& temperature) const
{
    const auto row = static_cast<Eigen::Index>(geometry().layout.surface(surface));
    return terms_.functionals.row(row).dot(temperature) / geometry().surface_area[surface];
}

// Temperature whose radiation a surface of a room receives, 0 for all others [K].
std::vector<double> DenseSystem::irradiation(const Vector& temperature) const
{
    std::vector<double> result(problem_->surfaces.size(), 0.0);
    for (const auto& room : problem_->radiation) {
        const std::size_t count = room.surfaces.size();
        for (std::size_t i = 0; i < count; ++i) {
            double received = 0, all = 0;
            for (std::size_t j = 0; j < count; ++j) {
                const double exchange = room.exchange[i * count + j];
                received += exchange * std::pow(mean(static_cast<std::size_t>(room.surfaces[j]), temperature), 4);
                all += exchange;
            }
            result[static_cast<std::size_t>(room.surfaces[i])] = std::sqrt(std::sqrt(received / all));
        }
    }
    return result;
}

heat::FilmHeat DenseSystem::add_films(const std::vector<heat::FilmAt>& films, const Vector& temperature,
                                      Vector& watts) const
{
    const std::size_t count = problem_->surfaces.size();
    heat::FilmHeat heat{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
                        std::vector<double>(count, 0.0)};
    const auto received = irradiation(temperature);
    for (const auto& film : films) {
        const double at = mean(film.surface, temperature), area = geometry().surface_area[film.surface];
        const LawValue value = film.law(at);
        const bool in_room = received[film.surface] > 0;
        const double inside = in_room ? heat::film_flux({}, film.emissivity, at, received[film.surface]) : 0;
        const double flux = inside + heat::film_flux(value, in_room ? 0 : film.emissivity, at, film.surroundings);
        const double slope = heat::film_slope(value, film.emissivity, at, film.surroundings);
        const auto row = static_cast<Eigen::Index>(geometry().layout.surface(film.surface));
        const auto& factor = terms_.films[film.surface].factor;
        watts -= (flux - slope * at) * terms_.functionals.row(row).transpose() +
                 slope * (factor * (factor.transpose() * temperature));
        heat.lost[film.surface] = area * flux;
        heat.to_surfaces[film.surface] = area * inside;
        heat.untested[film.surface] = value.in_range ? 0 : area;
    }
    return heat;
}

void DenseSystem::add_film_slopes(const std::vector<heat::FilmAt>& films, const Vector& temperature, Vector& load) const
{
    for (const auto& film : films) {
        const double at = mean(film.surface, temperature);
        const auto row = static_cast<Eigen::Index>(geometry().layout.surface(film.surface));
        load += heat::film_slope(film.law(at), 0, at, film.surroundings) * terms_.functionals.row(row).transpose();
    }
}

Eigen::MatrixXd DenseSystem::stage_of(double factor) const
{
    Eigen::MatrixXd result = factor * (stiffness_ + films_);
    result.diagonal().array() += 1;
    return result;
}

bool DenseSystem::build(double factor, const Vector& temperature, const std::vector<heat::FilmAt>& films)
{
    if (factor == factor_ && !follows_)
        return false;
    if (follows_) {
        forget_factors();
        films_.setZero();
        for (const auto& film : films) {
            const double at = mean(film.surface, temperature);
            add_term(heat::film_slope(film.law(at), film.emissivity, at, film.surroundings), terms_.films[film.surface],
                     films_);
        }
        fill_upper(films_);
    }
    factor_ = factor;
    stage_ = stage_of(factor);
    return true;
}

const DenseSystem::Factored& DenseSystem::factored(double factor)
{
    if (const auto found = factors_.find(factor); found != factors_.end())
        return found->second;
    if (factors_.size() >= most_factors)
        factors_.clear();
    auto& result = factors_[factor];
    result.matrix.compute(stage_);
    if (result.matrix.info() != Eigen::Success || !stage_.allFinite())
        throw heat::NotFinite("the matrix of a stage is not positive definite, or holds a value that is not finite");
    result.solved_loads = result.matrix.solve(loads_);
    result.products = loads_.transpose() * result.solved_loads;
    return result;
}

// (A - L C L^T) x = b by  x = A^-1 b + Z (1 - C L^T Z)^-1 C L^T A^-1 b,  Z = A^-1 L.
int DenseSystem::solve(const Vector& right, Vector& solution, const heat::LowRank<Vector>& low_rank,
                       heat::SolveTolerance, const std::string&)
{
    const auto& found = factored(factor_);
    solution = found.matrix.solve(right);
    const auto sources = static_cast<Eigen::Index>(low_rank.source_slopes.size());
    const auto others = static_cast<Eigen::Index>(low_rank.others.size());
    const Eigen::Index count = sources + others;
    if (count == 0)
        return 1;
    Eigen::VectorXd coefficients(count);
    Eigen::MatrixXd loads(right.size(), count), solved(right.size(), count);
    for (Eigen::Index r = 0; r < sources; ++r)
        coefficients[r] = factor_ * low_rank.source_slopes[static_cast<std::size_t>(r)];
    loads.leftCols(sources) = loads_.leftCols(sources);
    solved.leftCols(sources) = found.solved_loads.leftCols(sources);
    for (Eigen::Index k = 0; k < others; ++k) {
        const auto& [coefficient, load] = low_rank.others[static_cast<std::size_t>(k)];
        coefficients[sources + k] = coefficient;
        loads.col(sources + k) = *load;
        solved.col(sources + k) = found.matrix.solve(*load);
    }
    const Eigen::MatrixXd products = others == 0 ? found.products : Eigen::MatrixXd(loads.transpose() * solved);
    const Eigen::MatrixXd small = Eigen::MatrixXd::Identity(count, count) - coefficients.asDiagonal() * products;
    const Eigen::VectorXd wanted = coefficients.cwiseProduct(loads.transpose() * solution);
    solution += solved * small.partialPivLu().solve(wanted);
    return 1;
}

void DenseSystem::begin_adjoint() { forget_factors(); }

void DenseSystem::set_film_coefficients(const std::vector<double>& coefficients)
{
    films_.setZero();
    for (std::size_t s = 0; s < coefficients.size(); ++s)
        if (heat::follows_temperature(problem_->surfaces[s]))
            add_term(coefficients[s], terms_.films[s], films_);
    fill_upper(films_);
    forget_factors();
}

int DenseSystem::solve_adjoint(double factor, const Vector& right, Vector& solution)
{
    if (factor != factor_) {
        factor_ = factor;
        stage_ = stage_of(factor);
    }
    solution = factored(factor).matrix.solve(right);
    return 1;
}

std::vector<double> DenseSystem::start_shares(const Vector& weights, const Vector& start, double reference) const
{
    std::vector<double> result(problem_->surfaces.size() + 1, 0.0);
    result.back() = weights.dot(start - reference * terms_.uniform);
    return result;
}

}  // namespace deadpoint::reduce
