#include "deadpoint/fem/reduction/surface_terms.hpp"

#include "deadpoint/fem/conduction/terms/heat_matrices.hpp"
#include "deadpoint/fem/reduction/columns.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/reduce/offline/build_options.hpp"
#include "deadpoint/reduce/offline/low_rank.hpp"

#include <Eigen/Sparse>
#include <algorithm>
#include <utility>
#include <vector>

namespace deadpoint::fem {
namespace {

using Scaled = std::vector<std::pair<double, const SparseTerm*>>;

// Rows of the basis on all unknowns of a term, on every rank.
class TermRows {
public:
    TermRows(const Discretisation& space, const Scaled& sum, const Eigen::MatrixXd& basis)
    {
        for (const auto& [factor, term] : sum)
            term->for_each([&](PetscInt row, PetscInt column, double) {
                unknowns_.push_back(row);
                unknowns_.push_back(column);
            });
        gather_unknowns();
        rows_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(unknowns_.size()), basis.cols());
        for (std::size_t i = 0; i < unknowns_.size(); ++i)
            if (space.owns(unknowns_[i]))
                rows_.row(static_cast<Eigen::Index>(i)) = basis.row(unknowns_[i] - space.first);
        sum_over_ranks(rows_);
        add_entries(sum);
    }

    // basis^T A basis columns
    [[nodiscard]] Eigen::MatrixXd product(const Eigen::MatrixXd& columns) const
    {
        const Eigen::MatrixXd on_unknowns = matrix_ * combined(rows_, columns);
        return inner_products(rows_, on_unknowns);
    }

private:
    void sort()
    {
        std::ranges::sort(unknowns_);
        unknowns_.erase(std::unique(unknowns_.begin(), unknowns_.end()), unknowns_.end());
    }

    void gather_unknowns()
    {
        sort();
        int ranks = 1;
        MPI_Comm_size(PETSC_COMM_WORLD, &ranks);
        const int own = static_cast<int>(unknowns_.size());
        std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(counts.size() + 1, 0);
        MPI_Allgather(&own, 1, MPI_INT, counts.data(), 1, MPI_INT, PETSC_COMM_WORLD);
        for (std::size_t r = 0; r < counts.size(); ++r)
            starts[r + 1] = starts[r] + counts[r];
        std::vector<PetscInt> all(static_cast<std::size_t>(starts.back()));
        MPI_Allgatherv(unknowns_.data(), own, MPIU_INT, all.data(), counts.data(), starts.data(), MPIU_INT,
                       PETSC_COMM_WORLD);
        unknowns_ = std::move(all);
        sort();
    }

    void add_entries(const Scaled& sum)
    {
        const auto place = [&](PetscInt unknown) {
            return static_cast<int>(std::ranges::lower_bound(unknowns_, unknown) - unknowns_.begin());
        };
        std::vector<Eigen::Triplet<double>> entries;
        for (const auto& [factor, term] : sum)
            term->for_each([&, factor = factor](PetscInt row, PetscInt column, double value) {
                entries.emplace_back(place(row), place(column), factor * value);
            });
        matrix_.resize(rows_.rows(), rows_.rows());
        matrix_.setFromTriplets(entries.begin(), entries.end());
    }

    std::vector<PetscInt> unknowns_;
    Eigen::MatrixXd rows_;
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_;  ///< this rank's share
};

bool has_entries(const SparseTerm& term)
{
    std::vector<double> entries{static_cast<double>(term.entries())};
    sum_over_ranks(entries);
    return entries[0] > 0;
}

/// Cuts terms to factors of low rank.
class Projection {
public:
    Projection(const Discretisation& space, const Eigen::MatrixXd& basis, const reduce::Truncation& truncation,
               const reduce::DenseTerms& terms)
        : space_(space), basis_(basis), truncation_(truncation), terms_(terms)
    {}

    // Of a term whose product with the uniform field is a functional.
    [[nodiscard]] Eigen::MatrixXd of_side(const SparseTerm& term, std::size_t functional, double factor) const
    {
        const TermRows rows(space_, {{1, &term}}, basis_);
        const Eigen::VectorXd load = factor * terms_.functionals.row(static_cast<Eigen::Index>(functional)).transpose();
        return reduce::low_rank_factor([&](const Eigen::MatrixXd& columns) { return rows.product(columns); }, load,
                                       terms_.uniform, truncation_.others);
    }
    // Of J = S_aa + S_bb - S_ab - S_ab^T.
    [[nodiscard]] Eigen::MatrixXd between(const JointTerm& joint, const SparseTerm& across) const
    {
        if (!has_entries(across))
            return {};
        const TermRows rows(space_, {{1, &joint.aa}, {1, &joint.bb}, {-1, &across}}, basis_);
        return reduce::low_rank_factor([&](const Eigen::MatrixXd& columns) { return rows.product(columns); },
                                       basis_.cols(), truncation_.joints);
    }

private:
    const Discretisation& space_;
    const Eigen::MatrixXd& basis_;
    const reduce::Truncation& truncation_;
    const reduce::DenseTerms& terms_;
};

}  // namespace

void project_surfaces(const Discretisation& space, const HeatMatrices& matrices, const Eigen::MatrixXd& basis,
                      const reduce::Truncation& truncation, reduce::DenseTerms& terms)
{
    const Projection projection(space, basis, truncation, terms);
    const auto& geometry = terms.geometry;
    for (std::size_t i = 0; i < geometry.layout.interfaces; ++i) {
        const auto& joint = matrices.joint_terms()[i];
        const double area = geometry.interface_area[i];
        auto& reduced = terms.joints.emplace_back();
        reduced.aa.factor = projection.of_side(joint.aa, geometry.layout.mean(i, false), area);
        reduced.bb.factor = projection.of_side(joint.bb, geometry.layout.mean(i, true), area);
        reduced.between.factor = projection.between(joint, joint.across);
        reduced.turning.factor = projection.between(joint, joint.turning);
    }
    for (std::size_t s = 0; s < geometry.layout.surfaces; ++s) {
        auto& film = terms.films.emplace_back();
        if (has_entries(matrices.film_terms()[s]))
            film.factor = projection.of_side(matrices.film_terms()[s], geometry.layout.surface(s), 1);
    }
}

}  // namespace deadpoint::fem
