#include "deadpoint/fem/conduction/heat_system.hpp"

#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/stage_matrix.hpp"
#include "deadpoint/fem/conduction/terms/film_points.hpp"
#include "deadpoint/fem/conduction/terms/heat_functionals.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/conduction/terms/material_maps.hpp"
#include "deadpoint/fem/conduction/terms/prescribed.hpp"
#include "deadpoint/fem/space/expansion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace deadpoint::fem {
namespace {

// Tolerance of each solve of the adjoint, in the norm of its solution. The shares of all causes together leave out this
// much. The temperatures leave out as much of a rise of 1 K.
double adjoint_tolerance(const HeatProblem& problem) { return std::min(problem.solver_tolerance, 1e-6); }

/// A bound on the steps, which does not change where a run of some length is prolonged.
double longest_step(const HeatProblem& problem)
{
    double longest = 0;
    for (const auto& segment : problem.segments)
        longest = std::max(longest, segment.duration);
    return problem.fixed_step > 0 ? longest : std::min(longest, problem.max_step);
}

bool same_place(const SurfaceCondition& a, const SurfaceCondition& b)
{
    return a.surface == b.surface && a.part == b.part && a.kind == b.kind && a.emissivity == b.emissivity &&
           a.laws.empty() == b.laws.empty() && a.enclosure == b.enclosure;
}

bool same_parts(const BodyHeat& a, const BodyHeat& b) { return a.parts == b.parts && a.surface == b.surface; }

}  // namespace

struct HeatSystem::Parts {
    Parts(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem)
        : expansion(space, materials), functionals(space, problem), matrices(space, materials, problem),
          prescribed(space, problem), pattern(create_vector(space, 1)), maps(space, materials, matrices, pattern),
          films(space, problem, functionals.geometry().surface_area, prescribed, pattern),
          stage(space, matrices, maps, prescribed, films, longest_step(problem))
    {}

    [[nodiscard]] SparseFunctional combined(const heat::Loads& loads) const;

    Expansion expansion;
    HeatFunctionals functionals;
    HeatMatrices matrices;
    PrescribedTemperatures prescribed;
    OwnedVec pattern;
    MaterialMaps maps;
    FilmPoints films;
    StageMatrix stage;
};

HeatSystem::HeatSystem(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem)
    : space_(space), materials_(materials), problem_(&problem),
      parts_(std::make_unique<Parts>(space, materials, problem))
{}

HeatSystem::~HeatSystem() = default;

bool HeatSystem::adopt(const HeatProblem& problem)
{
    const bool same = std::ranges::equal(problem.surfaces, problem_->surfaces, same_place) &&
                      std::ranges::equal(problem.radiation, problem_->radiation, {}, &RadiantRoom::surfaces,
                                         &RadiantRoom::surfaces) &&
                      std::ranges::equal(problem.body_heat, problem_->body_heat, same_parts) &&
                      parts_->matrices.serve(problem);
    if (!same)
        return false;
    if (longest_step(problem) > longest_step(*problem_))
        parts_->stage.reset(longest_step(problem));  // the multigrid's bounds hold up to this step size
    problem_ = &problem;
    parts_->functionals.adopt(problem);
    parts_->matrices.adopt(problem);
    parts_->prescribed.adopt(problem);
    parts_->films.adopt(problem);
    return true;
}

OwnedVec HeatSystem::make_vector() const
{
    OwnedVec vector = duplicate(parts_->pattern);
    DEADPOINT_PETSC(VecZeroEntries(vector));
    return vector;
}

void HeatSystem::combine(const std::vector<heat::Scaled<OwnedVec>>& sum, OwnedVec& result) const
{
    std::vector<double> factors;
    std::vector<Vec> vectors;
    for (const auto& [factor, vector] : sum) {
        factors.push_back(factor);
        vectors.push_back(*vector);
    }
    DEADPOINT_PETSC(VecZeroEntries(result));
    DEADPOINT_PETSC(VecMAXPY(result, static_cast<PetscInt>(sum.size()), factors.data(), vectors.data()));
}

double HeatSystem::total(const OwnedVec& vector) const
{
    PetscScalar sum = 0;
    DEADPOINT_PETSC(VecSum(vector, &sum));
    return sum;
}

double HeatSystem::dot(const OwnedVec& a, const OwnedVec& b) const
{
    PetscScalar product = 0;
    DEADPOINT_PETSC(VecDot(a, b, &product));
    return product;
}

double HeatSystem::largest(const OwnedVec& vector) const
{
    PetscReal norm = 0;
    DEADPOINT_PETSC(VecNorm(vector, NORM_INFINITY, &norm));
    return norm;
}

bool HeatSystem::is_finite(const OwnedVec& vector) const
{
    PetscReal norm = 0;
    DEADPOINT_PETSC(VecNorm(vector, NORM_1, &norm));
    return std::isfinite(norm);
}

bool HeatSystem::any(bool flag) const
{
    int value = flag ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD);
    return value != 0;
}

SparseFunctional HeatSystem::Parts::combined(const heat::Loads& loads) const
{
    SparseFunctional sum;
    for (const auto& [functional, factor] : loads) {
        const auto& term = functionals[functional];
        sum.local.insert(sum.local.end(), term.local.begin(), term.local.end());
        for (const double weight : term.weight)
            sum.weight.push_back(factor * weight);
    }
    return sum;
}

void HeatSystem::set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads)
{
    parts_->functionals.set_zones(laws);
    std::vector<SparseFunctional> loads;
    for (const auto& load : source_loads)
        loads.push_back(parts_->prescribed.without(parts_->combined(load)));
    parts_->stage.set_source_loads(std::move(loads));
    if (parts_->matrices.set_laws(laws))
        parts_->stage.reset(longest_step(*problem_));
}

void HeatSystem::finish_load(OwnedVec& load) const
{
    DEADPOINT_PETSC(VecAssemblyBegin(load));
    DEADPOINT_PETSC(VecAssemblyEnd(load));
}

bool HeatSystem::build(double factor, const OwnedVec& temperature, const std::vector<heat::FilmAt>& films)
{
    if (factor == parts_->stage.factor() && !follows_temperature())
        return false;
    if (parts_->films.some())
        parts_->films.build_tangents(films, temperature, parts_->matrices.films());
    return parts_->stage.combine(factor, temperature);
}

std::vector<heat::Term> HeatSystem::terms() const
{
    std::vector<heat::Term> terms;
    const auto& parts = space_.machine.parts;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const double capacity =
            materials_[p].density * materials_[p].specific_heat * parts_->functionals.part_volume()[p];
        const double conductivity = materials_[p].conductivity;
        terms.push_back({fmt::format("the heat capacity of parts.{}: {:.3g} J/K", parts[p].name, capacity), capacity});
        terms.push_back(
            {fmt::format("the conductivity of parts.{}: {:.3g} W/m/K", parts[p].name, conductivity), conductivity});
    }
    return terms;
}

std::vector<double> HeatSystem::observe(const OwnedVec& vector, const OwnedVec& temperature, bool is_slope) const
{
    if (!observation_.adjoints)
        return {};
    const auto& adjoints = *observation_.adjoints;
    const auto& part_of = parts_->maps.part_of_unknown();
    const auto split = static_cast<std::size_t>(observation_.attribution.count);
    const std::size_t parts = space_.machine.parts.size();
    std::vector<double> sums(adjoints.size() + split * parts, 0.0);
    {
        const ConstEntries data(vector), at(temperature);
        std::vector<double> rise(part_of.size());
        for (std::size_t i = 0; i < rise.size(); ++i)
            rise[i] = is_slope ? parts_->expansion.slope(i, at[i]) * data[i]
                               : parts_->expansion.rise(i, data[i], observation_.reference);
        for (std::size_t k = 0; k < adjoints.size(); ++k)
            sums[k] = std::inner_product(rise.begin(), rise.end(), adjoints[k].owned.begin(), 0.0);
        for (std::size_t k = 0; k < split; ++k) {
            const auto& weights = adjoints[static_cast<std::size_t>(observation_.attribution.first) + k].owned;
            for (std::size_t i = 0; i < weights.size(); ++i)
                sums[adjoints.size() + k * parts + part_of[i]] += weights[i] * rise[i];
        }
    }
    sum_over_ranks(sums);
    return sums;
}

void HeatSystem::widen(const OwnedVec& temperature, std::vector<double>& lowest, std::vector<double>& highest) const
{
    const auto& part_of = parts_->maps.part_of_unknown();
    {
        const ConstEntries values(temperature);
        for (std::size_t i = 0; i < part_of.size(); ++i) {
            lowest[part_of[i]] = std::min(lowest[part_of[i]], values[i]);
            highest[part_of[i]] = std::max(highest[part_of[i]], values[i]);
        }
    }
    const auto count = static_cast<int>(lowest.size());
    MPI_Allreduce(MPI_IN_PLACE, lowest.data(), count, MPI_DOUBLE, MPI_MIN, PETSC_COMM_WORLD);
    MPI_Allreduce(MPI_IN_PLACE, highest.data(), count, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
}

// Uses the recorded heat, which no longer follows the temperature; the same holds for enclosed air and inner radiation.
void HeatSystem::begin_adjoint()
{
    parts_->films.forget_rooms();
    parts_->stage.forget();
}

void HeatSystem::set_film_coefficients(const std::vector<double>& coefficients)
{
    parts_->films.build_constant(coefficients, parts_->matrices.films());
    parts_->stage.forget();
}

void HeatSystem::apply_stiffness(const OwnedVec& in, OwnedVec& out) const
{
    DEADPOINT_PETSC(MatMult(parts_->matrices.stiffness(), in, out));
    for (const Mat further : {parts_->matrices.films(), parts_->matrices.conduction()})
        if (further)
            DEADPOINT_PETSC(MatMultAdd(further, in, out, out));
}

int HeatSystem::solve_adjoint(double factor, const OwnedVec& right, OwnedVec& solution, double tolerance)
{
    if (factor != parts_->stage.factor())
        parts_->stage.combine(factor, nullptr);
    return parts_->stage.solve_from_guess(right, solution, tolerance > 0 ? tolerance : adjoint_tolerance(*problem_),
                                          "the weights of the heat");
}

void HeatSystem::observe_with(Observation observation) { observation_ = observation; }

StageMatrix& HeatSystem::stage() { return parts_->stage; }

int HeatSystem::integrations() const { return parts_->matrices.integrations(); }
HeatMatrices& HeatSystem::matrices() { return parts_->matrices; }
const HeatFunctionals& HeatSystem::functionals() const { return parts_->functionals; }
const std::vector<std::uint32_t>& HeatSystem::part_of_unknown() const { return parts_->maps.part_of_unknown(); }

void HeatSystem::copy(const OwnedVec& from, OwnedVec& to) const { DEADPOINT_PETSC(VecCopy(from, to)); }

void HeatSystem::add(double factor, const OwnedVec& term, OwnedVec& sum) const
{
    DEADPOINT_PETSC(VecAXPY(sum, factor, term));
}

const heat::HeatGeometry& HeatSystem::geometry() const { return parts_->functionals.geometry(); }

std::vector<double> HeatSystem::evaluate(std::span<const std::size_t> which, const OwnedVec& vector) const
{
    return parts_->functionals.evaluate(which, vector);
}

void HeatSystem::add_loads(const std::vector<double>& watts, OwnedVec& vector) const
{
    parts_->functionals.add_loads(watts, vector);
}

bool HeatSystem::follows_temperature() const { return parts_->films.some() || parts_->maps.vary(); }

bool HeatSystem::is_linear() const { return !follows_temperature() && !parts_->prescribed.some(); }

void HeatSystem::store(const OwnedVec& temperature, OwnedVec& stored) const { parts_->maps.store(temperature, stored); }

void HeatSystem::conduct(const OwnedVec& temperature, OwnedVec& conducted) const
{
    parts_->maps.conduct(temperature, conducted);
}

void HeatSystem::apply_stage(const OwnedVec& in, OwnedVec& out) const
{
    DEADPOINT_PETSC(MatMult(parts_->stage.assembled(), in, out));
}

double HeatSystem::stored_between(const OwnedVec& from, const OwnedVec& to) const
{
    return parts_->maps.stored_between(from, to);
}

heat::FilmHeat HeatSystem::add_films(const std::vector<heat::FilmAt>& films, const OwnedVec& temperature,
                                     OwnedVec& watts) const
{
    return parts_->films.add_heat(films, temperature, watts);
}

void HeatSystem::add_film_slopes(const std::vector<heat::FilmAt>& films, const OwnedVec& temperature,
                                 OwnedVec& load) const
{
    parts_->films.add_slopes(films, temperature, load);
}

bool HeatSystem::some_prescribed() const { return parts_->prescribed.some(); }

void HeatSystem::impose(double time, OwnedVec& temperature) const { parts_->prescribed.impose(time, temperature); }

void HeatSystem::clear_prescribed(OwnedVec& vector) const { parts_->prescribed.clear(vector); }

double HeatSystem::total_prescribed(const OwnedVec& vector) const { return parts_->prescribed.total(vector); }

int HeatSystem::solve(const OwnedVec& right, OwnedVec& solution, const heat::LowRank<OwnedVec>& low_rank,
                      heat::SolveTolerance tolerance, const std::string& what)
{
    return parts_->stage.solve(right, solution, low_rank, tolerance, what.c_str());
}

void HeatSystem::apply_mass(const OwnedVec& in, OwnedVec& out) const
{
    DEADPOINT_PETSC(MatMult(parts_->matrices.mass(), in, out));
}

std::vector<double> HeatSystem::prescribed_shares(const OwnedVec& right, const OwnedVec& left, double time,
                                                  double reference) const
{
    return parts_->prescribed.shares(right, left, time, reference);
}

std::vector<double> HeatSystem::start_shares(const OwnedVec& weights, const OwnedVec& start, double reference) const
{
    return parts_->prescribed.start_shares(weights, start, reference);
}

}  // namespace deadpoint::fem
