#include "deadpoint/fem/algebra/symmetric_triplets.hpp"

#include <algorithm>

namespace deadpoint::fem {
namespace {

constexpr std::size_t width = 8;  ///< columns that one pass over the entries multiplies

// Calls visit(row, count, columns, values) for the rows of this rank, both halves of each.
template <class Visit>
void for_each_row(Mat matrix, const Visit& visit)
{
    PetscInt first = 0, last = 0;
    DEADPOINT_PETSC(MatGetOwnershipRange(matrix, &first, &last));
    for (PetscInt row = first; row < last; ++row) {
        PetscInt count = 0;
        const PetscInt* columns = nullptr;
        const PetscScalar* values = nullptr;
        DEADPOINT_PETSC(MatGetRow(matrix, row, &count, &columns, &values));
        visit(row, count, columns, values);
        DEADPOINT_PETSC(MatRestoreRow(matrix, row, &count, &columns, &values));
    }
}

}  // namespace

SymmetricTriplets::SymmetricTriplets(Mat matrix)
{
    int count = 1;
    MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
    MPI_Comm_size(PETSC_COMM_WORLD, &count);
    const PetscInt* first_rows = nullptr;
    DEADPOINT_PETSC(MatGetOwnershipRanges(matrix, &first_rows));
    starts.assign(first_rows, first_rows + count + 1);
    for (int r = 0; r < count; ++r)
        sizes.push_back(first_rows[r + 1] - first_rows[r]);

    std::size_t entries = 0;
    for_each_row(matrix, [&](PetscInt i, PetscInt n, const PetscInt* columns, const PetscScalar*) {
        entries += static_cast<std::size_t>(std::count_if(columns, columns + n, [i](PetscInt j) { return j >= i; }));
    });
    row.reserve(entries);
    column.reserve(entries);
    value.reserve(entries);
    for_each_row(matrix, [&](PetscInt i, PetscInt n, const PetscInt* columns, const PetscScalar* values) {
        for (PetscInt k = 0; k < n; ++k)
            if (columns[k] >= i) {
                row.push_back(i + 1);
                column.push_back(columns[k] + 1);
                value.push_back(values[k]);
            }
    });
}

// Rows of `width` columns lie together in x_all and y_all, so that an entry meets all of them at once.
void SymmetricTriplets::multiply(PetscInt columns, const double* x, double* y) const
{
    const auto all = static_cast<std::size_t>(size()), rows = owned(), count = static_cast<std::size_t>(columns);
    const auto share = [&](const std::vector<int>& rows_of_ranks) {
        auto result = rows_of_ranks;
        for (int& number : result)
            number *= static_cast<int>(width);
        return result;
    };
    const auto counts = share(sizes), places = share(starts);
    std::vector<double> own(width * rows, 0.0), x_all(width * all), y_all(width * all);
    for (std::size_t first = 0; first < count; first += width) {
        const auto some = std::min(width, count - first);
        for (std::size_t k = 0; k < some; ++k)
            for (std::size_t i = 0; i < rows; ++i)
                own[width * i + k] = x[(first + k) * rows + i];
        MPI_Allgatherv(own.data(), static_cast<int>(own.size()), MPI_DOUBLE, x_all.data(), counts.data(), places.data(),
                       MPI_DOUBLE, PETSC_COMM_WORLD);
        std::ranges::fill(y_all, 0.0);
        for (std::size_t e = 0; e < value.size(); ++e) {
            const auto i = width * static_cast<std::size_t>(row[e] - 1),
                       j = width * static_cast<std::size_t>(column[e] - 1);
            const double above = value[e], below = i == j ? 0 : above;
            for (std::size_t k = 0; k < width; ++k) {
                y_all[i + k] += above * x_all[j + k];
                y_all[j + k] += below * x_all[i + k];
            }
        }
        MPI_Reduce_scatter(y_all.data(), own.data(), counts.data(), MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
        for (std::size_t k = 0; k < some; ++k)
            for (std::size_t i = 0; i < rows; ++i)
                y[(first + k) * rows + i] = own[width * i + k];
    }
}

void SymmetricTriplets::multiply(Mat x, Mat y) const
{
    with_columns(x, y, [&](PetscInt columns, const double* from, double* to) { multiply(columns, from, to); });
}

void SymmetricTriplets::multiply(Vec x, Vec y) const
{
    with_columns(x, y, [&](PetscInt columns, const double* from, double* to) { multiply(columns, from, to); });
}

}  // namespace deadpoint::fem
