#include "deadpoint/fem/reduction/heat_projector.hpp"

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/conduction/heat_functionals.hpp"
#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/fem/conduction/stage_matrix.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/reduction/block_solver.hpp"
#include "deadpoint/fem/reduction/columns.hpp"
#include "deadpoint/fem/reduction/field_file.hpp"
#include "deadpoint/fem/reduction/surface_terms.hpp"
#include "deadpoint/fem/space/vectors.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/gram.hpp"

#include <utility>

namespace deadpoint::fem {
namespace {

HeatProblem with_constant_films(HeatProblem problem)
{
    problem.radiation.clear();
    for (auto& condition : problem.surfaces) {
        condition.laws.clear();
        condition.emissivity = 0;
    }
    return problem;
}

// The observed functionals, a column for each: adjoints, then those that are split, part by part.
Eigen::MatrixXd columns_of(const ObservedAdjoints& observed, const std::vector<std::uint32_t>& part_of,
                           std::size_t parts)
{
    const auto rows = static_cast<Eigen::Index>(part_of.size());
    const auto count = observed.adjoints.size();
    const auto split = static_cast<std::size_t>(observed.attribution.count);
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(count + split * parts));
    for (std::size_t k = 0; k < count; ++k)
        columns.col(static_cast<Eigen::Index>(k)) =
            Eigen::Map<const Eigen::VectorXd>(observed.adjoints[k].owned.data(), rows);
    for (std::size_t k = 0; k < split; ++k) {
        const auto& weights = observed.adjoints[static_cast<std::size_t>(observed.attribution.first) + k].owned;
        for (std::size_t i = 0; i < weights.size(); ++i)
            columns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(count + k * parts + part_of[i])) =
                weights[i];
    }
    return columns;
}

}  // namespace

struct HeatProjector::Parts {
    Parts(const Discretisation& space_, const std::vector<Material>& materials, const HeatProblem& problem_,
          const ObservedAdjoints& recorded)
        : space(space_), problem(with_constant_films(problem_)), system(space, materials, problem),
          observed(columns_of(recorded, system.part_of_unknown(), space.machine.parts.size())),
          adjoints(static_cast<Eigen::Index>(recorded.adjoints.size()))
    {
        system.set_laws(problem.interfaces, {});
        basis = Eigen::MatrixXd::Ones(space.last - space.first, 1);
    }
    [[nodiscard]] Eigen::MatrixXd loads(const std::vector<std::size_t>& which) const;
    [[nodiscard]] Eigen::MatrixXd solved(double shift, const Eigen::MatrixXd& loads);
    void append(const Eigen::MatrixXd& columns);
    [[nodiscard]] Eigen::MatrixXd on_parts() const;
    [[nodiscard]] reduce::RowMatrix functionals() const;
    [[nodiscard]] std::size_t layout_count() const { return system.geometry().layout.count(); }

    const Discretisation& space;
    HeatProblem problem;  ///< whose coefficients the system has
    HeatSystem system;
    Eigen::MatrixXd observed;
    Eigen::Index adjoints;
    std::unique_ptr<BlockSolver> solver;
    Eigen::MatrixXd basis;
};

HeatProjector::HeatProjector(const Discretisation& space, const std::vector<Material>& materials,
                             const HeatProblem& problem, const ObservedAdjoints& observed)
    : parts_(std::make_unique<Parts>(space, materials, problem, observed))
{}

HeatProjector::~HeatProjector() = default;

std::size_t HeatProjector::load_count() const
{
    return parts_->layout_count() + static_cast<std::size_t>(parts_->adjoints);
}

bool HeatProjector::has_load(std::size_t load) const
{
    const std::size_t count = parts_->layout_count();
    std::vector<double> entries{0};
    if (load < count)
        entries[0] = static_cast<double>(parts_->system.functionals()[load].local.size());
    else
        entries[0] = parts_->observed.col(static_cast<Eigen::Index>(load - count)).lpNorm<1>();
    sum_over_ranks(entries);
    return entries[0] > 0;
}

Eigen::MatrixXd HeatProjector::Parts::loads(const std::vector<std::size_t>& which) const
{
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(basis.rows(), static_cast<Eigen::Index>(which.size()));
    for (std::size_t k = 0; k < which.size(); ++k) {
        auto column = columns.col(static_cast<Eigen::Index>(k));
        if (which[k] >= layout_count()) {
            column = observed.col(static_cast<Eigen::Index>(which[k] - layout_count()));
            continue;
        }
        const auto& functional = system.functionals()[which[k]];
        for (std::size_t i = 0; i < functional.local.size(); ++i)
            column[functional.local[i]] += functional.weight[i];
    }
    return columns;
}

// Multigrid solves (M + K / shift) x = load / shift, one load after the other.
Eigen::MatrixXd HeatProjector::Parts::solved(double shift, const Eigen::MatrixXd& loads)
{
    auto& matrices = system.matrices();
    if (space.total <= largest_heat_factor) {
        if (!solver)
            solver = std::make_unique<BlockSolver>(matrices.stiffness());
        solver->set(matrices.stiffness(), shift, matrices.mass());
        return solver->solve(loads);
    }
    system.stage().reset(1 / shift);
    auto right = system.make_vector(), solution = system.make_vector();
    system.build(1 / shift, right, {});
    Eigen::MatrixXd result(loads.rows(), loads.cols());
    for (Eigen::Index k = 0; k < loads.cols(); ++k) {
        Eigen::Map<Eigen::VectorXd>(Entries(right).data(), loads.rows()) = loads.col(k) / shift;
        system.solve(right, solution, {}, {1e-6, 0}, "a field of the reduced basis");
        result.col(k) = Eigen::Map<const Eigen::VectorXd>(ConstEntries(solution).data(), loads.rows());
    }
    return result;
}

void HeatProjector::Parts::append(const Eigen::MatrixXd& columns)
{
    const auto before = basis.cols();
    basis.conservativeResize(Eigen::NoChange, before + columns.cols());
    basis.rightCols(columns.cols()) = columns;
}

void HeatProjector::add_solutions(const HeatProblem& at, double shift, const std::vector<std::size_t>& loads)
{
    auto& matrices = parts_->system.matrices();
    matrices.adopt(at);
    matrices.set_laws(at.interfaces);
    parts_->append(parts_->solved(shift, parts_->loads(loads)));
}

// Fields of 1 on a part and 0 elsewhere.
Eigen::MatrixXd HeatProjector::Parts::on_parts() const
{
    const auto& part_of = system.part_of_unknown();
    Eigen::MatrixXd columns =
        Eigen::MatrixXd::Zero(basis.rows(), static_cast<Eigen::Index>(space.machine.parts.size()));
    for (std::size_t i = 0; i < part_of.size(); ++i)
        columns(static_cast<Eigen::Index>(i), part_of[i]) = 1;
    return columns;
}

void HeatProjector::add_part(std::size_t part)
{
    parts_->append(parts_->on_parts().col(static_cast<Eigen::Index>(part)));
}

std::size_t HeatProjector::orthonormalise(double least)
{
    const Mat mass = parts_->system.matrices().mass();
    auto& basis = parts_->basis;
    basis = combined(basis, reduce::orthonormal_combinations(inner_products(basis, times(mass, basis)), least));
    basis = combined(basis, reduce::orthonormal_combinations(inner_products(basis, times(mass, basis)), 0));
    return static_cast<std::size_t>(basis.cols());
}

void HeatProjector::combine(const Eigen::MatrixXd& combinations)
{
    parts_->basis = combined(parts_->basis, combinations);
}

reduce::RowMatrix HeatProjector::Parts::functionals() const
{
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(layout_count()), basis.cols());
    for (std::size_t k = 0; k < layout_count(); ++k) {
        const auto& functional = system.functionals()[k];
        for (std::size_t i = 0; i < functional.local.size(); ++i)
            rows.row(static_cast<Eigen::Index>(k)) += functional.weight[i] * basis.row(functional.local[i]);
    }
    sum_over_ranks(rows);
    return rows;
}

reduce::DenseTerms HeatProjector::project(const reduce::Truncation& truncation)
{
    auto& matrices = parts_->system.matrices();
    const auto& basis = parts_->basis;
    reduce::DenseTerms terms;
    terms.geometry = parts_->system.geometry();
    const Eigen::MatrixXd solid = inner_products(basis, times(matrices.solid(), basis));
    terms.solid = (solid + solid.transpose()) / 2;
    terms.functionals = parts_->functionals();
    terms.observed = inner_products(parts_->observed, basis);
    terms.parts = inner_products(basis, times(matrices.mass(), parts_->on_parts()));
    terms.uniform = terms.parts.rowwise().sum();
    project_surfaces(parts_->space, matrices, basis, truncation, terms);
    return terms;
}

void HeatProjector::write_fields(const std::string& file, const std::string& model) const
{
    const auto& basis = parts_->basis;
    fem::write_fields(
        file, parts_->space, model, static_cast<std::size_t>(basis.cols()),
        [&](std::size_t field) -> Eigen::VectorXd { return basis.col(static_cast<Eigen::Index>(field)); });
}

}  // namespace deadpoint::fem
