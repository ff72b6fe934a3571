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

Eigen::VectorXd packed_lower(const Eigen::MatrixXd& matrix)
{
    const Eigen::Index n = matrix.rows();
    Eigen::VectorXd result(n * (n + 1) / 2);
    for (Eigen::Index column = 0, at = 0; column < n; ++column) {
        result.segment(at, n - column) = matrix.col(column).tail(n - column);
        at += n - column;
    }
    return result;
}

Eigen::VectorXd packed_of(const LowRankTerm& term)
{
    if (term.is_missing())
        return {};
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(term.factor.rows(), term.factor.rows());
    matrix.selfadjointView<Eigen::Lower>().rankUpdate(term.factor);
    return packed_lower(matrix);
}

double largest_eigenvalue(const LowRankTerm& term)
{
    if (term.factor.cols() == 0)
        return 0;
    const Eigen::MatrixXd small = term.factor.transpose() * term.factor;
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(small, Eigen::EigenvaluesOnly).eigenvalues().maxCoeff();
}

constexpr Eigen::Index part_length = 1024;  // numbers of a sum that stay in the nearest cache

// Four terms at a time, so that the sum is read and written less often.
void add_part(const std::vector<PackedTerm>& terms, Eigen::Index begin, Eigen::Ref<Eigen::VectorXd> sum)
{
    const auto part = [&](std::size_t k) { return terms[k].coefficient * terms[k].matrix->segment(begin, sum.size()); };
    std::size_t k = 0;
    for (; k + 4 <= terms.size(); k += 4)
        sum += part(k) + part(k + 1) + part(k + 2) + part(k + 3);
    for (; k < terms.size(); ++k)
        sum += part(k);
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

PreparedTerms::PreparedTerms(DenseTerms given) : terms(std::move(given))
{
    conserve_heat(terms);
    for (const auto& joint : terms.joints)
        for (const auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning})
            packed.push_back(packed_of(*term));
    first_deviation.push_back(0);
    for (const auto& film : terms.films) {
        packed.push_back(packed_of(film));
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

Eigen::MatrixXd lower_sum(const Eigen::MatrixXd& start, const std::vector<PackedTerm>& terms)
{
    Eigen::VectorXd sum = packed_lower(start);
    for (Eigen::Index begin = 0; begin < sum.size(); begin += part_length)
        add_part(terms, begin, sum.segment(begin, std::min(part_length, sum.size() - begin)));
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(start.rows(), start.cols());
    for (Eigen::Index column = 0, at = 0; column < start.cols(); ++column) {
        const Eigen::Index length = start.rows() - column;
        result.col(column).tail(length) = sum.segment(at, length);
        at += length;
    }
    return result;
}

}  // namespace deadpoint::reduce
