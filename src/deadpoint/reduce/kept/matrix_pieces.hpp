#pragma once

#include <Eigen/Dense>
#include <string>
#include <vector>

namespace deadpoint::reduce {

class BuildCheckpoint;
struct DenseTerms;

/// Reads matrices that write_matrices() kept as a piece. @return none if it is not there
/// @throws as BuildCheckpoint::read()
std::vector<Eigen::MatrixXd> read_matrices(const BuildCheckpoint& kept, const std::string& piece);
/// Keeps matrices in double precision as a piece.
void write_matrices(const BuildCheckpoint& kept, const std::string& piece,
                    const std::vector<Eigen::MatrixXd>& matrices);

/// The matrices of terms in a fixed order, and the terms again. The geometry, which they have, is not among them.
std::vector<Eigen::MatrixXd> matrices_of(const DenseTerms& terms);
/// @throws IoError if there are more or fewer
void take_matrices(const std::vector<Eigen::MatrixXd>& matrices, DenseTerms& terms);

}  // namespace deadpoint::reduce
