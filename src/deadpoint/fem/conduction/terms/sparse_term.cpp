#include "deadpoint/fem/conduction/terms/sparse_term.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace deadpoint::fem {
namespace {

constexpr std::size_t most_loose = 1'000'000;  // entries between two merges; limits memory to that of the result

}  // namespace

void insert_block(Mat matrix, const PointShape& rows, const PointShape& columns, double factor)
{
    std::array<double, max_cell_dofs * max_cell_dofs> block{};
    for (int i = 0; i < rows.count; ++i)
        for (int j = 0; j < columns.count; ++j)
            block[static_cast<std::size_t>(i) * columns.count + j] = factor * rows.value[i] * columns.value[j];
    DEADPOINT_PETSC(
        MatSetValues(matrix, rows.count, rows.dof.data(), columns.count, columns.dof.data(), block.data(), ADD_VALUES));
}

void SparseTerm::add(const PointShape& rows, const PointShape& columns, double factor)
{
    for (int i = 0; i < rows.count; ++i)
        for (int j = 0; j < columns.count; ++j)
            add(rows.dof[i], columns.dof[j], factor * rows.value[i] * columns.value[j]);
}

void SparseTerm::add(PetscInt row, PetscInt column, double value)
{
    loose_.push_back({row, column, value});
    if (loose_.size() > merged_ + most_loose)
        merge();
}

// A stable sort gives equal sums in equal order on every run.
void SparseTerm::merge()
{
    const auto place = [](const Entry& e) { return std::tuple(e.row, e.column); };
    std::ranges::stable_sort(loose_, {}, place);
    std::size_t kept = 0;
    for (const auto& entry : loose_)
        if (kept > 0 && place(loose_[kept - 1]) == place(entry))
            loose_[kept - 1].value += entry.value;
        else
            loose_[kept++] = entry;
    loose_.resize(kept);
    merged_ = kept;
}

void SparseTerm::finish()
{
    merge();
    columns_.reserve(loose_.size());
    values_.reserve(loose_.size());
    for (const auto& entry : loose_) {
        if (rows_.empty() || rows_.back() != entry.row) {
            rows_.push_back(entry.row);
            starts_.push_back(columns_.size());
        }
        columns_.push_back(entry.column);
        values_.push_back(entry.value);
    }
    starts_.push_back(columns_.size());
    loose_ = std::vector<Entry>();  // frees it, which {} does not
}

void SparseTerm::add_to(Mat matrix, double coefficient) const
{
    if (coefficient == 0)
        return;
    std::vector<double> scaled;
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        scaled.assign(values_.begin() + static_cast<std::ptrdiff_t>(starts_[r]),
                      values_.begin() + static_cast<std::ptrdiff_t>(starts_[r + 1]));
        for (double& value : scaled)
            value *= coefficient;
        DEADPOINT_PETSC(MatSetValues(matrix, 1, &rows_[r], static_cast<PetscInt>(scaled.size()), &columns_[starts_[r]],
                                     scaled.data(), ADD_VALUES));
    }
}

}  // namespace deadpoint::fem
