#include "deadpoint/reduce/online/terms_file.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace deadpoint::reduce {
namespace {

using Matrix = Eigen::MatrixXd;

// A model has 1000 fields at most, or the 2000 states that a case may ask for, and those of the parts at their starts.
// A diagonal takes a square of its length in memory, so a file may not state any length.
constexpr std::uint64_t most_states = 2500;

// Off its diagonal a matrix that is diagonal but for rounding has at most this share of its largest entry.
constexpr double off_diagonal_rounding = 1e-14;

bool is_diagonal(const Matrix& matrix)
{
    const Matrix others = matrix - Matrix(matrix.diagonal().asDiagonal());
    return others.lpNorm<Eigen::Infinity>() <= off_diagonal_rounding * matrix.lpNorm<Eigen::Infinity>();
}

std::vector<double> entries_of(const Matrix& matrix)
{
    std::vector<double> entries;
    if (is_diagonal(matrix)) {
        entries.assign(matrix.diagonal().begin(), matrix.diagonal().end());
        return entries;
    }
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
        for (Eigen::Index i = j; i < matrix.rows(); ++i)
            entries.push_back(matrix(i, j));
    return entries;
}

bool is_missing(const StoredMatrix<float>& term) { return term.rows == 0 && term.columns == 0 && term.entries.empty(); }

// Counts of a geometry are those of the lists and matrices that were read, so that nothing that follows can overflow or
// take more memory than the file has room for.
void require_fit(const StoredTerms& stored, const heat::HeatGeometry& geometry)
{
    const auto& [layout, names, interface_area, surface_area] = geometry;
    const auto states = stored.parts.rows;
    const auto fits = [&](const StoredMatrix<float>& term) {
        return is_missing(term) || (term.rows == states && term.is_whole());
    };
    const auto columns = stored.functionals.columns;
    const bool geometry_fits = stored.joints.size() % 4 == 0 && stored.joints.size() / 4 == layout.interfaces &&
                               names.size() == layout.interfaces && interface_area.size() == layout.interfaces &&
                               stored.films.size() == layout.surfaces && surface_area.size() == layout.surfaces &&
                               layout.bodies <= columns && layout.probes <= columns &&
                               stored.parts.has_size(states, layout.parts) &&
                               stored.functionals.has_size(states, layout.count());
    if (!(states > 0) || !(layout.parts > 0) || !geometry_fits || !fits(stored.observed) ||
        !std::ranges::all_of(stored.joints, fits) || !std::ranges::all_of(stored.films, fits))
        throw InputError(
            "the numbers of its states, interfaces, surfaces, parts and functionals do not fit the sizes of "
            "its matrices");
    if (states > most_states)
        throw InputError(fmt::format("it has {} states, more than the {} of the largest model", states, most_states));
}

Matrix symmetric(const std::vector<double>& entries, Eigen::Index size)
{
    const auto count = static_cast<Eigen::Index>(entries.size());
    if (count == size)
        return Eigen::Map<const Eigen::VectorXd>(entries.data(), size).asDiagonal();
    if (count != size * (size + 1) / 2)
        throw InputError("the solid of a reduced model has another number of entries than states");
    Matrix matrix(size, size);
    auto entry = entries.begin();
    for (Eigen::Index j = 0; j < size; ++j)
        for (Eigen::Index i = j; i < size; ++i)
            matrix(i, j) = matrix(j, i) = *entry++;
    return matrix;
}

}  // namespace

StoredTerms stored(const DenseTerms& terms)
{
    StoredTerms result;
    result.solid = entries_of(terms.solid);
    for (const auto& joint : terms.joints)
        for (const auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            result.joints.push_back(as_stored(term->factor));
    for (const auto& film : terms.films)
        result.films.push_back(as_stored(film.factor));
    result.functionals = as_stored(terms.functionals.transpose());
    result.observed = as_stored(terms.observed.transpose());
    result.parts = as_stored(terms.parts);
    return result;
}

void restore(const StoredTerms& stored, DenseTerms& terms)
{
    require_fit(stored, terms.geometry);
    terms.parts = as_matrix(stored.parts);
    terms.uniform = terms.parts.rowwise().sum();
    terms.solid = symmetric(stored.solid, terms.uniform.size());
    terms.functionals = as_matrix(stored.functionals).transpose();
    terms.observed = as_matrix(stored.observed).transpose();
    terms.joints.clear();
    terms.films.clear();
    for (std::size_t i = 0; i < stored.joints.size(); i += 4)
        terms.joints.push_back({{as_matrix(stored.joints[i])},
                                {as_matrix(stored.joints[i + 1])},
                                {as_matrix(stored.joints[i + 2])},
                                {as_matrix(stored.joints[i + 3])}});
    for (const auto& film : stored.films)
        terms.films.push_back({as_matrix(film)});
}

std::string mark_of(const DenseTerms& terms)
{
    const auto numbers = as_stored(terms.functionals.transpose()).entries;
    return stable_hash({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)});
}

}  // namespace deadpoint::reduce
