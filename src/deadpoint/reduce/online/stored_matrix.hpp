#pragma once

#include <Eigen/Dense>
#include <cstdint>
#include <tuple>
#include <vector>

/// Internal to reduce/, since it shows Eigen: matrices as files have them.
namespace deadpoint::reduce {

/// A matrix as a file has it: its entries column after column.
template <class Number>
struct StoredMatrix {
    std::uint64_t rows = 0, columns = 0;
    std::vector<Number> entries;

    /// Whether it has as many entries as it says. Its rows and columns may be any numbers before.
    [[nodiscard]] bool is_whole() const
    {
        return rows > 0 && columns > 0 ? entries.size() % rows == 0 && entries.size() / rows == columns
                                       : entries.empty();
    }
    [[nodiscard]] bool has_size(std::uint64_t wanted_rows, std::uint64_t wanted_columns) const
    {
        return rows == wanted_rows && columns == wanted_columns && is_whole();
    }
};
template <class Number>
constexpr auto members(const StoredMatrix<Number>*)
{
    return std::tuple{&StoredMatrix<Number>::rows, &StoredMatrix<Number>::columns, &StoredMatrix<Number>::entries};
}

/// Rounded to 32 bits.
StoredMatrix<float> as_stored(const Eigen::MatrixXd& matrix);
/// A matrix without entries keeps its rows or columns, which take no memory but whose numbers the caller has checked.
/// @throws InputError if the number of entries is another one than it says
Eigen::MatrixXd as_matrix(const StoredMatrix<float>& stored);

}  // namespace deadpoint::reduce
