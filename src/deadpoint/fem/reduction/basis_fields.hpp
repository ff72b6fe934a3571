#pragma once

#include "deadpoint/fem/space/discretisation.hpp"

#include <Eigen/Dense>
#include <vector>

/// Internal to fem/: the fields of a basis.
namespace deadpoint::fem {

/// Fields in single precision, this rank's unknowns. Each has memory of its own: the block grows and shrinks without a
/// copy of all. Products are computed in double precision, by blocks of unknowns. Nothing is collective: products are
/// this rank's shares.
class BasisFields {
public:
    /// @param rows  this rank's unknowns
    explicit BasisFields(Eigen::Index rows) : rows_(rows) {}
    [[nodiscard]] Eigen::Index rows() const { return rows_; }
    [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(fields_.size()); }

    void append(const Eigen::VectorXf& field) { fields_.push_back(field); }
    [[nodiscard]] const Eigen::VectorXf& operator[](Eigen::Index field) const
    {
        return fields_[static_cast<std::size_t>(field)];
    }
    /// Some fields, a column for each.
    [[nodiscard]] Eigen::MatrixXd columns(Eigen::Index first, Eigen::Index count) const;
    /// Some unknowns of all fields, a row for each. @param rows  counted from the first owned unknown
    [[nodiscard]] Eigen::MatrixXd at(const std::vector<PetscInt>& rows) const;
    /// Inner products of fields, from `first` on, with columns.
    [[nodiscard]] Eigen::MatrixXd inner_products(const Eigen::MatrixXd& columns, Eigen::Index first = 0) const;
    /// Values of a functional of all fields.
    [[nodiscard]] Eigen::VectorXd evaluate(const SparseFunctional& functional) const;
    /// A combination of the fields.
    [[nodiscard]] Eigen::VectorXd combination(const Eigen::VectorXd& weights) const;
    /// Combinations of the fields, a column for each.
    [[nodiscard]] Eigen::MatrixXd combinations(const Eigen::MatrixXd& weights) const;
    /// Replaces the fields by combinations of them. @param combinations  a column for each, at most count()
    void combine(const Eigen::MatrixXd& combinations);

private:
    [[nodiscard]] Eigen::MatrixXd block(Eigen::Index first_row, Eigen::Index rows, Eigen::Index first) const;

    Eigen::Index rows_;
    std::vector<Eigen::VectorXf> fields_;
};

/// fields^T A fields of a symmetric matrix, of all ranks. Collective.
Eigen::MatrixXd projected(Mat matrix, const BasisFields& fields);

}  // namespace deadpoint::fem
