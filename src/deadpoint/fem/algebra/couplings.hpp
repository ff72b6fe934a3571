#pragma once

#include <cstddef>
#include <petscsystypes.h>
#include <span>
#include <vector>

/// Internal to fem/: sparsity patterns.
namespace deadpoint::fem {

/// Compressed rows: the columns of row r, sorted, are columns[starts[r]] to columns[starts[r + 1]] without the end.
struct SparseRows {
    std::vector<PetscInt> starts;
    std::vector<PetscInt> columns;
};

/// Which unknowns a matrix couples, for the rows first <= row < last of one rank. Groups of unknowns are kept as they
/// come; the rows are made of them at the end, each once.
class Couplings {
public:
    Couplings(PetscInt first, PetscInt last) : first_(first), last_(last) {}

    /// Couples those of the rows that lie in the range with all columns.
    void add(std::span<const PetscInt> rows, std::span<const PetscInt> columns);
    /// Couples all with each other.
    void add(std::span<const PetscInt> unknowns) { add(unknowns, unknowns); }

    /// The pattern, by row counted from the first.
    [[nodiscard]] SparseRows rows() const;

private:
    [[nodiscard]] bool owns(PetscInt unknown) const { return unknown >= first_ && unknown < last_; }

    PetscInt first_, last_;
    std::vector<std::size_t> row_starts_{0}, column_starts_{0};  ///< per group
    std::vector<PetscInt> rows_, columns_;
};

/// The same with `block` rows and columns for each.
SparseRows by_blocks(const SparseRows& rows, PetscInt block);

}  // namespace deadpoint::fem
