#include "deadpoint/fem/reduction/residual.hpp"

#include "deadpoint/fem/conduction/heat_functionals.hpp"
#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/reduction/basis_fields.hpp"
#include "deadpoint/fem/reduction/block_solver.hpp"
#include "deadpoint/fem/reduction/columns.hpp"
#include "deadpoint/fem/reduction/gathered_term.hpp"
#include "deadpoint/reduce/certificate/residual_root.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/low_rank.hpp"

#include <algorithm>

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

// In the order of reduce::PreparedTerms::packed; empty where there is no such term.
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
        return values.transpose() * columns(rows, Eigen::all);
    }
};

/// The vectors of a residual. Those of M V and K_0 V are M and K_0 times the fields, which the correction combines.
class Vectors {
public:
    explicit Vectors(const ProjectedMachine& machine) : it_(machine), matrices_(machine.system.matrices()) {}

    /// Adds the terms' kept vectors. @return the terms on the basis
    std::vector<reduce::ResidualTerm> add_terms(const reduce::ResidualCut& cut)
    {
        std::vector<reduce::ResidualTerm> result;
        for (const auto& sum : all_terms(matrices_)) {
            auto& reduced = result.emplace_back();
            if (sum.empty())
                continue;
            GatheredTerm term(it_.space, sum, it_.fields, 0);
            term.combine(it_.correction);
            reduced.factor = reduce::low_rank_factor([&](const MatrixXd& columns) { return term.product(columns); },
                                                     it_.correction.cols(), cut.further);
            const Eigen::VectorXd sizes = reduced.factor.colwise().squaredNorm().transpose();
            reduced.kept = sizes.size() == 0 ? 0 : (sizes.array() > cut.kept * sizes.maxCoeff()).count();
            const MatrixXd scaled =
                reduced.factor.leftCols(reduced.kept) * sizes.head(reduced.kept).cwiseInverse().asDiagonal();
            sparse_.push_back({{term.unknowns().begin(), term.unknowns().end()}, term.image(scaled)});
        }
        return result;
    }

    void add_functionals()
    {
        for (std::size_t k = 0; k < it_.system.geometry().layout.count(); ++k) {
            const auto& [local, weight] = it_.system.functionals()[k];
            sparse_.push_back({{local.begin(), local.end()},
                               Eigen::Map<const Eigen::VectorXd>(weight.data(), static_cast<Index>(weight.size()))});
        }
    }

    [[nodiscard]] Index dense_count() const { return 2 * it_.fields.count(); }
    [[nodiscard]] Index count() const
    {
        Index sum = dense_count() + it_.observed.cols();
        for (const auto& columns : sparse_)
            sum += columns.values.cols();
        return sum;
    }

    /// Calls visit(first, block) for blocks of all columns, in order.
    template <class Visit>
    void for_each_block(const Visit& visit) const
    {
        Index at = 0;
        const auto in_blocks = [&](Index columns, const auto& block_of) {
            for (Index first = 0; first < columns; first += block_size) {
                const Index size = std::min(block_size, columns - first);
                visit(at, MatrixXd(block_of(first, size)));
                at += size;
            }
        };
        for (const Mat matrix : {matrices_.mass(), matrices_.solid()})
            in_blocks(it_.fields.count(),
                      [&](Index first, Index size) { return times(matrix, it_.fields.columns(first, size)); });
        for (const auto& columns : sparse_)
            in_blocks(columns.values.cols(),
                      [&](Index first, Index size) { return columns.block(it_.fields.rows(), first, size); });
        in_blocks(it_.observed.cols(), [&](Index first, Index size) { return it_.observed.middleCols(first, size); });
    }

    /// Products of all vectors with columns; of the dense ones only if asked for, else zero.
    [[nodiscard]] MatrixXd products(const MatrixXd& columns, bool with_dense) const
    {
        MatrixXd result = MatrixXd::Zero(count(), columns.cols());
        const Index n = it_.fields.count();
        if (with_dense) {
            result.topRows(n) = it_.fields.inner_products(times(matrices_.mass(), columns));
            result.middleRows(n, n) = it_.fields.inner_products(times(matrices_.solid(), columns));
        }
        Index at = dense_count();
        for (const auto& one : sparse_) {
            result.middleRows(at, one.values.cols()) = one.times(columns);
            at += one.values.cols();
        }
        result.bottomRows(it_.observed.cols()) = it_.observed.transpose() * columns;
        return result;
    }

private:
    const ProjectedMachine& it_;
    HeatMatrices& matrices_;
    std::vector<SparseColumns> sparse_;
};

// K'^-1 block. One step of refinement: a machine that is nearly insulated magnifies rounding by the heat that it
// stores.
MatrixXd refined(BlockSolver& solver, Mat matrix, const MatrixXd& block)
{
    MatrixXd solution = solver.solve(block);
    solution += solver.solve(block - times(matrix, solution));
    return solution;
}

// The products of all vectors, those of the fields instead of the basis.
MatrixXd products_of_fields(const Vectors& vectors, HeatMatrices& matrices)
{
    BlockSolver solver(matrices.stiffness());
    solver.set(matrices.stiffness(), 0, matrices.mass());
    MatrixXd gram(vectors.count(), vectors.count());
    vectors.for_each_block([&](Index first, const MatrixXd& block) {
        const MatrixXd solved = refined(solver, matrices.stiffness(), block);
        gram.middleCols(first, block.cols()) = vectors.products(solved, first < vectors.dense_count());
    });
    const Index dense = vectors.dense_count(), others = vectors.count() - dense;
    gram.topRightCorner(dense, others) = gram.bottomLeftCorner(others, dense).transpose();
    return gram;
}

void correct(MatrixXd& gram, const MatrixXd& correction)
{
    const Index n = correction.rows();
    for (const Index first : {Index(0), n}) {
        gram.middleRows(first, n) = (correction.transpose() * gram.middleRows(first, n)).eval();
        gram.middleCols(first, n) = (gram.middleCols(first, n) * correction).eval();
    }
}

}  // namespace

reduce::ResidualTerms residual_terms(const ProjectedMachine& machine, const reduce::ResidualCut& cut)
{
    const auto& correction = machine.correction;
    Vectors vectors(machine);
    reduce::ResidualTerms result;
    result.states = correction.cols();
    result.terms = vectors.add_terms(cut);
    vectors.add_functionals();
    result.functionals = static_cast<Index>(machine.system.geometry().layout.count());
    result.observed = machine.observed.cols();
    auto gram = products_of_fields(vectors, machine.system.matrices());
    correct(gram, correction);
    // the first field is uniform: K_0 of it is rounding
    gram.col(result.states).setZero();
    gram.row(result.states).setZero();
    result.root = reduce::residual_root(gram);
    reduce::set_products(result);
    return result;
}

}  // namespace deadpoint::fem
