#include "deadpoint/fem/algebra/couplings.hpp"

#include <algorithm>
#include <cstdint>

namespace deadpoint::fem {

void Couplings::add(std::span<const PetscInt> rows, std::span<const PetscInt> columns)
{
    const std::size_t known = rows_.size();
    for (const PetscInt row : rows)
        if (owns(row))
            rows_.push_back(row - first_);
    if (rows_.size() == known)
        return;
    columns_.insert(columns_.end(), columns.begin(), columns.end());
    row_starts_.push_back(rows_.size());
    column_starts_.push_back(columns_.size());
}

SparseRows Couplings::rows() const
{
    const auto count = static_cast<std::size_t>(last_ - first_);
    std::vector<std::size_t> starts(count + 1, 0);  // of the groups of each row
    for (const PetscInt row : rows_)
        ++starts[static_cast<std::size_t>(row) + 1];
    for (std::size_t row = 0; row < count; ++row)
        starts[row + 1] += starts[row];
    std::vector<std::uint32_t> groups(rows_.size());
    auto next = starts;
    for (std::size_t group = 0; group + 1 < row_starts_.size(); ++group)
        for (std::size_t k = row_starts_[group]; k < row_starts_[group + 1]; ++k)
            groups[next[static_cast<std::size_t>(rows_[k])]++] = static_cast<std::uint32_t>(group);
    next = std::vector<std::size_t>();  // frees it, which {} does not

    SparseRows result;
    result.starts.reserve(count + 1);
    result.starts.push_back(0);
    std::vector<PetscInt> row_columns;
    for (std::size_t row = 0; row < count; ++row) {
        row_columns.clear();
        for (std::size_t k = starts[row]; k < starts[row + 1]; ++k)
            row_columns.insert(row_columns.end(),
                               columns_.begin() + static_cast<std::ptrdiff_t>(column_starts_[groups[k]]),
                               columns_.begin() + static_cast<std::ptrdiff_t>(column_starts_[groups[k] + 1]));
        std::ranges::sort(row_columns);
        const auto repeated = std::ranges::unique(row_columns);
        result.columns.insert(result.columns.end(), row_columns.begin(), repeated.begin());
        result.starts.push_back(static_cast<PetscInt>(result.columns.size()));
    }
    return result;
}

SparseRows by_blocks(const SparseRows& rows, PetscInt block)
{
    SparseRows result;
    const std::size_t count = rows.starts.size() - 1;
    result.starts.reserve(count * static_cast<std::size_t>(block) + 1);
    result.columns.reserve(rows.columns.size() * static_cast<std::size_t>(block * block));
    result.starts.push_back(0);
    for (std::size_t row = 0; row < count; ++row)
        for (PetscInt of_row = 0; of_row < block; ++of_row) {
            for (PetscInt k = rows.starts[row]; k < rows.starts[row + 1]; ++k)
                for (PetscInt c = 0; c < block; ++c)
                    result.columns.push_back(block * rows.columns[static_cast<std::size_t>(k)] + c);
            result.starts.push_back(static_cast<PetscInt>(result.columns.size()));
        }
    return result;
}

}  // namespace deadpoint::fem
