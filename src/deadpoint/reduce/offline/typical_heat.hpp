#pragma once

#include "deadpoint/reduce/online/dense_terms.hpp"

#include <Eigen/Dense>
#include <vector>

namespace deadpoint::reduce {

struct Training;

/// How much heat each direction of a term takes, in the states that occur.
struct TypicalHeat {
    Eigen::MatrixXd moments;  ///< second moments of typical states: those of runs give off the heat 1, as do the duals
    std::vector<double> highest;  ///< largest coefficient of each term in the box, in the order of PreparedTerms::each
};

/// Heat of the states of training runs and of their dual problems, without their uniform part.
/// @param highest  as of TypicalHeat, with 1 for K of the solids at the end
TypicalHeat typical_heat(const DenseTerms& terms, const Training& training, std::vector<double> highest);

/// Leaves out of each term the directions that take at most `least` of the heat. The column of the mean stays, so a
/// term conducts at a uniform temperature what it did; what is left out is positive semidefinite, so no term gives off
/// heat of its own.
void cut_terms(DenseTerms& terms, const TypicalHeat& typical, double least);

}  // namespace deadpoint::reduce
