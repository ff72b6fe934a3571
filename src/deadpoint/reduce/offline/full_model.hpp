#pragma once

#include "deadpoint/reduce/online/dense_terms.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace deadpoint {
class Observer;
struct HeatProblem;
}  // namespace deadpoint

namespace deadpoint::reduce {

class Ranks;
struct ResidualTask;
struct ResidualTerms;
struct Truncation;

/// A machine by finite elements, as the reduction needs it: its matrices M and K(p) act on bases of temperature fields.
///
/// Surfaces have constant convection coefficients here. Every member is collective if the machine is distributed.
class FullModel {
public:
    virtual ~FullModel() = default;

    /// Loads that the heat balance knows: functionals of the layout, then those that are observed.
    [[nodiscard]] virtual std::size_t load_count() const = 0;
    /// False where a functional is zero.
    [[nodiscard]] virtual bool has_load(std::size_t load) const = 0;
    /// Solves (shift M + K) x = load for each load, with the coefficients of the problem's joints (HeatProblem::
    /// interfaces) and surfaces, and adds the solutions to the basis.
    /// @param shift [1/s]
    virtual void add_solutions(const HeatProblem& at, double shift, const std::vector<std::size_t>& loads) = 0;
    /// Adds a field to the basis: uniform on a part and zero elsewhere.
    virtual void add_part(std::size_t part) = 0;
    /// Number of fields of the basis.
    [[nodiscard]] virtual std::size_t field_count() const = 0;
    /// A field in the precision in which it is kept, on all ranks, in an order that does not depend on their number.
    [[nodiscard]] virtual std::vector<float> field(std::size_t field) const = 0;
    /// Adds a field that field() gave. @throws InputError if it has another number of values
    virtual void add_field(const std::vector<float>& field) = 0;
    /// Inner products in M of the basis, whose first field is uniform.
    [[nodiscard]] virtual Eigen::MatrixXd gram() = 0;
    /// Replaces the basis by combinations of its fields, to the precision in which the model keeps fields.
    /// @param combinations  a column for each, at most as many as there are fields
    virtual void combine(const Eigen::MatrixXd& combinations) = 0;
    /// The same to double precision, for combinations that hardly change the fields.
    virtual void correct(const Eigen::MatrixXd& combinations) = 0;
    [[nodiscard]] virtual heat::HeatGeometry geometry() const = 0;
    /// The terms on the basis, which is orthonormal in M. All functionals are there.
    [[nodiscard]] virtual DenseTerms project(const Truncation& truncation) = 0;
    /// Products in K'^-1 of the vectors in which residuals of the present basis lie; nothing after
    /// Observer::cancelled().
    /// @throws InputError if the machine is too large for that
    [[nodiscard]] virtual std::optional<ResidualTerms> residual(const ResidualTask& task, Observer& observer) = 0;
    /// The processes over which the machine is distributed.
    [[nodiscard]] virtual const Ranks& ranks() const = 0;
};

}  // namespace deadpoint::reduce
