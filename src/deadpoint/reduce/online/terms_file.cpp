#include "deadpoint/reduce/online/terms_file.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"

#include <utility>

namespace deadpoint::reduce {
namespace {

using Matrix = Eigen::MatrixXd;

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
    terms.parts = as_matrix(stored.parts);
    terms.uniform = terms.parts.rowwise().sum();
    terms.solid = symmetric(stored.solid, terms.uniform.size());
    terms.functionals = as_matrix(stored.functionals).transpose();
    terms.observed = as_matrix(stored.observed).transpose();
    terms.joints.clear();
    terms.films.clear();
    if (stored.joints.size() % 4 != 0)
        throw InputError("a joint of a reduced model lacks a term");
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
