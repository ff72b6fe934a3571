#pragma once

#include "../heat/lumps.hpp"
#include "deadpoint/reduce/certificate/directions.hpp"
#include "deadpoint/reduce/certificate/residual_root.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/offline/build.hpp"
#include "deadpoint/reduce/offline/full_model.hpp"
#include "deadpoint/reduce/offline/low_rank.hpp"
#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/parallel/ranks.hpp"

#include <optional>
#include <utility>
#include <vector>

/// Two rods of many lumps that touch in a joint: a full model that fits on a page.
namespace rods {

using deadpoint::HeatProblem;
using namespace deadpoint::reduce;

inline constexpr int lumps_per_rod = 30;

/// The first rod is heated by the joint at its end, the second cooled at its far end. E_SW is the mean of the first rod
/// less that of the second, by 1 um/K.
lumps::Machine machine();

HeatProblem problem();

Box box();

/// All terms of the two rods, with E_SW as the observed functional.
DenseTerms full_terms();

/// The full model: its fields are states of the lumps.
class RodModel : public FullModel {
public:
    [[nodiscard]] std::size_t load_count() const override;
    [[nodiscard]] bool has_load(std::size_t load) const override;
    void add_solutions(const HeatProblem& at, double shift, const std::vector<std::size_t>& loads) override;
    void add_part(std::size_t part) override;
    [[nodiscard]] std::size_t field_count() const override;
    [[nodiscard]] std::vector<float> field(std::size_t field) const override;
    void add_field(const std::vector<float>& field) override;
    [[nodiscard]] deadpoint::heat::HeatGeometry geometry() const override;
    [[nodiscard]] Eigen::MatrixXd gram() override;
    [[nodiscard]] DenseTerms project(const Truncation& truncation) override;
    [[nodiscard]] std::optional<ResidualTerms> residual(const ResidualTask& task,
                                                        deadpoint::Observer& observer) override;
    void combine(const Eigen::MatrixXd& combinations) override;
    void correct(const Eigen::MatrixXd& combinations) override;
    [[nodiscard]] const Ranks& ranks() const override { return ranks_; }

    Eigen::MatrixXd basis = full_terms().uniform;

private:
    [[nodiscard]] std::vector<const LowRankTerm*> terms_in_order() const;
    [[nodiscard]] Eigen::VectorXd load_of(std::size_t load) const;
    [[nodiscard]] Eigen::MatrixXd conduction_of(const HeatProblem& at) const;
    void append(const Eigen::VectorXd& field);
    DenseTerms terms_ = full_terms();
    Ranks ranks_;
};

BuildOptions options();

}  // namespace rods
