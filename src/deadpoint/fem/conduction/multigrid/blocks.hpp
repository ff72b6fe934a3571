#pragma once

#include <cstddef>
#include <experimental/simd>
#include <vector>

/// Internal to fem/: vectors that are multiplied at once.
namespace deadpoint::fem {

/// Vectors of a block; also the rows of a slice of a FloatMatrix.
inline constexpr std::size_t lanes = 8;

/// The entries of one row in all vectors of a block.
using FloatBlock = std::experimental::fixed_size_simd<float, lanes>;
using DoubleBlock = std::experimental::fixed_size_simd<double, lanes>;

}  // namespace deadpoint::fem
