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
    std::vector<StoredMatrix<float>> factors;  ///< of each term
    std::vector<std::uint64_t> kept;           ///< columns of each factor that have a vector
    std::vector<double> lowest;                ///< coefficient of each term in K' [W/m2/K]
    std::vector<float> root;                   ///< upper triangle, column after column
    StoredMatrix<float> products;              ///< of the first vectors of each term
};
constexpr auto members(const StoredResidual*)
{
    return std::tuple{&StoredResidual::states,  &StoredResidual::functionals, &StoredResidual::observed,
                      &StoredResidual::factors, &StoredResidual::kept,        &StoredResidual::lowest,
                      &StoredResidual::root,    &StoredResidual::products};
}

StoredResidual stored(const ResidualTerms& terms);
/// The terms again, as they were rounded.
/// @throws InputError if numbers of entries do not fit each other
ResidualTerms restored(const StoredResidual& stored);

}  // namespace deadpoint::reduce
