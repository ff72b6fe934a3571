#pragma once

#include "deadpoint/crankshaft/shaft/matrix.hpp"

#include <Eigen/Dense>

/// Views of Matrix for Eigen; only for the sources of this folder.
namespace deadpoint::crankshaft {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

inline Eigen::Map<const RowMajor> view(const Matrix& m) { return {m.values.data(), m.rows, m.cols}; }
inline Eigen::Map<RowMajor> view(Matrix& m) { return {m.values.data(), m.rows, m.cols}; }

}  // namespace deadpoint::crankshaft
