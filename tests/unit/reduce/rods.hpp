#pragma once

#include "../heat/lumps.hpp"
#include "deadpoint/reduce/certificate/residual_root.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/offline/build.hpp"
#include "deadpoint/reduce/offline/full_model.hpp"
#include "deadpoint/reduce/offline/low_rank.hpp"
#include "deadpoint/reduce/offline/pod.hpp"
#include "deadpoint/reduce/parallel/ranks.hpp"

#include <utility>
#include <vector>

/// Two rods of many lumps that touch in a joint: a full model that fits on a page.
namespace rods {

using deadpoint::HeatProblem;
using namespace deadpoint::reduce;

inline constexpr int lumps_per_rod = 30;

/// The first rod is heated by the joint at its end, the second cooled at its far end. E_SW is the mean of the first rod
/// less that of the second, by 1 um/K.
inline lumps::Machine machine()
{
    lumps::Machine result;
    for (int k = 0; k < 2 * lumps_per_rod; ++k)
        result.capacity.push_back(400 + 10 * (k % 5));
    for (int k = 0; k + 1 < 2 * lumps_per_rod; ++k)
        if (k + 1 != lumps_per_rod)
            result.links.emplace_back(k, k + 1, 40 + k % 3);
    result.interfaces = {{lumps_per_rod - 1, lumps_per_rod, 0.02}};
    result.surfaces = {{0, 0.3}, {2 * lumps_per_rod - 1, 0.5}, {10, 0.1}};
    result.probes = {0, 15, lumps_per_rod - 1, 45};
    return result;
}

inline HeatProblem problem()
{
    HeatProblem result;
    deadpoint::InterfaceLaw law;
    law.film_a = 3000;
    law.film_b = 2000;
    law.oil = 300;
    law.oil_temperature = 295;
    law.source = 0;
    result.interfaces = {law};
    result.sources = {{"row", 1, {}, {}}};
    result.surfaces = {lumps::film(12), lumps::film(20), lumps::film(8)};
    result.segments = {lumps::segment(result, 3600, 293)};
    result.segments[0].zoned_heat = {0};
    result.segments[0].heat[0] = [](double t) { return deadpoint::LawValue{60 - 0.4 * (t - 293), -0.4, true}; };
    result.initial_temperature = [](int, const deadpoint::Vec3&) { return 293.0; };
    return result;
}

inline Box box()
{
    using Kind = FreeCoefficient::Kind;
    return {{"left film", Kind::film, {0}, {12}, 0.2, 5}, {"right film", Kind::film, {1}, {20}, 0.2, 5},
            {"a", Kind::side, {0}, {3000}, 0.1, 10},      {"b", Kind::side, {1}, {2000}, 0.1, 10},
            {"oil", Kind::oil, {0}, {300}, 0, 5},         {"heat", Kind::heat, {0}, {60}, 0.3, 3},
            {"ambient", Kind::ambient, {}, {}, -10, 10}};
}

/// All terms of the two rods, with E_SW as the observed functional.
inline DenseTerms full_terms()
{
    auto terms = lumps::terms_of(machine(), problem());
    const auto n = terms.uniform.size();
    terms.observed = RowMatrix::Zero(1, n);
    for (Eigen::Index k = 0; k < n; ++k)
        terms.observed(0, k) = (k < lumps_per_rod ? 1e-6 : -1e-6) / lumps_per_rod / terms.uniform[k];
    terms.parts = Eigen::MatrixXd(terms.uniform.asDiagonal());
    return terms;
}

/// The full model: its fields are states of the lumps.
class RodModel : public FullModel {
public:
    [[nodiscard]] std::size_t load_count() const override
    {
        return terms_.geometry.layout.count() + static_cast<std::size_t>(terms_.observed.rows());
    }
    [[nodiscard]] bool has_load(std::size_t load) const override { return load_of(load).norm() > 0; }
    void add_solutions(const HeatProblem& at, double shift, const std::vector<std::size_t>& loads) override
    {
        Eigen::MatrixXd matrix = terms_.solid + conduction_of(at);
        matrix.diagonal().array() += shift;
        const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
        for (const auto load : loads)
            append(factor.solve(load_of(load)).cast<float>().cast<double>());
    }
    void add_part(std::size_t part) override { append(terms_.parts.col(static_cast<Eigen::Index>(part))); }
    [[nodiscard]] std::size_t field_count() const override { return static_cast<std::size_t>(basis.cols()); }
    [[nodiscard]] std::vector<float> field(std::size_t field) const override
    {
        const Eigen::VectorXf single = basis.col(static_cast<Eigen::Index>(field)).cast<float>();
        return {single.begin(), single.end()};
    }
    void add_field(const std::vector<float>& field) override
    {
        append(Eigen::Map<const Eigen::VectorXf>(field.data(), static_cast<Eigen::Index>(field.size())).cast<double>());
    }
    [[nodiscard]] deadpoint::heat::HeatGeometry geometry() const override { return terms_.geometry; }
    [[nodiscard]] Eigen::MatrixXd gram() override { return basis.transpose() * basis; }
    [[nodiscard]] DenseTerms project(const Truncation& truncation) override
    {
        return combined(terms_, basis, truncation);
    }
    [[nodiscard]] ResidualTerms residual(const HeatProblem& lowest, const ResidualCut& cut) override
    {
        ResidualTerms result;
        result.states = basis.cols();
        result.lowest = coefficients_of(lowest, deadpoint::HeatSegment{});
        Eigen::MatrixXd vectors(basis.rows(), 2 * basis.cols());
        vectors << basis, terms_.solid * basis;
        const auto add = [&](const Eigen::MatrixXd& columns) {
            vectors.conservativeResize(Eigen::NoChange, vectors.cols() + columns.cols());
            vectors.rightCols(columns.cols()) = columns;
        };
        for (const auto* term : terms_in_order()) {
            auto& reduced = result.terms.emplace_back();
            if (term->is_missing())
                continue;
            const Eigen::MatrixXd seen = basis.transpose() * term->factor;
            reduced.factor = low_rank_factor(
                [&](const Eigen::MatrixXd& columns) { return Eigen::MatrixXd(seen * (seen.transpose() * columns)); },
                basis.cols(), cut.further);
            const Eigen::VectorXd sizes = reduced.factor.colwise().squaredNorm().transpose();
            reduced.kept = (sizes.array() > cut.kept * sizes.maxCoeff()).count();
            add(term->factor * (seen.transpose() * reduced.kept_factor()) *
                sizes.head(reduced.kept).cwiseInverse().asDiagonal());
        }
        add(terms_.functionals.transpose());
        add(terms_.observed.transpose());
        result.functionals = terms_.functionals.rows();
        result.observed = terms_.observed.rows();
        const Eigen::LLT<Eigen::MatrixXd> factor(terms_.solid + conduction_of(lowest));
        result.root = residual_root(vectors.transpose() * factor.solve(vectors));
        set_products(result);
        return result;
    }
    void combine(const Eigen::MatrixXd& combinations) override { basis *= combinations; }
    void correct(const Eigen::MatrixXd& combinations) override { combine(combinations); }
    [[nodiscard]] const Ranks& ranks() const override { return ranks_; }

    Eigen::MatrixXd basis = full_terms().uniform;

private:
    [[nodiscard]] std::vector<const LowRankTerm*> terms_in_order() const
    {
        const auto& joint = terms_.joints[0];
        std::vector<const LowRankTerm*> result{&joint.aa, &joint.bb, &joint.between, &joint.turning};
        for (const auto& film : terms_.films)
            result.push_back(&film);
        return result;
    }
    [[nodiscard]] Eigen::VectorXd load_of(std::size_t load) const
    {
        const auto count = terms_.geometry.layout.count();
        const bool is_observed = load >= count;
        return (is_observed ? terms_.observed : terms_.functionals)
            .row(static_cast<Eigen::Index>(is_observed ? load - count : load))
            .transpose();
    }
    [[nodiscard]] Eigen::MatrixXd conduction_of(const HeatProblem& at) const
    {
        const auto square = [](const LowRankTerm& term) -> Eigen::MatrixXd {
            return term.factor * term.factor.transpose();
        };
        const auto& law = at.interfaces[0];
        const double sum = law.film_a + law.film_b + law.oil;
        const auto& joint = terms_.joints[0];
        Eigen::MatrixXd result = law.film_a * law.film_b / sum * square(joint.between) +
                                 law.film_a * law.oil / sum * square(joint.aa) +
                                 law.film_b * law.oil / sum * square(joint.bb);
        for (std::size_t s = 0; s < terms_.films.size(); ++s)
            result += at.surfaces[s].coefficient * square(terms_.films[s]);
        return result;
    }
    void append(const Eigen::VectorXd& field)
    {
        basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
        basis.rightCols(1) = field;
    }
    DenseTerms terms_ = full_terms();
    Ranks ranks_;
};

inline BuildOptions options()
{
    BuildOptions result;
    result.sets = 24;
    result.loads_per_set = 4;
    result.training_runs = 20;
    result.test_runs = 6;
    result.largest = 20;
    result.temperature = 0.05;
    result.gap = 1;
    result.has_dual = true;
    result.adjoints = 1;
    result.reference = 293;
    return result;
}

}  // namespace rods
