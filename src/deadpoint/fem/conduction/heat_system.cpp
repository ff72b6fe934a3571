#include "deadpoint/fem/conduction/heat_system.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace deadpoint::fem {
namespace {

// Of each solve of the adjoint, in the norm of its solution: what is left out of the shares of all causes together is
// of this size.
constexpr double adjoint_tolerance = 1e-8;

double longest_segment(const HeatProblem& problem)
{
    double longest = 0;
    for (const auto& segment : problem.segments)
        longest = std::max(longest, segment.duration);
    return longest;
}

bool same_place(const SurfaceCondition& a, const SurfaceCondition& b)
{
    return a.surface == b.surface && a.kind == b.kind && a.emissivity == b.emissivity &&
           a.laws.empty() == b.laws.empty() && a.enclosure == b.enclosure;
}

bool same_parts(const BodyHeat& a, const BodyHeat& b) { return a.parts == b.parts && a.surface == b.surface; }

}  // namespace

HeatSystem::HeatSystem(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem)
    : space_(space), materials_(materials), problem_(&problem), expansion_(space, materials),
      functionals_(space, problem), matrices_(space, materials, problem), prescribed_(space, problem),
      pattern_(create_vector(space, 1)), maps_(space, materials, matrices_, pattern_),
      films_(space, problem, functionals_.geometry().surface_area, prescribed_, pattern_),
      stage_(space, matrices_, maps_, prescribed_, films_, longest_segment(problem))
{}

bool HeatSystem::adopt(const HeatProblem& problem)
{
    const bool same = std::ranges::equal(problem.surfaces, problem_->surfaces, same_place) &&
                      std::ranges::equal(problem.radiation, problem_->radiation, {}, &RadiantRoom::surfaces,
                                         &RadiantRoom::surfaces) &&
                      std::ranges::equal(problem.body_heat, problem_->body_heat, same_parts) &&
                      matrices_.serve(problem);
    if (!same)
        return false;
    if (longest_segment(problem) > longest_segment(*problem_))
        stage_.reset(longest_segment(problem));  // the multigrid's bounds hold up to that
    problem_ = &problem;
    functionals_.adopt(problem);
    matrices_.adopt(problem);
    prescribed_.adopt(problem);
    films_.adopt(problem);
    return true;
}

OwnedVec HeatSystem::make_vector() const
{
    OwnedVec vector = duplicate(pattern_);
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

SparseFunctional HeatSystem::combined(const heat::Loads& loads) const
{
    SparseFunctional sum;
    for (const auto& [functional, factor] : loads) {
        const auto& term = functionals_[functional];
        sum.local.insert(sum.local.end(), term.local.begin(), term.local.end());
        for (const double weight : term.weight)
            sum.weight.push_back(factor * weight);
    }
    return sum;
}

void HeatSystem::set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads)
{
    functionals_.set_zones(laws);
    std::vector<SparseFunctional> loads;
    for (const auto& load : source_loads)
        loads.push_back(prescribed_.without(combined(load)));
    stage_.set_source_loads(std::move(loads));
    if (matrices_.set_laws(laws))
        stage_.reset(longest_segment(*problem_));
}

void HeatSystem::finish_load(OwnedVec& load) const
{
    DEADPOINT_PETSC(VecAssemblyBegin(load));
    DEADPOINT_PETSC(VecAssemblyEnd(load));
}

bool HeatSystem::build(double factor, const OwnedVec& temperature, const std::vector<heat::FilmAt>& films)
{
    if (factor == stage_.factor() && !follows_temperature())
        return false;
    if (films_.some())
        films_.build_tangents(films, temperature, matrices_.films());
    return stage_.combine(factor, temperature);
}

std::vector<heat::Term> HeatSystem::terms() const
{
    std::vector<heat::Term> terms;
    const auto& parts = space_.machine.parts;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        const double capacity = materials_[p].density * materials_[p].specific_heat * functionals_.part_volume()[p];
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
    const auto& part_of = maps_.part_of_unknown();
    const auto split = static_cast<std::size_t>(observation_.attribution.count);
    const std::size_t parts = space_.machine.parts.size();
    std::vector<double> sums(adjoints.size() + split * parts, 0.0);
    {
        const ConstEntries data(vector), at(temperature);
        const auto rise = [&](std::size_t i) {
            return is_slope ? expansion_.slope(i, at[i]) * data[i]
                            : expansion_.rise(i, data[i], observation_.reference);
        };
        for (std::size_t k = 0; k < adjoints.size(); ++k)
            for (std::size_t i = 0; i < adjoints[k].owned.size(); ++i)
                sums[k] += adjoints[k].owned[i] * rise(i);
        for (std::size_t k = 0; k < split; ++k) {
            const auto& weights = adjoints[static_cast<std::size_t>(observation_.attribution.first) + k].owned;
            for (std::size_t i = 0; i < weights.size(); ++i)
                sums[adjoints.size() + k * parts + part_of[i]] += weights[i] * rise(i);
        }
    }
    sum_over_ranks(sums);
    return sums;
}

void HeatSystem::widen(const OwnedVec& temperature, std::vector<double>& lowest, std::vector<double>& highest) const
{
    const auto& part_of = maps_.part_of_unknown();
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

// The heat is as booked and no longer follows the temperature, nor do enclosed air and radiation inside.
void HeatSystem::begin_adjoint()
{
    films_.forget_rooms();
    stage_.forget();
}

void HeatSystem::set_film_coefficients(const std::vector<double>& coefficients)
{
    films_.build_constant(coefficients, matrices_.films());
    stage_.forget();
}

void HeatSystem::apply_stiffness(const OwnedVec& in, OwnedVec& out) const
{
    DEADPOINT_PETSC(MatMult(matrices_.stiffness(), in, out));
    for (const Mat further : {matrices_.films(), matrices_.conduction()})
        if (further)
            DEADPOINT_PETSC(MatMultAdd(further, in, out, out));
}

int HeatSystem::solve_adjoint(double factor, const OwnedVec& right, OwnedVec& solution)
{
    if (factor != stage_.factor())
        stage_.combine(factor, nullptr);
    return stage_.solve_from_guess(right, solution, adjoint_tolerance, "the weights of the heat");
}

}  // namespace deadpoint::fem
