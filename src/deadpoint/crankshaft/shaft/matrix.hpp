#pragma once

#include <cstddef>
#include <vector>

namespace deadpoint::crankshaft {

/// A dense real matrix, row by row.
struct Matrix {
    int rows = 0;
    int cols = 0;
    std::vector<double> values;  ///< rows * cols, row-major

    Matrix() = default;
    Matrix(int row_count, int col_count)
        : rows(row_count), cols(col_count),
          values(static_cast<std::size_t>(row_count) * static_cast<std::size_t>(col_count), 0.0)
    {}
    [[nodiscard]] double operator()(int row, int col) const { return values[index(row, col)]; }
    [[nodiscard]] double& operator()(int row, int col) { return values[index(row, col)]; }

private:
    [[nodiscard]] std::size_t index(int row, int col) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols) + static_cast<std::size_t>(col);
    }
};

}  // namespace deadpoint::crankshaft
