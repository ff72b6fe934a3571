#include "deadpoint/fem/reduction/basis_fields.hpp"

#include "deadpoint/fem/reduction/columns.hpp"

#include <algorithm>

namespace deadpoint::fem {
namespace {

constexpr Eigen::Index rows_at_a_time = 2048;   // of all fields they fit into the cache
constexpr Eigen::Index columns_at_a_time = 32;  // of the product with a sparse matrix

}  // namespace

Eigen::MatrixXd BasisFields::columns(Eigen::Index first, Eigen::Index count) const
{
    Eigen::MatrixXd result(rows_, count);
    for (Eigen::Index k = 0; k < count; ++k)
        result.col(k) = (*this)[first + k].cast<double>();
    return result;
}

Eigen::MatrixXd BasisFields::at(const std::vector<PetscInt>& rows) const
{
    Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), count());
    for (Eigen::Index k = 0; k < count(); ++k)
        for (std::size_t i = 0; i < rows.size(); ++i)
            result(static_cast<Eigen::Index>(i), k) = (*this)[k][rows[i]];
    return result;
}

Eigen::MatrixXd BasisFields::block(Eigen::Index first_row, Eigen::Index rows, Eigen::Index first) const
{
    Eigen::MatrixXd result(rows, count() - first);
    for (Eigen::Index k = first; k < count(); ++k)
        result.col(k - first) = (*this)[k].segment(first_row, rows).cast<double>();
    return result;
}

Eigen::MatrixXd BasisFields::inner_products(const Eigen::MatrixXd& columns, Eigen::Index first) const
{
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(count() - first, columns.cols());
    for (Eigen::Index row = 0; row < rows_; row += rows_at_a_time) {
        const auto rows = std::min(rows_at_a_time, rows_ - row);
        result += product_of_transposed(block(row, rows, first), columns.middleRows(row, rows));
    }
    return result;
}

Eigen::VectorXd BasisFields::evaluate(const SparseFunctional& functional) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(count());
    for (Eigen::Index k = 0; k < count(); ++k) {
        const auto& field = (*this)[k];
        for (std::size_t i = 0; i < functional.local.size(); ++i)
            result[k] += functional.weight[i] * static_cast<double>(field[functional.local[i]]);
    }
    return result;
}

Eigen::VectorXd BasisFields::combination(const Eigen::VectorXd& weights) const
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(rows_);
    for (Eigen::Index k = 0; k < count(); ++k)
        result += weights[k] * (*this)[k].cast<double>();
    return result;
}

Eigen::MatrixXd BasisFields::combinations(const Eigen::MatrixXd& weights) const
{
    Eigen::MatrixXd result(rows_, weights.cols());
    for (Eigen::Index row = 0; row < rows_; row += rows_at_a_time) {
        const auto rows = std::min(rows_at_a_time, rows_ - row);
        result.middleRows(row, rows) = combined(block(row, rows, 0), weights);
    }
    return result;
}

void BasisFields::combine(const Eigen::MatrixXd& combinations)
{
    for (Eigen::Index row = 0; row < rows_; row += rows_at_a_time) {
        const auto rows = std::min(rows_at_a_time, rows_ - row);
        const Eigen::MatrixXd replaced = combined(block(row, rows, 0), combinations);
        for (Eigen::Index k = 0; k < combinations.cols(); ++k)
            fields_[static_cast<std::size_t>(k)].segment(row, rows) = replaced.col(k).cast<float>();
    }
    fields_.resize(static_cast<std::size_t>(combinations.cols()));
}

Eigen::MatrixXd projected(Mat matrix, const BasisFields& fields)
{
    Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(fields.count(), fields.count());
    for (Eigen::Index first = 0; first < fields.count(); first += columns_at_a_time) {
        const auto count = std::min(columns_at_a_time, fields.count() - first);
        lower.block(first, first, fields.count() - first, count) =
            fields.inner_products(times(matrix, fields.columns(first, count)), first);
    }
    sum_over_ranks(lower);
    return lower.selfadjointView<Eigen::Lower>();
}

}  // namespace deadpoint::fem
