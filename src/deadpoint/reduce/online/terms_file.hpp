#pragma once

#include "deadpoint/reduce/online/stored_matrix.hpp"

#include <string>
#include <tuple>
#include <vector>

namespace deadpoint::reduce {

struct DenseTerms;

/// Reduced terms as a file has them. The solid has 64 bits a number, since its slow modes are small beside its fast
/// ones; everything else has 32 bits, which changes temperatures by less than 1e-4 K.
struct StoredTerms {
    std::vector<double> solid;                         ///< diagonal, or lower triangle column after column [1/s]
    std::vector<StoredMatrix<float>> joints;           ///< aa, bb, between, turning of each interface, factors
    std::vector<StoredMatrix<float>> films;            ///< factors
    StoredMatrix<float> functionals, observed, parts;  ///< transposed: a column for each row; parts as they are
};
constexpr auto members(const StoredTerms*)
{
    return std::tuple{&StoredTerms::solid,       &StoredTerms::joints,   &StoredTerms::films,
                      &StoredTerms::functionals, &StoredTerms::observed, &StoredTerms::parts};
}

/// The numbers of terms, for a file. Their geometry is stored beside them.
StoredTerms stored(const DenseTerms& terms);
/// The terms again, as they were rounded. @param terms  with their geometry, which is kept
/// @throws InputError if sizes do not fit each other and the geometry, before memory is taken by them
void restore(const StoredTerms& stored, DenseTerms& terms);

/// A number of 16 hexadecimal digits that tells the states of terms from those of any others: a hash of their
/// functionals as a file has them. It is the same before writing and after reading.
std::string mark_of(const DenseTerms& terms);

}  // namespace deadpoint::reduce
