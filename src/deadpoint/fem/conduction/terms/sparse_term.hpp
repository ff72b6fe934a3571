#pragma once

#include "deadpoint/fem/space/discretisation.hpp"

#include <vector>

/// Internal to fem/: a term of the heat matrices that is scaled by a coefficient.
namespace deadpoint::fem {

/// Entries of a matrix as this rank adds them, also to rows of other ranks. Integrated once, added with any
/// coefficient.
class SparseTerm {
public:
    /// Adds factor * rows x columns.
    void add(const PointShape& rows, const PointShape& columns, double factor);
    void add(PetscInt row, PetscInt column, double value);
    /// Brings the entries in order, one for each place; to be called before add_to().
    void finish();
    /// matrix += coefficient times the term, to be assembled by the caller. Collective with the other ranks' terms.
    void add_to(Mat matrix, double coefficient) const;
    [[nodiscard]] std::size_t entries() const { return values_.size(); }
    /// Calls visit(row, column, value) for each entry of this rank, after finish().
    template <class Visit>
    void for_each(const Visit& visit) const
    {
        for (std::size_t r = 0; r < rows_.size(); ++r)
            for (std::size_t k = starts_[r]; k < starts_[r + 1]; ++k)
                visit(rows_[r], columns_[k], values_[k]);
    }

private:
    struct Entry {
        PetscInt row = 0, column = 0;
        double value = 0;
    };
    void merge();

    std::vector<Entry> loose_;  ///< not in order yet behind the first merged_
    std::size_t merged_ = 0;
    std::vector<PetscInt> rows_;  ///< that have entries
    std::vector<std::size_t> starts_;
    std::vector<PetscInt> columns_;
    std::vector<double> values_;
};

/// Adds factor * rows x columns to a matrix.
void insert_block(Mat matrix, const PointShape& rows, const PointShape& columns, double factor);

}  // namespace deadpoint::fem
