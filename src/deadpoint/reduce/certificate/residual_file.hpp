#pragma once

#include "deadpoint/reduce/online/stored_matrix.hpp"

#include <cstdint>
#include <tuple>
#include <vector>

namespace deadpoint::reduce {

struct ResidualTerms;

/// ResidualTerms as a file has them, with 32 bits a number.
struct StoredResidual {
    std::uint64_t states = 0, functionals = 0, observed = 0;
    std::vector<std::uint64_t> first;     ///< column of each term's first vector in the factors, and the end
    StoredMatrix<float> factors;          ///< of all terms
    std::vector<double> lowest, highest;  ///< coefficient of each term in K', and in the box at most [W/m2/K]
    StoredMatrix<float> remainder;
    std::vector<float> root;       ///< upper triangle, column after column
    StoredMatrix<float> products;  ///< of the first vectors of each term
};
constexpr auto members(const StoredResidual*)
{
    return std::tuple{&StoredResidual::states,  &StoredResidual::functionals, &StoredResidual::observed,
                      &StoredResidual::first,   &StoredResidual::factors,     &StoredResidual::lowest,
                      &StoredResidual::highest, &StoredResidual::remainder,   &StoredResidual::root,
                      &StoredResidual::products};
}

StoredResidual stored(const ResidualTerms& terms);
/// Sizes of the large model to which a certificate belongs.
struct ResidualSizes {
    std::uint64_t states = 0, functionals = 0, observed = 0, terms = 0;
};

/// The terms again, as they were rounded.
/// @throws InputError if numbers of entries fit neither each other nor the model, before memory is taken by them
ResidualTerms restored(const StoredResidual& stored, const ResidualSizes& sizes);

}  // namespace deadpoint::reduce
