#include "deadpoint/reduce/online/dense_terms.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace deadpoint::reduce {
namespace {

// Share of a term's size that it may conduct at a uniform temperature where it should conduct nothing: above the
// rounding of numbers of 32 bits, below any wrong coefficient.
constexpr double largest_leak = 1e-4;
// The terms' matrices cost about as much as two sums of factors.
constexpr std::size_t few_sums = 2;
constexpr double most_matrices = 2e9;  // memory of all terms' matrices, above which sums are those of factors [byte]

// Memory of n^2/2 numbers for each term [byte].
double matrices_of(const DenseTerms& terms)
{
    const auto n = static_cast<double>(terms.uniform.size());
    return 0.5 * n * n * sizeof(double) * static_cast<double>(4 * terms.joints.size() + terms.films.size());
}

void require_sizes(const DenseTerms& terms)
{
    const Eigen::Index n = terms.uniform.size();
    const auto& layout = terms.geometry.layout;
    const auto fits = [&](const LowRankTerm& term) { return term.is_missing() || term.factor.rows() == n; };
    const auto joint_fits = [&](const DenseJoint& joint) {
        return fits(joint.aa) && fits(joint.bb) && fits(joint.between) && fits(joint.turning) &&
               !joint.aa.is_missing() && !joint.bb.is_missing();
    };
    const bool sound = terms.solid.rows() == n && terms.solid.cols() == n && terms.joints.size() == layout.interfaces &&
                       std::ranges::all_of(terms.joints, joint_fits) && terms.films.size() == layout.surfaces &&
                       std::ranges::all_of(terms.films, fits) &&
                       terms.geometry.interface_area.size() == layout.interfaces &&
                       terms.geometry.surface_area.size() == layout.surfaces &&
                       terms.functionals.rows() == static_cast<Eigen::Index>(layout.count()) &&
                       terms.functionals.cols() == n && (terms.observed.size() == 0 || terms.observed.cols() == n);
    if (!sound || !(terms.uniform.squaredNorm() > 0))
        throw InputError("the terms of a dense system differ in size");
}

void require_small(double leak, double size, const std::string& what)
{
    if (!(leak <= largest_leak * size))
        throw InputError(what + " conducts heat at a uniform temperature; make it from the same states as the others");
}

void without_uniform(Eigen::MatrixXd& solid, const Eigen::VectorXd& uniform)
{
    const Eigen::VectorXd unit = uniform.normalized(), leak = solid * unit;
    require_small(leak.norm(), solid.norm(), "the solid of a dense system");
    solid -= leak * unit.transpose() + unit * (leak - unit.dot(leak) * unit).transpose();
}

void without_uniform(LowRankTerm& term, const Eigen::VectorXd& uniform, const std::string& what)
{
    if (term.is_missing())
        return;
    const Eigen::VectorXd unit = uniform.normalized();
    const Eigen::RowVectorXd leak = unit.transpose() * term.factor;
    require_small(leak.norm(), term.factor.norm(), what);
    term.factor -= unit * leak;
}

// Reflects the columns so that only the first is not zero for a uniform temperature, and sets that one to what the
// mean says. @param integral  of the temperature over the area [K m2]
void with_mean(LowRankTerm& term, const Eigen::VectorXd& uniform, const Eigen::VectorXd& integral, double area,
               const std::string& what)
{
    if (term.is_missing() || !(area > 0))
        return;
    Eigen::VectorXd mirror = term.factor.transpose() * uniform;
    const double length = mirror.norm();
    if (!(length > 0))
        throw InputError(what + " of a dense system has an area but no mean; cut fewer directions of it");
    mirror[0] += std::copysign(length, mirror[0]);
    term.factor -= 2 / mirror.squaredNorm() * (term.factor * mirror) * mirror.transpose();
    term.factor.col(0) = integral / std::sqrt(area);
}

// To the lower triangle. Eigen divides by the number of columns.
void add_term(Eigen::MatrixXd& lower, const LowRankTerm& term, double weight)
{
    if (term.factor.cols() > 0)
        lower.selfadjointView<Eigen::Lower>().rankUpdate(term.factor, weight);
}

double largest_eigenvalue(const LowRankTerm& term)
{
    if (term.factor.cols() == 0)
        return 0;
    const Eigen::MatrixXd small = term.factor.transpose() * term.factor;
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(small, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

}  // namespace

void conserve_heat(DenseTerms& terms)
{
    require_sizes(terms);
    const auto& [layout, names, interface_area, surface_area] = terms.geometry;
    const auto row = [&](std::size_t functional) -> Eigen::VectorXd {
        return terms.functionals.row(static_cast<Eigen::Index>(functional)).transpose();
    };
    without_uniform(terms.solid, terms.uniform);
    for (std::size_t i = 0; i < terms.joints.size(); ++i) {
        auto& joint = terms.joints[i];
        const double area = interface_area[i];
        const std::string what = "interface " + std::to_string(i);
        without_uniform(joint.between, terms.uniform, what);
        without_uniform(joint.turning, terms.uniform, what);
        with_mean(joint.aa, terms.uniform, area * row(layout.mean(i, false)), area, what);
        with_mean(joint.bb, terms.uniform, area * row(layout.mean(i, true)), area, what);
    }
    for (std::size_t s = 0; s < terms.films.size(); ++s)
        with_mean(terms.films[s], terms.uniform, row(layout.surface(s)), surface_area[s],
                  "surface " + std::to_string(s));
}

const SymmetricMatrix& TermMatrix::matrix() const
{
    std::call_once(once_, [&] {
        Eigen::MatrixXd lower = Eigen::MatrixXd::Zero(term_.factor.rows(), term_.factor.rows());
        add_term(lower, term_, 1);
        matrix_ = SymmetricMatrix(lower);
    });
    return matrix_;
}

PreparedTerms::PreparedTerms(DenseTerms given, Sums sums) : terms(std::move(given)), sums_(sums)
{
    conserve_heat(terms);
    solid_ = SymmetricMatrix(terms.solid);
    for (const auto& joint : terms.joints)
        for (const auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            each.emplace_back(*term);
    first_deviation.push_back(0);
    for (const auto& film : terms.films) {
        each.emplace_back(film);
        stiffest_film.push_back(largest_eigenvalue(film));
        first_deviation.push_back(first_deviation.back() + std::max<Eigen::Index>(film.factor.cols() - 1, 0));
    }
    deviations.resize(first_deviation.back(), terms.uniform.size());
    for (std::size_t s = 0; s < terms.films.size(); ++s) {
        const Eigen::Index count = first_deviation[s + 1] - first_deviation[s];
        if (count > 0)
            deviations.middleRows(first_deviation[s], count) = terms.films[s].factor.rightCols(count).transpose();
    }
}

SymmetricMatrix PreparedTerms::sum_of_matrices(const TermWeights& weights) const
{
    std::vector<SymmetricMatrix::Term> matrices;
    for (const auto& [term, weight] : weights)
        matrices.push_back({weight, &each[term].matrix()});
    return solid_.plus(matrices);
}

SymmetricMatrix PreparedTerms::sum_of_factors(const TermWeights& weights) const
{
    Eigen::MatrixXd lower = terms.solid;
    for (const auto& [term, weight] : weights)
        add_term(lower, each[term].term(), weight);
    return SymmetricMatrix(lower);
}

std::shared_ptr<const Conduction> PreparedTerms::conduction(const TermWeights& weights) const
{
    return conductions_.get(weights, [&] {
        const bool few = sums_ == Sums::of_factors && conductions_.count() < few_sums;
        return few || matrices_of(terms) > most_matrices ? sum_of_factors(weights) : sum_of_matrices(weights);
    });
}

}  // namespace deadpoint::reduce
