#include "deadpoint/fem/reduction/heat_projector.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/algebra/vectors.hpp"
#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/fem/conduction/multigrid/conjugate_gradients.hpp"
#include "deadpoint/fem/conduction/stage_matrix.hpp"
#include "deadpoint/fem/conduction/terms/heat_functionals.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/reduction/basis_fields.hpp"
#include "deadpoint/fem/reduction/block_solver.hpp"
#include "deadpoint/fem/reduction/columns.hpp"
#include "deadpoint/fem/reduction/field_file.hpp"
#include "deadpoint/fem/reduction/mpi_ranks.hpp"
#include "deadpoint/fem/reduction/residual.hpp"
#include "deadpoint/fem/reduction/surface_terms.hpp"
#include "deadpoint/fem/space/file_order.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"

#include <fmt/format.h>
#include <tuple>
#include <utility>

namespace deadpoint::fem {
namespace {

// Relative tolerance of a field by multigrid. The error left is one more field of the span (docs/reduced.md).
constexpr double field_tolerance = 1e-4;

HeatProblem with_constant_films(HeatProblem problem)
{
    problem.radiation.clear();
    for (auto& condition : problem.surfaces) {
        condition.laws.clear();
        condition.emissivity = 0;
    }
    return problem;
}

}  // namespace

struct HeatProjector::Parts {
    Parts(const Discretisation& space_, const std::vector<Material>& materials, const HeatProblem& problem_,
          const ObservedAdjoints& observed_, long long largest_factor_)
        : space(space_), problem(with_constant_films(problem_)), system(space, materials, problem), observed(observed_),
          largest_factor(largest_factor_), fields(space.last - space.first)
    {
        system.set_laws(problem.interfaces, {});
        append(Eigen::VectorXd::Ones(fields.rows()));
    }
    [[nodiscard]] Eigen::MatrixXd loads(const std::vector<std::size_t>& which) const;
    [[nodiscard]] Eigen::MatrixXd solved(double shift, const Eigen::MatrixXd& loads);
    void append(const Eigen::VectorXd& field);
    void append_solution(const Eigen::VectorXd& field);
    [[nodiscard]] Eigen::VectorXd on_part(std::size_t part) const;
    [[nodiscard]] Eigen::Map<const Eigen::VectorXd> adjoint(std::size_t k) const;
    [[nodiscard]] const std::vector<std::size_t>& order();
    [[nodiscard]] Eigen::MatrixXd functionals() const;
    [[nodiscard]] Eigen::MatrixXd observed_functionals() const;
    void add_split(std::size_t adjoint, Eigen::Ref<Eigen::MatrixXd> rows) const;
    [[nodiscard]] Eigen::MatrixXd parts();
    [[nodiscard]] std::size_t layout_count() const { return system.geometry().layout.count(); }

    const Discretisation& space;
    HeatProblem problem;  ///< whose coefficients the system has
    HeatSystem system;
    ObservedAdjoints observed;
    long long largest_factor;
    MpiRanks ranks;
    std::unique_ptr<BlockSolver> solver;
    BasisFields fields;
    Eigen::MatrixXd correction;  ///< combinations of the fields that are the basis
    std::vector<std::size_t> file_order;
};

HeatProjector::HeatProjector(const Discretisation& space, const std::vector<Material>& materials,
                             const HeatProblem& problem, const ObservedAdjoints& observed, long long largest_factor)
    : parts_(std::make_unique<Parts>(space, materials, problem, observed, largest_factor))
{}

HeatProjector::~HeatProjector() = default;

std::size_t HeatProjector::load_count() const { return parts_->layout_count() + parts_->observed.adjoints.size(); }

bool HeatProjector::has_load(std::size_t load) const
{
    const std::size_t count = parts_->layout_count();
    std::vector<double> entries{0};
    if (load < count)
        entries[0] = static_cast<double>(parts_->system.functionals()[load].local.size());
    else
        entries[0] = parts_->adjoint(load - count).lpNorm<1>();
    sum_over_ranks(entries);
    return entries[0] > 0;
}

Eigen::Map<const Eigen::VectorXd> HeatProjector::Parts::adjoint(std::size_t k) const
{
    return {observed.adjoints[k].owned.data(), fields.rows()};
}

Eigen::MatrixXd HeatProjector::Parts::loads(const std::vector<std::size_t>& which) const
{
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(fields.rows(), static_cast<Eigen::Index>(which.size()));
    for (std::size_t k = 0; k < which.size(); ++k) {
        auto column = columns.col(static_cast<Eigen::Index>(k));
        if (which[k] >= layout_count()) {
            column = adjoint(which[k] - layout_count());
            continue;
        }
        const auto& functional = system.functionals()[which[k]];
        for (std::size_t i = 0; i < functional.local.size(); ++i)
            column[functional.local[i]] += functional.weight[i];
    }
    return columns;
}

// Multigrid solves (M + K / shift) X = loads / shift.
Eigen::MatrixXd HeatProjector::Parts::solved(double shift, const Eigen::MatrixXd& loads)
{
    auto& matrices = system.matrices();
    if (space.total <= largest_factor) {
        if (!solver)
            solver = std::make_unique<BlockSolver>(matrices.stiffness());
        solver->set(matrices.stiffness(), shift, matrices.mass());
        return solver->solve(loads);
    }
    auto& stage = system.stage();
    stage.reset(1 / shift);
    stage.combine(1 / shift, nullptr);
    return solve_together(stage.assembled(), stage.cycle(), loads / shift, field_tolerance,
                          "a field of the reduced basis")
        .columns;
}

void HeatProjector::Parts::append(const Eigen::VectorXd& field)
{
    fields.append(field.cast<float>());
    correction = Eigen::MatrixXd::Identity(fields.count(), fields.count());
}

void HeatProjector::Parts::append_solution(const Eigen::VectorXd& field)
{
    std::vector<double> sum{field.sum()};
    sum_over_ranks(sum);
    append(field.array() - sum[0] / static_cast<double>(space.total));
}

void HeatProjector::add_solutions(const HeatProblem& at, double shift, const std::vector<std::size_t>& loads)
{
    auto& matrices = parts_->system.matrices();
    matrices.adopt(at);
    matrices.set_laws(at.interfaces);
    const auto solutions = parts_->solved(shift, parts_->loads(loads));
    for (const auto& solution : solutions.colwise())
        parts_->append_solution(solution);
}

// Order of the unknowns in files.
const std::vector<std::size_t>& HeatProjector::Parts::order()
{
    if (file_order.empty())
        file_order = order_of_file(space);
    return file_order;
}

// The field of 1 on a part and 0 elsewhere.
Eigen::VectorXd HeatProjector::Parts::on_part(std::size_t part) const
{
    const auto& part_of = system.part_of_unknown();
    Eigen::VectorXd field = Eigen::VectorXd::Zero(fields.rows());
    for (std::size_t i = 0; i < part_of.size(); ++i)
        field[static_cast<Eigen::Index>(i)] = part_of[i] == part ? 1 : 0;
    return field;
}

void HeatProjector::add_part(std::size_t part) { parts_->append(parts_->on_part(part)); }

std::size_t HeatProjector::field_count() const { return static_cast<std::size_t>(parts_->fields.count()); }

std::vector<float> HeatProjector::field(std::size_t field) const
{
    const auto own = parts_->fields.columns(static_cast<Eigen::Index>(field), 1);
    const auto all = gather_all(parts_->space, {own.data(), own.data() + own.size()}, 1);
    std::vector<float> result;
    result.reserve(all.size());
    for (const auto unknown : parts_->order())
        result.push_back(static_cast<float>(all[unknown]));
    return result;
}

void HeatProjector::add_field(const std::vector<float>& field)
{
    if (static_cast<PetscInt>(field.size()) != parts_->space.total)
        throw InputError("a field of the checkpoint has another number of temperatures than the mesh");
    const auto own = share_of_file(parts_->space, parts_->order(), field);
    parts_->append(Eigen::Map<const Eigen::VectorXd>(own.data(), static_cast<Eigen::Index>(own.size())));
}

heat::HeatGeometry HeatProjector::geometry() const { return parts_->system.geometry(); }

std::string HeatProjector::mesh() const { return mesh_text(parts_->space); }

Eigen::MatrixXd HeatProjector::gram()
{
    // All solutions are there.
    parts_->solver.reset();
    parts_->system.stage().reset(1);
    const auto& correction = parts_->correction;
    return correction.transpose() * projected(parts_->system.matrices().mass(), parts_->fields) * correction;
}

void HeatProjector::combine(const Eigen::MatrixXd& combinations)
{
    parts_->fields.combine(parts_->correction * combinations);
    parts_->correction = Eigen::MatrixXd::Identity(combinations.cols(), combinations.cols());
}

void HeatProjector::correct(const Eigen::MatrixXd& combinations) { parts_->correction *= combinations; }

const reduce::Ranks& HeatProjector::ranks() const { return parts_->ranks; }

// A row for each functional of the layout, of the fields.
Eigen::MatrixXd HeatProjector::Parts::functionals() const
{
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(layout_count()), fields.count());
    for (std::size_t k = 0; k < layout_count(); ++k)
        rows.row(static_cast<Eigen::Index>(k)) = fields.evaluate(system.functionals()[k]).transpose();
    sum_over_ranks(rows);
    return rows;
}

// The shares of an adjoint by part, a row for each.
void HeatProjector::Parts::add_split(std::size_t adjoint, Eigen::Ref<Eigen::MatrixXd> rows) const
{
    const auto& part_of = system.part_of_unknown();
    const auto& weights = observed.adjoints[adjoint].owned;
    for (Eigen::Index field = 0; field < fields.count(); ++field)
        for (std::size_t i = 0; i < weights.size(); ++i)
            rows(part_of[i], field) += weights[i] * static_cast<double>(fields[field][static_cast<Eigen::Index>(i)]);
}

// A row for each observed functional, of the fields: adjoints, then those that are split, part by part.
Eigen::MatrixXd HeatProjector::Parts::observed_functionals() const
{
    const auto count = observed.adjoints.size(), parts = space.machine.parts.size();
    const auto split = static_cast<std::size_t>(observed.attribution.count);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count + split * parts), fields.count());
    for (std::size_t k = 0; k < count; ++k)
        rows.row(static_cast<Eigen::Index>(k)) = fields.inner_products(adjoint(k)).transpose();
    for (std::size_t k = 0; k < split; ++k)
        add_split(static_cast<std::size_t>(observed.attribution.first) + k,
                  rows.middleRows(static_cast<Eigen::Index>(count + k * parts), static_cast<Eigen::Index>(parts)));
    sum_over_ranks(rows);
    return rows;
}

// Inner products of the fields with those of 1 on a part, a column for each.
Eigen::MatrixXd HeatProjector::Parts::parts()
{
    const auto count = space.machine.parts.size();
    Eigen::MatrixXd columns(fields.count(), static_cast<Eigen::Index>(count));
    for (std::size_t part = 0; part < count; ++part)
        columns.col(static_cast<Eigen::Index>(part)) =
            fields.inner_products(times(system.matrices().mass(), on_part(part)));
    sum_over_ranks(columns);
    return columns;
}

reduce::DenseTerms HeatProjector::project(const reduce::Truncation& truncation)
{
    auto& it = *parts_;
    auto& matrices = it.system.matrices();
    reduce::DenseTerms terms;
    terms.geometry = it.system.geometry();
    const Eigen::MatrixXd solid = it.correction.transpose() * projected(matrices.solid(), it.fields) * it.correction;
    terms.solid = (solid + solid.transpose()) / 2;
    terms.functionals = it.functionals() * it.correction;
    terms.observed = it.observed_functionals() * it.correction;
    terms.parts = it.correction.transpose() * it.parts();
    terms.uniform = terms.parts.rowwise().sum();
    project_surfaces(it.space, matrices, it.fields, it.correction, truncation, terms);
    return terms;
}

void HeatProjector::require_residual() const
{
    const auto& it = *parts_;
    if (it.space.total > it.largest_factor || it.ranks.count() > 1)
        throw InputError(fmt::format("a certificate is made by one process, for at most {} temperatures; this press "
                                     "has {}, on {} processes\n  help: leave out --certify, or enlarge the cells",
                                     it.largest_factor, it.space.total, it.ranks.count()));
}

std::optional<reduce::ResidualTerms> HeatProjector::residual(const reduce::ResidualTask& task, Observer& observer)
{
    require_residual();
    auto& it = *parts_;
    const auto problem = with_constant_films(task.lowest);
    auto& matrices = it.system.matrices();
    matrices.adopt(problem);
    matrices.set_laws(problem.interfaces);
    Eigen::MatrixXd observed(it.fields.rows(), static_cast<Eigen::Index>(it.observed.adjoints.size()));
    for (std::size_t k = 0; k < it.observed.adjoints.size(); ++k)
        observed.col(static_cast<Eigen::Index>(k)) = it.adjoint(k);
    auto result = residual_terms({it.space, it.system, it.fields, it.correction, observed}, task, observer);
    if (!result)
        return std::nullopt;
    result->lowest = reduce::coefficients_of(problem, HeatSegment{});
    reduce::set_products(*result);
    return result;
}

void HeatProjector::write_fields(const std::string& file, const std::string& model) const
{
    const auto& [fields, correction] = std::tie(parts_->fields, parts_->correction);
    fem::write_fields(file, parts_->space, model, static_cast<std::size_t>(correction.cols()), [&](std::size_t field) {
        return fields.combination(correction.col(static_cast<Eigen::Index>(field)));
    });
}

}  // namespace deadpoint::fem
