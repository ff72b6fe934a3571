#include "deadpoint/fem/conduction/multigrid/float_matrix.hpp"

#include "deadpoint/fem/conduction/multigrid/local_rows.hpp"

#include <numeric>
#include <span>

namespace deadpoint::fem {
namespace {

/// Calls visit(row, k, local column, value) for the k-th entry of each row.
template <class Visit>
void for_each_entry(Mat matrix, const Visit& visit)
{
    const LocalRows local(matrix);
    const CompressedRows own(local.own);
    PetscInt before = 0;
    DEADPOINT_PETSC(MatGetLocalSize(matrix, nullptr, &before));
    const auto visit_row = [&](const CompressedRows& rows, std::size_t row, std::size_t k, PetscInt shift) {
        for (PetscInt entry = rows.starts[row]; entry < rows.starts[row + 1]; ++entry)
            visit(row, k++, shift + rows.columns[entry], rows.values[entry]);
        return k;
    };
    if (!local.other) {
        for (std::size_t row = 0; row < own.count; ++row)
            visit_row(own, row, 0, 0);
        return;
    }
    const CompressedRows other(local.other);
    for (std::size_t row = 0; row < own.count; ++row)
        visit_row(other, row, visit_row(own, row, 0, 0), before);
}

}  // namespace

FloatMatrix::FloatMatrix(Mat matrix) : ghosts_(matrix, LocalRows(matrix).ghosts)
{
    PetscInt rows = 0;
    DEADPOINT_PETSC(MatGetLocalSize(matrix, &rows, nullptr));
    lengths_.assign(static_cast<std::size_t>(rows), 0);
    for_each_entry(matrix, [&](std::size_t row, std::size_t, PetscInt, double) { ++lengths_[row]; });
    starts_.push_back(0);
    for (std::size_t first = 0; first < lengths_.size(); first += slice) {
        const std::span of_slice(lengths_.data() + first, std::min(slice, lengths_.size() - first));
        starts_.push_back(starts_.back() + slice * *std::ranges::max_element(of_slice));
    }
    places_.assign(starts_.back(), 0);
    values_.assign(starts_.back(), 0);
    for_each_entry(matrix, [&](std::size_t row, std::size_t k, PetscInt column, double value) {
        places_[position(row, k)] = column;
        values_[position(row, k)] = static_cast<float>(value);
    });
}

void FloatMatrix::take_values(Mat matrix)
{
    for_each_entry(matrix, [&](std::size_t row, std::size_t k, PetscInt, double value) {
        values_[position(row, k)] = static_cast<float>(value);
    });
}

std::size_t FloatMatrix::entries() const { return std::accumulate(lengths_.begin(), lengths_.end(), std::size_t{0}); }

std::vector<float> FloatMatrix::inverse_diagonal() const
{
    std::vector<float> result(rows(), 1);
    for (std::size_t row = 0; row < rows(); ++row)
        for (std::size_t k = 0; k < lengths_[row]; ++k)
            if (static_cast<std::size_t>(places_[position(row, k)]) == row)
                result[row] = 1 / values_[position(row, k)];
    return result;
}

}  // namespace deadpoint::fem
