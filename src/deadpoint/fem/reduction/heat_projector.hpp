#pragma once

#include "deadpoint/fem/space/fields.hpp"
#include "deadpoint/reduce/offline/full_model.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct Material;
}  // namespace deadpoint

/// The heat terms of a machine on bases of temperature fields.
namespace deadpoint::fem {

class Discretisation;

/// What a run of the reduced model records besides the functionals of the heat balance.
struct ObservedAdjoints {
    const std::vector<Adjoint>& adjoints;  ///< outlive the projector
    Attribution attribution{-1};
};

/// The finite elements of a machine for the reduction (reduce/offline/full_model.hpp). Up to `largest_factor`
/// unknowns a sparse factor of each operator solves for blocks of loads, else multigrid.
/// Fields have single precision: 4 bytes for each unknown and field. Solutions are kept without their mean over the
/// unknowns, which the uniform field has, so that rounding is small beside what they add to it.
class HeatProjector final : public reduce::FullModel {
public:
    /// @param problem  with constant convection coefficients (its laws and emissivities are not read)
    HeatProjector(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem,
                  const ObservedAdjoints& observed, long long largest_factor);
    ~HeatProjector() override;

    [[nodiscard]] std::size_t load_count() const override;
    [[nodiscard]] bool has_load(std::size_t load) const override;
    void add_solutions(const HeatProblem& at, double shift, const std::vector<std::size_t>& loads) override;
    void add_part(std::size_t part) override;
    [[nodiscard]] std::size_t field_count() const override;
    [[nodiscard]] std::vector<float> field(std::size_t field) const override;
    void add_field(const std::vector<float>& field) override;
    [[nodiscard]] Eigen::MatrixXd gram() override;
    void combine(const Eigen::MatrixXd& combinations) override;
    void correct(const Eigen::MatrixXd& combinations) override;
    [[nodiscard]] heat::HeatGeometry geometry() const override;
    [[nodiscard]] reduce::DenseTerms project(const reduce::Truncation& truncation) override;
    [[nodiscard]] std::optional<reduce::ResidualTerms> residual(const reduce::ResidualTask& task,
                                                                Observer& observer) override;
    /// @throws InputError if residual() cannot be had: on several ranks, or with too many unknowns
    void require_residual() const;
    [[nodiscard]] const reduce::Ranks& ranks() const override;
    /// A text that identifies mesh, elements and unknowns; the same on any number of ranks.
    [[nodiscard]] std::string mesh() const;

    /// Writes the fields of the basis (field_file.hpp). Collective.
    /// @param model  reduce::mark_of() the terms on this basis @throws IoError
    void write_fields(const std::string& file, const std::string& model) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace deadpoint::fem
