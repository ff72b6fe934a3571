#include "deadpoint/reduce/online/dense_system.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/heat/adjoint.hpp"
#include "deadpoint/heat/run.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/dense/kernels.hpp"
#include "deadpoint/reduce/online/conduction_terms.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

template class deadpoint::heat::HeatRun<deadpoint::reduce::DenseSystem>;
template class deadpoint::heat::HeatAdjoint<deadpoint::reduce::DenseSystem>;

namespace deadpoint::reduce {
namespace {

static_assert(heat::AdjointSystem<DenseSystem>);

constexpr std::size_t most_factors = 16;     // number of factors kept; step sizes change by factors of two
constexpr double largest_contraction = 0.3;  // see reduced_slopes_serve()

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

/// Mean of q over temperatures around `mean` with a variance, less q(mean): q''/2 var [W/m2].
double bend_of_convection(const FilmLaw& law, const LawValue& at_mean, double mean, double variance,
                          double surroundings)
{
    const double deviation = std::sqrt(variance);
    const auto flux = [&](double at) { return law(at).value * (at - surroundings); };
    return 0.5 * (flux(mean + deviation) + flux(mean - deviation)) - at_mean.value * (mean - surroundings);
}

/// A film over its surface.
struct FilmAtMean {
    LawValue value;
    double inside = 0;   ///< mean flux to the other surfaces of its radiant room [W/m2]
    double outside = 0;  ///< mean flux to the air, and by radiation to the surroundings [W/m2]
    double slope = 0;    ///< [W/m2/K]
};

/// @param variance  of the temperature [K2]
/// @param received  temperature of the irradiation of its room; 0: radiates to the surroundings [K]
FilmAtMean at_mean(const heat::FilmAt& film, double mean, double variance, double received)
{
    FilmAtMean result;
    result.value = film.law(mean);
    const bool in_room = received > 0;
    const double faced = in_room ? received : film.surroundings;
    const double radiated = heat::film_flux({}, film.emissivity, mean, faced) +
                            6 * film.emissivity * heat::stefan_boltzmann * mean * mean * variance;
    result.outside = heat::film_flux(result.value, 0, mean, film.surroundings);
    if (variance > 0)
        result.outside += bend_of_convection(film.law, result.value, mean, variance, film.surroundings);
    (in_room ? result.inside : result.outside) += radiated;
    result.slope = heat::film_slope(result.value, film.emissivity, mean, film.surroundings);
    return result;
}

}  // namespace

DenseSystem::DenseSystem(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, double reference)
    : prepared_(std::move(terms)), terms_(prepared_->terms), problem_(&problem), reference_(reference)
{
    require_fit(terms_, problem);
    for (std::size_t s = 0; s < problem.surfaces.size(); ++s)
        if (heat::follows_temperature(problem.surfaces[s]) && geometry().surface_area[s] > 0)
            following_.push_back(s);
    follows_ = std::ranges::any_of(problem.surfaces, heat::follows_temperature);
    slopes_.assign(problem.surfaces.size(), 0.0);
    for (const std::size_t s : following_) {
        const Row first = prepared_->first_deviation[s], count = prepared_->first_deviation[s + 1] - first;
        if (!runs_.empty() && runs_.back().first + runs_.back().count == first)
            runs_.back().count += count;
        else
            runs_.push_back({first, count});
    }
}

DenseSystem::DenseSystem(DenseTerms terms, const HeatProblem& problem, double reference)
    : DenseSystem(std::make_shared<const PreparedTerms>(std::move(terms)), problem, reference)
{}

void DenseSystem::combine(const std::vector<heat::Scaled<Vector>>& sum, Vector& result) const
{
    result.setZero();
    for (const auto& [factor, vector] : sum)
        result += factor * *vector;
}

void DenseSystem::multiply_functionals(Row first, Row count, const Vector& vector, double* values) const
{
    kernels::row_products(terms_.functionals.data() + first * vector.size(), vector.size(), count, vector.size(),
                          vector.data(), values);
}
void DenseSystem::add_functionals(Row first, Row count, const double* weights, Vector& sum) const
{
    kernels::add_rows(terms_.functionals.data() + first * sum.size(), sum.size(), count, sum.size(), weights,
                      sum.data());
}

double DenseSystem::largest(const Vector& vector) const
{
    const auto& layout = geometry().layout;
    Vector values(terms_.functionals.rows());
    multiply_functionals(0, values.size(), vector, values.data());
    values = values.cwiseAbs();
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

// One product for each run of functionals that follow each other.
std::vector<double> DenseSystem::evaluate(std::span<const std::size_t> which, const Vector& vector) const
{
    std::vector<double> values(which.size());
    for (std::size_t begin = 0, end = 0; begin < which.size(); begin = end) {
        for (end = begin + 1; end < which.size() && which[end] == which[end - 1] + 1; ++end) {
        }
        const auto count = static_cast<Row>(end - begin);
        multiply_functionals(static_cast<Row>(which[begin]), count, vector, &values[begin]);
    }
    return values;
}

void DenseSystem::add_loads(const std::vector<double>& watts, Vector& vector) const
{
    for (std::size_t begin = 0, end = 0; begin < watts.size(); begin = end + 1) {
        for (end = begin; end < watts.size() && watts[end] != 0; ++end) {
        }
        const auto count = static_cast<Row>(end - begin);
        if (count > 0)
            add_functionals(static_cast<Row>(begin), count, &watts[begin], vector);
    }
}

std::vector<double> DenseSystem::observe(const Vector& vector, const Vector&, bool is_slope) const
{
    if (terms_.observed.size() == 0)
        return {};
    Vector values(terms_.observed.rows());
    kernels::row_products(terms_.observed.data(), vector.size(), values.size(), vector.size(), vector.data(),
                          values.data());
    if (!is_slope)
        values -= reference_ * (terms_.observed * terms_.uniform);
    return {values.begin(), values.end()};
}

// By the means of the parts.
void DenseSystem::widen(const Vector& temperature, std::vector<double>& lowest, std::vector<double>& highest) const
{
    std::vector<double> means(lowest.size());
    multiply_functionals(static_cast<Row>(geometry().layout.part(0)), static_cast<Row>(means.size()), temperature,
                         means.data());
    for (std::size_t p = 0; p < lowest.size(); ++p) {
        lowest[p] = std::min(lowest[p], means[p]);
        highest[p] = std::max(highest[p], means[p]);
    }
}

void DenseSystem::set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads)
{
    auto conduction = prepared_->conduction(conduction_terms(terms_, *problem_, laws));
    if (conduction != conduction_) {
        conduction_ = std::move(conduction);
        reduced_ = false;
    }
    const auto sources = static_cast<Row>(source_loads.size());
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(terms_.uniform.size(), sources);
    for (Row r = 0; r < sources; ++r)
        for (const auto& [functional, weight] : source_loads[static_cast<std::size_t>(r)])
            loads.col(r) += weight * terms_.functionals.row(static_cast<Row>(functional)).transpose();
    if (reduced_ && loads != loads_)
        solver_.set_loads(loads);
    loads_ = std::move(loads);
    factor_ = -1;
    clear_adjoint();
}

DenseSystem::Row DenseSystem::surface_row(std::size_t surface) const
{
    return static_cast<Row>(geometry().layout.surface(surface));
}

DenseSystem::Vector DenseSystem::surface_means(const Vector& temperature) const
{
    const auto count = static_cast<Row>(geometry().layout.surfaces);
    Vector result(count);
    multiply_functionals(surface_row(0), count, temperature, result.data());
    result.array() /= Eigen::Map<const Eigen::ArrayXd>(geometry().surface_area.data(), count);
    return result;
}

DenseSystem::Vector DenseSystem::deviations(const Vector& temperature) const
{
    Vector result(prepared_->deviations.rows());
    for (const auto& [first, count] : runs_)
        kernels::row_products(prepared_->deviations.row(first).data(), temperature.size(), count, temperature.size(),
                              temperature.data(), result.data() + first);
    return result;
}

std::vector<double> DenseSystem::variances(const Vector& deviations) const
{
    std::vector<double> result(problem_->surfaces.size(), 0.0);
    for (const std::size_t s : following_) {
        const Row first = prepared_->first_deviation[s], count = prepared_->first_deviation[s + 1] - first;
        result[s] = deviations.segment(first, count).squaredNorm() / geometry().surface_area[s];
    }
    return result;
}

// Temperature whose radiation a surface of a room receives, 0 for all others [K]: by the means of T^4.
std::vector<double> DenseSystem::irradiation(const Vector& means, const std::vector<double>& variances) const
{
    std::vector<double> result(problem_->surfaces.size(), 0.0);
    for (const auto& room : problem_->radiation) {
        const std::size_t count = room.surfaces.size();
        std::vector<double> fourth_power;
        for (const int surface : room.surfaces) {
            const double mean = means[surface];
            fourth_power.push_back(mean * mean * (mean * mean + 6 * variances[static_cast<std::size_t>(surface)]));
        }
        for (std::size_t i = 0; i < count; ++i) {
            double received = 0, all = 0;
            for (std::size_t j = 0; j < count; ++j) {
                const double exchange = room.exchange[i * count + j];
                received += exchange * fourth_power[j];
                all += exchange;
            }
            result[static_cast<std::size_t>(room.surfaces[i])] = std::sqrt(std::sqrt(received / all));
        }
    }
    return result;
}

// The matrix of a film is that of its first column, which gives the mean, and that of the deviations.
heat::FilmHeat DenseSystem::add_films(const std::vector<heat::FilmAt>& films, const Vector& temperature,
                                      Vector& watts) const
{
    const std::size_t count = problem_->surfaces.size();
    heat::FilmHeat heat{std::vector<double>(count, 0.0), std::vector<double>(count, 0.0),
                        std::vector<double>(count, 0.0)};
    const Vector means = surface_means(temperature);
    Vector away = deviations(temperature);
    const auto spread = variances(away);
    const auto received = irradiation(means, spread);
    std::vector<double> fluxes(count, 0.0);
    for (const auto& film : films) {
        const std::size_t s = film.surface;
        const double area = geometry().surface_area[s];
        if (!(area > 0))
            continue;
        const auto [value, inside, outside, slope] = at_mean(film, means[static_cast<Row>(s)], spread[s], received[s]);
        const Row first = prepared_->first_deviation[s], size = prepared_->first_deviation[s + 1] - first;
        away.segment(first, size) *= -slope;
        fluxes[s] = -(inside + outside);
        heat.lost[s] = area * (inside + outside);
        heat.to_surfaces[s] = area * inside;
        heat.untested[s] = value.in_range ? 0 : area;
    }
    add_functionals(surface_row(0), static_cast<Row>(count), fluxes.data(), watts);
    for (const auto& [first, size] : runs_)
        kernels::add_rows(prepared_->deviations.row(first).data(), watts.size(), size, watts.size(),
                          away.data() + first, watts.data());
    return heat;
}

void DenseSystem::add_film_slopes(const std::vector<heat::FilmAt>& films, const Vector& temperature, Vector& load) const
{
    const Vector means = surface_means(temperature);
    for (const auto& film : films) {
        const double at = means[static_cast<Row>(film.surface)];
        load += heat::film_slope(film.law(at), 0, at, film.surroundings) *
                terms_.functionals.row(surface_row(film.surface)).transpose();
    }
}

SymmetricMatrix DenseSystem::with_slopes(const std::vector<double>& slopes) const
{
    std::vector<SymmetricMatrix::Term> terms;
    for (const std::size_t s : following_)
        terms.push_back({slopes[s], &prepared_->film(s).matrix()});
    return conduction_->matrix().plus(terms);
}

// With the slopes r of the solver's matrix, Newton's method reduces its error in each iteration by at least
// d |q' - r| f / (1 + d r f), conduction left out, for the stiffest pattern f of a film.
bool DenseSystem::reduced_slopes_serve(double factor) const
{
    return std::ranges::all_of(following_, [&](std::size_t s) {
        const double stiffest = factor * prepared_->stiffest_film[s], reduced = reduced_slopes_[s];
        return stiffest * std::abs(slopes_[s] - reduced) <= largest_contraction * (1 + stiffest * reduced);
    });
}

void DenseSystem::reduce()
{
    reduced_slopes_ = slopes_;
    solver_.set_matrix(follows_ ? std::make_shared<const TridiagonalForm>(with_slopes(slopes_)) : conduction_->form());
    solver_.set_loads(loads_);
    reduced_ = true;
}

bool DenseSystem::build(double factor, const Vector& temperature, const std::vector<heat::FilmAt>& films)
{
    if (factor == factor_ && !follows_)
        return false;
    if (follows_) {
        const Vector means = surface_means(temperature);
        for (const auto& [surface, law, emissivity, surroundings] : films) {
            const double at = means[static_cast<Row>(surface)];
            slopes_[surface] = heat::film_slope(law(at), emissivity, at, surroundings);
        }
    }
    if (!reduced_ || !reduced_slopes_serve(factor))
        reduce();
    factor_ = factor;
    return true;
}

int DenseSystem::solve(const Vector& right, Vector& solution, const heat::LowRank<Vector>& low_rank,
                       heat::SolveTolerance, const std::string&)
{
    solver_.set_shift(factor_);
    Vector of_loads = Vector::Zero(solver_.loads());
    for (std::size_t r = 0; r < low_rank.source_slopes.size(); ++r)
        of_loads[static_cast<Row>(r)] = factor_ * low_rank.source_slopes[r];
    const auto others = static_cast<Row>(low_rank.others.size());
    Eigen::MatrixXd loads(right.size(), others);
    Vector of_others(others);
    for (Row k = 0; k < others; ++k) {
        const auto& [coefficient, load] = low_rank.others[static_cast<std::size_t>(k)];
        of_others[k] = coefficient;
        loads.col(k) = *load;
    }
    solver_.solve(right, of_loads, loads, of_others, solution);
    return 1;
}

void DenseSystem::begin_adjoint()
{
    with_films_ = conduction_->matrix();
    clear_adjoint();
}

void DenseSystem::set_film_coefficients(const std::vector<double>& coefficients)
{
    with_films_ = with_slopes(coefficients);
    clear_adjoint();
}

void DenseSystem::clear_adjoint()
{
    adjoint_.clear();
    adjoint_factors_.clear();
}

const SymmetricMatrix& DenseSystem::of_adjoint() const { return follows_ ? with_films_ : conduction_->matrix(); }

int DenseSystem::solve_adjoint(double factor, const Vector& right, Vector& solution, double)
{
    solution = right;
    if (!follows_) {
        const auto form = conduction_->form();
        form->into_basis(solution);
        const auto [found, is_new] = adjoint_factors_.try_emplace(factor);
        if (is_new)
            found->second = ShiftedFactor(*form, factor);
        found->second.solve_in_place(solution);
        form->from_basis(solution);
        return 1;
    }
    auto found = adjoint_.find(factor);
    if (found == adjoint_.end()) {
        if (adjoint_.size() >= most_factors)
            adjoint_.clear();
        Eigen::MatrixXd matrix = factor * with_films_.lower();
        matrix.diagonal().array() += 1;
        found = adjoint_.emplace(factor, matrix).first;
    }
    found->second.solveInPlace(solution);
    return 1;
}

std::vector<double> DenseSystem::start_shares(const Vector& weights, const Vector& start, double reference) const
{
    std::vector<double> result(problem_->surfaces.size() + 1, 0.0);
    result.back() = weights.dot(start - reference * terms_.uniform);
    return result;
}

}  // namespace deadpoint::reduce
