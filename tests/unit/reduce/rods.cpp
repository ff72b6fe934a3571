#include "rods.hpp"

namespace rods {

lumps::Machine machine()
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

HeatProblem problem()
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

Box box()
{
    using Kind = FreeCoefficient::Kind;
    return {{"left film", Kind::film, {0}, {12}, 0.2, 5}, {"right film", Kind::film, {1}, {20}, 0.2, 5},
            {"a", Kind::side, {0}, {3000}, 0.1, 10},      {"b", Kind::side, {1}, {2000}, 0.1, 10},
            {"oil", Kind::oil, {0}, {300}, 0, 5},         {"heat", Kind::heat, {0}, {60}, 0.3, 3},
            {"ambient", Kind::ambient, {}, {}, -10, 10}};
}

DenseTerms full_terms()
{
    auto terms = lumps::terms_of(machine(), problem());
    const auto n = terms.uniform.size();
    terms.observed = RowMatrix::Zero(1, n);
    for (Eigen::Index k = 0; k < n; ++k)
        terms.observed(0, k) = (k < lumps_per_rod ? 1e-6 : -1e-6) / lumps_per_rod / terms.uniform[k];
    terms.parts = Eigen::MatrixXd(terms.uniform.asDiagonal());
    return terms;
}

BuildOptions options()
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

std::size_t RodModel::load_count() const
{
    return terms_.geometry.layout.count() + static_cast<std::size_t>(terms_.observed.rows());
}

bool RodModel::has_load(std::size_t load) const { return load_of(load).norm() > 0; }

void RodModel::add_solutions(const HeatProblem& at, double shift, const std::vector<std::size_t>& loads)
{
    Eigen::MatrixXd matrix = terms_.solid + conduction_of(at);
    matrix.diagonal().array() += shift;
    const Eigen::LLT<Eigen::MatrixXd> factor(matrix);
    for (const auto load : loads)
        append(factor.solve(load_of(load)).cast<float>().cast<double>());
}

void RodModel::add_part(std::size_t part) { append(terms_.parts.col(static_cast<Eigen::Index>(part))); }

std::size_t RodModel::field_count() const { return static_cast<std::size_t>(basis.cols()); }

std::vector<float> RodModel::field(std::size_t field) const
{
    const Eigen::VectorXf single = basis.col(static_cast<Eigen::Index>(field)).cast<float>();
    return {single.begin(), single.end()};
}

void RodModel::add_field(const std::vector<float>& field)
{
    append(Eigen::Map<const Eigen::VectorXf>(field.data(), static_cast<Eigen::Index>(field.size())).cast<double>());
}

deadpoint::heat::HeatGeometry RodModel::geometry() const { return terms_.geometry; }

Eigen::MatrixXd RodModel::gram() { return basis.transpose() * basis; }

DenseTerms RodModel::project(const Truncation& /*truncation*/) { return combined(terms_, basis); }

std::optional<ResidualTerms> RodModel::residual(const ResidualTask& task, deadpoint::Observer& /*observer*/)
{
    ResidualTerms result;
    result.states = basis.cols();
    result.lowest = coefficients_of(task.lowest, deadpoint::HeatSegment{});
    auto terms = terms_in_order();
    const LowRankTerm solid{factor_of(terms_.solid, 1e-14)};
    terms.push_back(&solid);
    std::vector<Eigen::MatrixXd> factors;
    for (const auto* term : terms) {
        const Eigen::MatrixXd seen =
            term->is_missing() ? Eigen::MatrixXd(basis.cols(), 0) : Eigen::MatrixXd(basis.transpose() * term->factor);
        factors.push_back(low_rank_factor(
            [&](const Eigen::MatrixXd& columns) { return Eigen::MatrixXd(seen * (seen.transpose() * columns)); },
            basis.cols(), task.cut.further));
    }
    const auto combinations = choose_directions(factors, task, result);
    Eigen::MatrixXd vectors = basis;
    const auto add = [&](const Eigen::MatrixXd& columns) {
        vectors.conservativeResize(Eigen::NoChange, vectors.cols() + columns.cols());
        vectors.rightCols(columns.cols()) = columns;
    };
    for (std::size_t q = 0; q < terms.size(); ++q)
        if (combinations[q].cols() > 0)
            add(terms[q]->factor * (terms[q]->factor.transpose() * (basis * combinations[q])));
    add(terms_.functionals.transpose());
    add(terms_.observed.transpose());
    result.functionals = terms_.functionals.rows();
    result.observed = terms_.observed.rows();
    const Eigen::LLT<Eigen::MatrixXd> factor(terms_.solid + conduction_of(task.lowest));
    result.root = residual_root(vectors.transpose() * factor.solve(vectors));
    set_products(result);
    return result;
}

void RodModel::combine(const Eigen::MatrixXd& combinations) { basis *= combinations; }

void RodModel::correct(const Eigen::MatrixXd& combinations) { combine(combinations); }

std::vector<const LowRankTerm*> RodModel::terms_in_order() const
{
    const auto& joint = terms_.joints[0];
    std::vector<const LowRankTerm*> result{&joint.aa, &joint.bb, &joint.between, &joint.turning};
    for (const auto& film : terms_.films)
        result.push_back(&film);
    return result;
}

Eigen::VectorXd RodModel::load_of(std::size_t load) const
{
    const auto count = terms_.geometry.layout.count();
    const bool is_observed = load >= count;
    return (is_observed ? terms_.observed : terms_.functionals)
        .row(static_cast<Eigen::Index>(is_observed ? load - count : load))
        .transpose();
}

Eigen::MatrixXd RodModel::conduction_of(const HeatProblem& at) const
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

void RodModel::append(const Eigen::VectorXd& field)
{
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = field;
}

}  // namespace rods
