#include "deadpoint/fem/reduction/residual.hpp"

#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/fem/conduction/terms/heat_functionals.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/reduction/basis_fields.hpp"
#include "deadpoint/fem/reduction/block_solver.hpp"
#include "deadpoint/fem/reduction/columns.hpp"
#include "deadpoint/fem/reduction/gathered_term.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/certificate/directions.hpp"
#include "deadpoint/reduce/certificate/residual_root.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/low_rank.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::fem {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

constexpr Index block_size = 64;  // columns that are solved for together

TermSum alone(const SparseTerm& term) { return term.entries() > 0 ? TermSum{{1, &term}} : TermSum{}; }

// J = S_aa + S_bb - S_ab - S_ab^T.
TermSum between(const JointTerm& joint, const SparseTerm& across)
{
    return across.entries() > 0 ? TermSum{{1, &joint.aa}, {1, &joint.bb}, {-1, &across}} : TermSum{};
}

// In the order of reduce::PreparedTerms::each; empty where there is no such term.
std::vector<TermSum> all_terms(const HeatMatrices& matrices)
{
    std::vector<TermSum> result;
    for (const auto& joint : matrices.joint_terms())
        result.insert(result.end(),
                      {alone(joint.aa), alone(joint.bb), between(joint, joint.across), between(joint, joint.turning)});
    for (const auto& film : matrices.film_terms())
        result.push_back(alone(film));
    return result;
}

/// Columns that are zero outside of some rows.
struct SparseColumns {
    std::vector<Index> rows;
    MatrixXd values;
    [[nodiscard]] MatrixXd block(Index all_rows, Index first, Index count) const
    {
        MatrixXd result = MatrixXd::Zero(all_rows, count);
        for (std::size_t i = 0; i < rows.size(); ++i)
            result.row(rows[i]) += values.row(static_cast<Index>(i)).segment(first, count);
        return result;
    }
    [[nodiscard]] MatrixXd times(const MatrixXd& columns) const
    {
        return product_of_transposed(values, columns(rows, Eigen::all));
    }
};

/// The vectors of a residual. Those of M V are M times the fields, which the correction combines.
class Vectors {
public:
    explicit Vectors(const ProjectedMachine& machine) : it_(machine), matrices_(machine.system.matrices()) {}

    /// Adds the terms' vectors.
    void add_terms(const reduce::ResidualTask& task, reduce::ResidualTerms& result)
    {
        const auto terms = all_terms(matrices_);
        const auto& correction = it_.correction;
        std::vector<MatrixXd> factors;
        for (const auto& sum : terms)
            factors.push_back(factor_of(sum, task.cut.further));
        const MatrixXd solid = correction.transpose() * projected(matrices_.solid(), it_.fields) * correction;
        factors.push_back(reduce::factor_of((solid + solid.transpose()) / 2, task.cut.further));
        const auto combinations = reduce::choose_directions(factors, task, result);
        for (std::size_t q = 0; q < terms.size(); ++q) {
            if (combinations[q].cols() == 0)
                continue;
            const GatheredTerm term(it_.space, terms[q], it_.fields, 0);
            sparse_.push_back(
                {{term.unknowns().begin(), term.unknowns().end()}, term.image(correction * combinations[q])});
        }
        of_solid_ = correction * combinations.back();
    }

    void add_functionals()
    {
        for (std::size_t k = 0; k < it_.system.geometry().layout.count(); ++k) {
            const auto& [local, weight] = it_.system.functionals()[k];
            further_.push_back({{local.begin(), local.end()},
                                Eigen::Map<const Eigen::VectorXd>(weight.data(), static_cast<Index>(weight.size()))});
        }
    }

    [[nodiscard]] Index states() const { return it_.fields.count(); }
    [[nodiscard]] Index count() const
    {
        Index sum = states() + of_solid_.cols() + it_.observed.cols();
        for (const auto* list : {&sparse_, &further_})
            for (const auto& columns : *list)
                sum += columns.values.cols();
        return sum;
    }

    /// Calls visit(first, dense, block) for blocks of all columns, in order.
    template <class Visit>
    void for_each_block(const Visit& visit) const
    {
        Index at = 0;
        const auto in_blocks = [&](Index columns, bool dense, const auto& block_of) {
            for (Index first = 0; first < columns; first += block_size) {
                const Index size = std::min(block_size, columns - first);
                visit(at, dense, MatrixXd(block_of(first, size)));
                at += size;
            }
        };
        const auto rows = it_.fields.rows();
        const auto in_sparse_blocks = [&](const std::vector<SparseColumns>& list) {
            for (const auto& columns : list)
                in_blocks(columns.values.cols(), false,
                          [&](Index first, Index size) { return columns.block(rows, first, size); });
        };
        in_blocks(states(), true,
                  [&](Index first, Index size) { return times(matrices_.mass(), it_.fields.columns(first, size)); });
        in_sparse_blocks(sparse_);
        in_blocks(of_solid_.cols(), true, [&](Index first, Index size) {
            return times(matrices_.solid(), it_.fields.combinations(of_solid_.middleCols(first, size)));
        });
        in_sparse_blocks(further_);
        in_blocks(it_.observed.cols(), false,
                  [&](Index first, Index size) { return it_.observed.middleCols(first, size); });
    }

    /// Products of all vectors with columns; of the dense ones only if asked for, else zero.
    [[nodiscard]] MatrixXd products(const MatrixXd& columns, bool with_dense) const
    {
        MatrixXd result = MatrixXd::Zero(count(), columns.cols());
        Index at = states();
        const auto add = [&](const std::vector<SparseColumns>& list) {
            for (const auto& one : list) {
                result.middleRows(at, one.values.cols()) = one.times(columns);
                at += one.values.cols();
            }
        };
        add(sparse_);
        if (with_dense) {
            result.topRows(states()) = it_.fields.inner_products(times(matrices_.mass(), columns));
            result.middleRows(at, of_solid_.cols()) =
                of_solid_.transpose() * it_.fields.inner_products(times(matrices_.solid(), columns));
        }
        at += of_solid_.cols();
        add(further_);
        result.bottomRows(it_.observed.cols()) = it_.observed.transpose() * columns;
        return result;
    }

private:
    // Low-rank factor of a term on the basis.
    [[nodiscard]] MatrixXd factor_of(const TermSum& sum, double tolerance) const
    {
        const auto& correction = it_.correction;
        if (sum.empty())
            return {correction.cols(), 0};
        const GatheredTerm term(it_.space, sum, it_.fields, 0);
        return reduce::low_rank_factor(
            [&](const MatrixXd& columns) {
                return MatrixXd(correction.transpose() * term.product(correction * columns));
            },
            correction.cols(), tolerance);
    }

    const ProjectedMachine& it_;
    HeatMatrices& matrices_;
    std::vector<SparseColumns> sparse_, further_;  ///< of terms, and of functionals
    MatrixXd of_solid_;                            ///< K_0 times the fields times these are the vectors of K_0
};

// K'^-1 block. One step of refinement: a machine that is nearly insulated magnifies rounding by the heat that it
// stores.
MatrixXd refined(BlockSolver& solver, Mat matrix, const MatrixXd& block)
{
    MatrixXd solution = solver.solve(block);
    solution += solver.solve(block - times(matrix, solution));
    return solution;
}

// The products of all vectors, those of M times the fields instead of the basis; nothing after a cancellation.
std::optional<MatrixXd> products_of_fields(const Vectors& vectors, HeatMatrices& matrices, Observer& observer)
{
    BlockSolver solver(matrices.stiffness());
    solver.set(matrices.stiffness(), 0, matrices.mass());
    const Index count = vectors.count();
    MatrixXd gram(count, count);
    std::vector<bool> is_dense(static_cast<std::size_t>(count), false);
    bool cancelled = false;
    vectors.for_each_block([&](Index first, bool dense, const MatrixXd& block) {
        cancelled = cancelled || observer.cancelled();
        if (cancelled)
            return;
        const MatrixXd solved = refined(solver, matrices.stiffness(), block);
        gram.middleCols(first, block.cols()) = vectors.products(solved, dense);
        std::fill_n(is_dense.begin() + first, block.cols(), dense);
        const Index done = first + block.cols();
        observer.progress(static_cast<double>(done) / static_cast<double>(count),
                          fmt::format("{} of {} vectors", done, count));
    });
    if (cancelled)
        return std::nullopt;
    for (Index j = 0; j < count; ++j)
        for (Index i = 0; i < count; ++i)
            if (is_dense[static_cast<std::size_t>(i)] && !is_dense[static_cast<std::size_t>(j)])
                gram(i, j) = gram(j, i);
    return gram;
}

void correct(MatrixXd& gram, const MatrixXd& correction)
{
    const Index n = correction.rows();
    gram.topRows(n) = (correction.transpose() * gram.topRows(n)).eval();
    gram.leftCols(n) = (gram.leftCols(n) * correction).eval();
}

}  // namespace

std::optional<reduce::ResidualTerms> residual_terms(const ProjectedMachine& machine, const reduce::ResidualTask& task,
                                                    Observer& observer)
{
    const auto& correction = machine.correction;
    Vectors vectors(machine);
    reduce::ResidualTerms result;
    result.states = correction.cols();
    vectors.add_terms(task, result);
    vectors.add_functionals();
    result.functionals = static_cast<Index>(machine.system.geometry().layout.count());
    result.observed = machine.observed.cols();
    auto gram = products_of_fields(vectors, machine.system.matrices(), observer);
    if (!gram)
        return std::nullopt;
    correct(*gram, correction);
    result.root = reduce::residual_root(*gram);
    return result;
}

}  // namespace deadpoint::fem
