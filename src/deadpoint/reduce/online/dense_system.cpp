#include "deadpoint/reduce/online/dense_system.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/heat/adjoint.hpp"
#include "deadpoint/heat/run.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/observer.hpp"

#include <algorithm>
#include <cmath>

template class deadpoint::heat::HeatRun<deadpoint::reduce::DenseSystem>;
template class deadpoint::heat::HeatAdjoint<deadpoint::reduce::DenseSystem>;

namespace deadpoint::reduce {
namespace {

static_assert(heat::AdjointSystem<DenseSystem>);

constexpr std::size_t most_factors = 16;  // number of factors kept; step sizes change by factors of two

bool is_square(const Eigen::MatrixXd& matrix, Eigen::Index size)
{
    return matrix.rows() == size && matrix.cols() == size;
}

void require_sound(const DenseTerms& terms, const HeatProblem& problem)
{
    const Eigen::Index n = terms.mass.rows();
    const auto& layout = terms.geometry.layout;
    const auto fits = [&](const DenseJoint& joint) {
        return is_square(joint.aa, n) && is_square(joint.bb, n) && is_square(joint.across, n) &&
               (joint.turning.size() == 0 || is_square(joint.turning, n));
    };
    const bool sound = is_square(terms.mass, n) && is_square(terms.solid, n) && terms.uniform.size() == n &&
                       terms.joints.size() == layout.interfaces && std::ranges::all_of(terms.joints, fits) &&
                       terms.films.size() == layout.surfaces && layout.surfaces == problem.surfaces.size() &&
                       std::ranges::all_of(terms.films, [&](const auto& film) { return is_square(film, n); }) &&
                       terms.functionals.rows() == static_cast<Eigen::Index>(layout.count()) &&
                       terms.functionals.cols() == n;
    if (!sound)
        throw InputError("the terms of a dense system differ in size");
    if (std::ranges::any_of(problem.surfaces,
                            [](const auto& s) { return s.kind == SurfaceCondition::Kind::temperature; }))
        throw InputError("a dense system takes no prescribed temperature; state a film with a high coefficient");
}

Eigen::MatrixXd conduction_of(const DenseJoint& joint, const InterfaceLaw& law)
{
    const double sum = law.film_a + law.film_b + law.oil;
    const auto& across = law.turns_fully ? joint.turning : joint.across;
    if (across.size() == 0)
        throw InputError("a joint turns fully that did not when its terms were made");
    return law.film_a * (sum - law.film_a) / sum * joint.aa + law.film_b * (sum - law.film_b) / sum * joint.bb -
           law.film_a * law.film_b / sum * across;
}

}  // namespace

DenseSystem::DenseSystem(DenseTerms terms, const HeatProblem& problem, double reference)
    : terms_(std::move(terms)), problem_(&problem), reference_(reference),
      follows_(std::ranges::any_of(problem.surfaces, heat::follows_temperature))
{
    require_sound(terms_, problem);
    films_ = Eigen::MatrixXd::Zero(terms_.mass.rows(), terms_.mass.cols());
}

void DenseSystem::combine(const std::vector<heat::Scaled<Vector>>& sum, Vector& result) const
{
    result.setZero();
    for (const auto& [factor, vector] : sum)
        result += factor * *vector;
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
        stiffness_ += conduction_of(terms_.joints[i], laws[i]);
    for (std::size_t s = 0; s < terms_.films.size(); ++s)
        if (const auto& c = problem_->surfaces[s];
            c.kind == SurfaceCondition::Kind::film && !heat::follows_temperature(c))
            stiffness_ += c.coefficient * terms_.films[s];
    loads_.setZero(terms_.mass.rows(), static_cast<Eigen::Index>(source_loads.size()));
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
        watts -= (flux - slope * at) * terms_.functionals.row(row).transpose() +
                 slope * (terms_.films[film.surface] * temperature);
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

bool DenseSystem::build(double factor, const Vector& temperature, const std::vector<heat::FilmAt>& films)
{
    if (factor == factor_ && !follows_)
        return false;
    if (follows_) {
        forget_factors();
        films_.setZero();
        for (const auto& film : films) {
            const double at = mean(film.surface, temperature);
            films_ +=
                heat::film_slope(film.law(at), film.emissivity, at, film.surroundings) * terms_.films[film.surface];
        }
    }
    factor_ = factor;
    stage_ = terms_.mass + factor * (stiffness_ + films_);
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
            films_ += coefficients[s] * terms_.films[s];
    forget_factors();
}

int DenseSystem::solve_adjoint(double factor, const Vector& right, Vector& solution)
{
    if (factor != factor_) {
        factor_ = factor;
        stage_ = terms_.mass + factor * (stiffness_ + films_);
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
