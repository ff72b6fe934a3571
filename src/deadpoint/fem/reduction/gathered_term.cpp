#include "deadpoint/fem/reduction/gathered_term.hpp"

#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/fem/reduction/basis_fields.hpp"
#include "deadpoint/fem/reduction/columns.hpp"

#include <algorithm>

namespace deadpoint::fem {
namespace {

// Where each rank's values begin in a list of all, and the end. Collective.
std::vector<int> starts_of(std::size_t own)
{
    const int count = static_cast<int>(own);
    std::vector<int> counts(static_cast<std::size_t>(ranks())), starts{0};
    MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, PETSC_COMM_WORLD);
    for (const int one : counts)
        starts.push_back(starts.back() + one);
    return starts;
}

// The values of all ranks, on all of them. Collective.
template <class Value>
std::vector<Value> gathered(const std::vector<Value>& own, MPI_Datatype type)
{
    const auto starts = starts_of(own.size());
    std::vector<int> counts;
    for (std::size_t r = 0; r + 1 < starts.size(); ++r)
        counts.push_back(starts[r + 1] - starts[r]);
    std::vector<Value> all(static_cast<std::size_t>(starts.back()));
    MPI_Allgatherv(own.data(), static_cast<int>(own.size()), type, all.data(), counts.data(), starts.data(), type,
                   PETSC_COMM_WORLD);
    return all;
}

void sort(std::vector<PetscInt>& unknowns)
{
    std::ranges::sort(unknowns);
    unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
}

// The unknowns of a sum of terms, of all ranks.
std::vector<PetscInt> unknowns_of(const TermSum& sum)
{
    std::vector<PetscInt> own;
    for (const auto& [factor, term] : sum)
        term->for_each([&](PetscInt row, PetscInt column, double) {
            own.push_back(row);
            own.push_back(column);
        });
    sort(own);
    auto all = gathered(own, MPIU_INT);
    sort(all);
    return all;
}

// The fields on unknowns of all ranks, on one of them.
Eigen::MatrixXd rows_on(int owner, const Discretisation& space, const std::vector<PetscInt>& unknowns,
                        const BasisFields& fields)
{
    const auto first = std::ranges::lower_bound(unknowns, space.first);
    const auto last = std::ranges::lower_bound(unknowns, space.last);
    std::vector<PetscInt> local(first, last);
    for (auto& unknown : local)
        unknown -= space.first;
    if (ranks() == 1)
        return fields.at(local);
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(unknowns.size()), fields.count());
    rows.middleRows(first - unknowns.begin(), last - first) = fields.at(local);
    const bool is_owner = rank() == owner;
    MPI_Reduce(is_owner ? MPI_IN_PLACE : rows.data(), rows.data(), static_cast<int>(rows.size()), MPI_DOUBLE, MPI_SUM,
               owner, PETSC_COMM_WORLD);
    return is_owner ? rows : Eigen::MatrixXd();
}

// A sum of terms, of all ranks, numbered as the unknowns are.
Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_of(const TermSum& sum, const std::vector<PetscInt>& unknowns)
{
    const auto place = [&](PetscInt unknown) {
        return static_cast<int>(std::ranges::lower_bound(unknowns, unknown) - unknowns.begin());
    };
    std::vector<int> rows, columns;
    std::vector<double> values;
    for (const auto& [factor, term] : sum)
        term->for_each([&, factor = factor](PetscInt row, PetscInt column, double value) {
            rows.push_back(place(row));
            columns.push_back(place(column));
            values.push_back(factor * value);
        });
    const auto all_rows = gathered(rows, MPI_INT), all_columns = gathered(columns, MPI_INT);
    const auto all_values = gathered(values, MPI_DOUBLE);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(all_values.size());
    for (std::size_t k = 0; k < all_values.size(); ++k)
        entries.emplace_back(all_rows[k], all_columns[k], all_values[k]);
    const auto size = static_cast<Eigen::Index>(unknowns.size());
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace

GatheredTerm::GatheredTerm(const Discretisation& space, const TermSum& sum, const BasisFields& fields, int owner)
    : unknowns_(unknowns_of(sum)), rows_(rows_on(owner, space, unknowns_, fields)), matrix_(matrix_of(sum, unknowns_))
{}

Eigen::MatrixXd GatheredTerm::product(const Eigen::MatrixXd& columns) const
{
    return product_of_transposed(rows_, image(columns));
}

Eigen::MatrixXd GatheredTerm::image(const Eigen::MatrixXd& columns) const { return matrix_ * combined(rows_, columns); }

}  // namespace deadpoint::fem
