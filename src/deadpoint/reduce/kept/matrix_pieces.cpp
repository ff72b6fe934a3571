#include "deadpoint/reduce/kept/matrix_pieces.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/reduce/kept/build_checkpoint.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"

#include <fmt/format.h>

namespace deadpoint::reduce {
namespace {

StoredMatrix<double> in_double(const Eigen::MatrixXd& matrix)
{
    return {static_cast<std::uint64_t>(matrix.rows()),
            static_cast<std::uint64_t>(matrix.cols()),
            {matrix.data(), matrix.data() + matrix.size()}};
}

Eigen::MatrixXd as_matrix(const StoredMatrix<double>& stored, const std::string& piece)
{
    if (!stored.is_whole())
        throw IoError(
            fmt::format("a matrix of the checkpoint's '{}' has another number of entries than it says", piece));
    return Eigen::Map<const Eigen::MatrixXd>(stored.entries.data(), static_cast<Eigen::Index>(stored.rows),
                                             static_cast<Eigen::Index>(stored.columns));
}

}  // namespace

std::vector<Eigen::MatrixXd> read_matrices(const BuildCheckpoint& kept, const std::string& piece)
{
    std::vector<StoredMatrix<double>> stored;
    kept.read(piece, stored);
    std::vector<Eigen::MatrixXd> matrices;
    for (const auto& one : stored)
        matrices.push_back(as_matrix(one, piece));
    return matrices;
}

void write_matrices(const BuildCheckpoint& kept, const std::string& piece, const std::vector<Eigen::MatrixXd>& matrices)
{
    if (!kept.keeps())
        return;
    std::vector<StoredMatrix<double>> stored;
    for (const auto& one : matrices)
        stored.push_back(in_double(one));
    kept.write(piece, stored);
}

std::vector<Eigen::MatrixXd> matrices_of(const DenseTerms& terms)
{
    std::vector<Eigen::MatrixXd> result{terms.solid, terms.functionals, terms.observed, terms.uniform, terms.parts};
    for (const auto& joint : terms.joints)
        for (const auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            result.push_back(term->factor);
    for (const auto& film : terms.films)
        result.push_back(film.factor);
    return result;
}

void take_matrices(const std::vector<Eigen::MatrixXd>& matrices, DenseTerms& terms)
{
    const auto& layout = terms.geometry.layout;
    if (matrices.size() != 5 + 4 * layout.interfaces + layout.surfaces)
        throw IoError("the checkpoint's terms are of another machine\n  help: remove it and build anew");
    auto next = matrices.begin();
    terms.solid = *next++;
    terms.functionals = *next++;
    terms.observed = *next++;
    terms.uniform = *next++;
    terms.parts = *next++;
    terms.joints.assign(layout.interfaces, {});
    for (auto& joint : terms.joints)
        for (auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            term->factor = *next++;
    terms.films.assign(layout.surfaces, {});
    for (auto& film : terms.films)
        film.factor = *next++;
}

}  // namespace deadpoint::reduce
