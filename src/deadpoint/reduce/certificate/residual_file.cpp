#include "deadpoint/reduce/certificate/residual_file.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"

#include <algorithm>

namespace deadpoint::reduce {
namespace {

void require_fit(const StoredResidual& stored, const ResidualSizes& sizes)
{
    const bool fits = stored.states == sizes.states && stored.functionals == sizes.functionals &&
                      stored.observed == sizes.observed && stored.lowest.size() == sizes.terms &&
                      stored.highest.size() == sizes.terms && stored.first.size() == sizes.terms + 1 &&
                      stored.first.front() == 0 && std::ranges::is_sorted(stored.first) &&
                      stored.factors.has_size(stored.states, stored.first.back()) &&
                      (stored.remainder.rows == 0 ? stored.remainder.is_whole()
                                                  : stored.remainder.has_size(stored.remainder.rows, stored.states));
    if (!fits)
        throw InputError("its numbers do not fit the large model");
    const auto positive = [](double coefficient) { return coefficient >= 0; };
    if (!std::ranges::all_of(stored.lowest, positive) || !std::ranges::all_of(stored.highest, positive))
        throw InputError("a coefficient of a certificate is negative");
}

// The file has columns, and a row of the matrix is contiguous: a few columns at a time.
RowMatrix upper_triangle(const std::vector<float>& entries, Eigen::Index size)
{
    constexpr Eigen::Index at_a_time = 16;
    if (static_cast<Eigen::Index>(entries.size()) != size * (size + 1) / 2)
        throw InputError("a certificate has another number of products than vectors");
    RowMatrix result = RowMatrix::Zero(size, size);
    for (Eigen::Index first = 0; first < size; first += at_a_time) {
        const Eigen::Index end = std::min(first + at_a_time, size);
        for (Eigen::Index i = 0; i < end; ++i)
            for (Eigen::Index j = std::max(i, first); j < end; ++j)
                result(i, j) = entries[static_cast<std::size_t>(j * (j + 1) / 2 + i)];
    }
    return result;
}

}  // namespace

StoredResidual stored(const ResidualTerms& terms)
{
    StoredResidual result;
    result.states = static_cast<std::uint64_t>(terms.states);
    result.functionals = static_cast<std::uint64_t>(terms.functionals);
    result.observed = static_cast<std::uint64_t>(terms.observed);
    result.first.assign(terms.first.begin(), terms.first.end());
    result.factors = as_stored(terms.factors);
    result.lowest = terms.lowest;
    result.highest = terms.highest;
    result.remainder = as_stored(terms.remainder);
    for (Eigen::Index j = 0; j < terms.root.cols(); ++j)
        for (Eigen::Index i = 0; i <= j; ++i)
            result.root.push_back(static_cast<float>(terms.root(i, j)));
    result.products = as_stored(terms.products);
    return result;
}

ResidualTerms restored(const StoredResidual& stored, const ResidualSizes& sizes)
{
    require_fit(stored, sizes);
    ResidualTerms result;
    result.states = static_cast<Eigen::Index>(stored.states);
    result.functionals = static_cast<Eigen::Index>(stored.functionals);
    result.observed = static_cast<Eigen::Index>(stored.observed);
    result.first.assign(stored.first.begin(), stored.first.end());
    result.factors = as_matrix(stored.factors);
    result.lowest = stored.lowest;
    result.highest = stored.highest;
    result.remainder = as_matrix(stored.remainder);
    if (result.remainder.rows() == 0)
        result.remainder.resize(0, result.states);
    result.root = upper_triangle(stored.root, result.count());
    result.products = as_matrix(stored.products);
    set_directions(result);
    Eigen::Index corrections = 0;
    for (std::size_t q = 0; q < result.terms(); ++q)
        corrections += result.corrections(q);
    if (result.products.rows() != corrections || result.products.cols() != corrections)
        throw InputError("a certificate has another number of products than vectors");
    return result;
}

}  // namespace deadpoint::reduce
