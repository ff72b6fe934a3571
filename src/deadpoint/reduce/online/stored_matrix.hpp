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
};
template <class Number>
constexpr auto members(const StoredMatrix<Number>*)
{
    return std::tuple{&StoredMatrix<Number>::rows, &StoredMatrix<Number>::columns, &StoredMatrix<Number>::entries};
}

/// Rounded to 32 bits.
StoredMatrix<float> as_stored(const Eigen::MatrixXd& matrix);
/// @throws InputError if the number of entries is another one than it says
Eigen::MatrixXd as_matrix(const StoredMatrix<float>& stored);

}  // namespace deadpoint::reduce
