#include "deadpoint/reduce/certificate/certificate.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/sources.hpp"
#include "deadpoint/heat/stage_solver.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/online/dense_system.hpp"
#include "deadpoint/reduce/online/tridiagonal.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace deadpoint::reduce {
namespace {

constexpr double far = 5;   // from a source's temperature, to where its law is looked at [K]
constexpr int places = 10;  // at which it is looked at

struct EulerStep {
    std::size_t segment = 0;
    double time = 0, duration = 0;
};

std::vector<EulerStep> steps_of(const std::vector<double>& times)
{
    std::vector<EulerStep> steps;
    std::size_t segment = 0;
    for (std::size_t k = 1; k < times.size(); ++k)
        if (times[k] > times[k - 1])
            steps.push_back({segment, times[k], times[k] - times[k - 1]});
        else
            ++segment;
    return steps;
}

bool starts_in_basis(const DenseTerms& terms, const HeatProblem& problem)
{
    bool uniform = true, in_basis = true;
    for (Eigen::Index p = 0; p < terms.parts.cols(); ++p) {
        const Eigen::VectorXd part = terms.parts.col(p);
        uniform &= problem.initial_temperature(static_cast<int>(p), {}) == problem.initial_temperature(0, {});
        in_basis &= std::abs(part.squaredNorm() - part.dot(terms.uniform)) <= 1e-5 * part.dot(terms.uniform);
    }
    return uniform || in_basis;
}

std::string refusal(const DenseTerms& terms, const HeatProblem& problem)
{
    for (const auto& condition : problem.surfaces)
        if (heat::follows_temperature(condition))
            return fmt::format("the convection of surface '{}' follows its temperature, which a reduced model "
                               "evaluates at the mean of the surface",
                               condition.name);
    for (const auto& segment : problem.segments)
        for (std::size_t r = 0; r < segment.ring_heat.size(); ++r)
            if (segment.ring_heat[r])
                return fmt::format("the heat of '{}' depends on the temperatures of its rings",
                                   problem.sources[r].name);
    if (!problem.oil.empty())
        return "the press has an oil circuit";
    if (!problem.enclosures.empty())
        return "the press encloses air";
    if (!starts_in_basis(terms, problem))
        return "the parts start at different temperatures, and the reduced press was built for a uniform start";
    return {};
}

/// The reduced system by implicit Euler steps, and its dual.
class EulerRun {
public:
    struct Level {
        EulerStep step;
        Eigen::VectorXd before, state;
        std::vector<double> watts;         ///< by functional
        std::vector<double> slopes;        ///< of each source's heat by the solids' part of its temperature [W/K]
        std::vector<double> temperatures;  ///< of the sources [K]
    };

    EulerRun(const std::shared_ptr<const PreparedTerms>& terms, const HeatProblem& problem)
        : problem_(&problem), system_(terms, problem), sources_(system_, problem), stages_(system_, sources_)
    {}

    void march(const std::vector<EulerStep>& steps)
    {
        Eigen::VectorXd state = Eigen::VectorXd::Zero(system_.parts().uniform.size()), stored = state;
        for (Eigen::Index p = 0; p < system_.parts().parts.cols(); ++p)
            state += problem_->initial_temperature(static_cast<int>(p), {}) * system_.parts().parts.col(p);
        for (const auto& step : steps) {
            enter(step.segment);
            Level level{step, state, {}, {}, {}, {}};
            stages_.known = state;
            stages_.solve(step.time, step.duration, {}, state, stored);
            auto rate = sources_.balance_at(step.time, state);
            level.state = state;
            level.watts = std::move(rate.pending);
            level.slopes = rate.balance.source_slope;
            level.temperatures = rate.balance.source_temperature;
            levels_.push_back(std::move(level));
        }
    }

    /// Of each output a matrix with a column for each step. @param weights  of the states after the last step, a column
    /// for each output
    [[nodiscard]] std::vector<Eigen::MatrixXd> duals(const Eigen::MatrixXd& weights)
    {
        const auto outputs = weights.cols();
        std::vector<Eigen::MatrixXd> result(static_cast<std::size_t>(outputs),
                                            Eigen::MatrixXd(weights.rows(), static_cast<Eigen::Index>(levels_.size())));
        Eigen::MatrixXd right = weights;
        for (auto end = static_cast<Eigen::Index>(levels_.size()); end > 0;) {
            const auto first = first_of_segment(end);
            const Eigen::MatrixXd found = duals_in_segment(first, end, right);
            for (Eigen::Index k = first; k < end; ++k)
                for (Eigen::Index i = 0; i < outputs; ++i)
                    result[static_cast<std::size_t>(i)].col(k) = found.col((k - first) * outputs + i);
            right = found.leftCols(outputs);
            end = first;
        }
        return result;
    }

    /// The load of one watt of each source, by functional.
    [[nodiscard]] std::vector<heat::Loads> source_loads(std::size_t segment)
    {
        enter(segment);
        std::vector<heat::Loads> result;
        for (std::size_t r = 0; r < problem_->sources.size(); ++r)
            result.push_back(sources_.joints.source_load(r));
        return result;
    }

    [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }

private:
    [[nodiscard]] const Level& level(Eigen::Index k) const { return levels_[static_cast<std::size_t>(k)]; }
    [[nodiscard]] Eigen::Index first_of_segment(Eigen::Index end) const
    {
        auto first = end - 1;
        while (first > 0 && level(first - 1).step.segment == level(end - 1).step.segment)
            --first;
        return first;
    }

    // The outputs' columns of each step of [first, end), all of one segment, in the basis in which K is tridiagonal:
    //   (1 + d K - d b S b^T) z = right,   S the slopes of the sources' heat.
    [[nodiscard]] Eigen::MatrixXd duals_in_segment(Eigen::Index first, Eigen::Index end, const Eigen::MatrixXd& right)
    {
        enter(level(first).step.segment);
        system_.build(level(first).step.duration, level(first).state, {});
        const auto form = system_.tridiagonal();
        const Eigen::MatrixXd loads = form->basis.transpose() * load_states();
        const auto outputs = right.cols();
        Eigen::MatrixXd present = form->basis.transpose() * right, all(right.rows(), (end - first) * outputs);
        for (auto k = end - 1; k >= first; --k) {
            const auto& [step, before, state, watts, slopes, temperatures] = level(k);
            const ShiftedFactor factor(*form, step.duration);
            const Eigen::VectorXd scaled =
                step.duration * Eigen::Map<const Eigen::VectorXd>(slopes.data(), loads.cols());
            Eigen::MatrixXd solved = loads;
            factor.solve_in_place(solved);
            factor.solve_in_place(present);
            Eigen::MatrixXd small = -(scaled.asDiagonal() * (loads.transpose() * solved));
            small.diagonal().array() += 1;
            const Eigen::MatrixXd heat = scaled.asDiagonal() * (loads.transpose() * present);
            present += solved * small.partialPivLu().solve(heat);
            all.middleCols((k - first) * outputs, outputs) = present;
        }
        return form->basis * all;
    }

    // The load of one watt of each source of the present segment.
    [[nodiscard]] Eigen::MatrixXd load_states() const
    {
        const auto& functionals = system_.parts().functionals;
        Eigen::MatrixXd result =
            Eigen::MatrixXd::Zero(functionals.cols(), static_cast<Eigen::Index>(problem_->sources.size()));
        for (std::size_t r = 0; r < problem_->sources.size(); ++r)
            for (const auto& [functional, weight] : sources_.joints.source_load(r))
                result.col(static_cast<Eigen::Index>(r)) +=
                    weight * functionals.row(static_cast<Eigen::Index>(functional)).transpose();
        return result;
    }

    void enter(std::size_t segment)
    {
        if (present_ == segment)
            return;
        sources_.enter(problem_->segments[segment]);
        present_ = segment;
    }

    const HeatProblem* problem_;
    DenseSystem system_;
    heat::HeatSources<DenseSystem> sources_;
    heat::StageSolver<DenseSystem> stages_;
    std::optional<std::size_t> present_;
    std::vector<Level> levels_;
};

/// Steps of one segment, [first, first + count).
struct SegmentSteps {
    std::size_t segment = 0;
    Eigen::Index first = 0, count = 0;
};

std::vector<SegmentSteps> by_segment(const std::vector<EulerRun::Level>& levels)
{
    std::vector<SegmentSteps> result;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        if (result.empty() || result.back().segment != levels[k].step.segment)
            result.push_back({levels[k].step.segment, static_cast<Eigen::Index>(k), 0});
        ++result.back().count;
    }
    return result;
}

/// A source's law around a temperature.
struct LawShape {
    double largest_slope = 0;  ///< [W/K], 0 where it falls
    double curvature = 0;      ///< largest change of the slope [W/K2]
};

class Certifier {
public:
    Certifier(const std::shared_ptr<const PreparedTerms>& terms, const ResidualTerms& residual,
              const HeatProblem& problem)
        : terms_(terms->terms), residual_(residual), uniform_(uniform_loads(terms_)), problem_(problem),
          run_(terms, problem)
    {}

    void march(const std::vector<double>& times)
    {
        run_.march(steps_of(times));
        segments_ = by_segment(run_.levels());
        for (const auto& steps : segments_) {
            norms_.emplace_back(residual_, uniform_, coefficients_of(problem_, problem_.segments[steps.segment]));
            loads_.push_back(source_columns(steps.segment));
        }
        remainders_ = remainders(states());
        primal_ = sum_of_squares(primal_residual(), remainders_);
        look_at_laws();
    }

    /// Not positive: the sources may feed an error.
    [[nodiscard]] double kappa() const { return kappa_; }

    /// @param outputs  as of certify()
    [[nodiscard]] std::vector<double> bounds(const std::vector<std::size_t>& outputs)
    {
        Eigen::MatrixXd weights(terms_.uniform.size(), static_cast<Eigen::Index>(outputs.size()));
        for (std::size_t k = 0; k < outputs.size(); ++k)
            weights.col(static_cast<Eigen::Index>(k)) = weights_of(outputs[k]);
        const auto duals = run_.duals(weights);
        std::vector<double> result;
        for (std::size_t k = 0; k < outputs.size(); ++k) {
            const double dual = sum_of_squares(dual_residual(duals[k], outputs[k]), remainders(duals[k]));
            result.push_back(std::sqrt(primal_ * dual) / kappa_ + consistency(duals[k]) + curvature(duals[k]));
        }
        return result;
    }

private:
    [[nodiscard]] double duration(Eigen::Index step) const
    {
        return run_.levels()[static_cast<std::size_t>(step)].step.duration;
    }
    [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(run_.levels().size()); }

    // Of an output, on the states.
    [[nodiscard]] Eigen::VectorXd weights_of(std::size_t output) const
    {
        const auto functionals = static_cast<std::size_t>(terms_.functionals.rows());
        const bool is_observed = output >= functionals;
        return (is_observed ? terms_.observed : terms_.functionals)
            .row(static_cast<Eigen::Index>(is_observed ? output - functionals : output))
            .transpose();
    }

    [[nodiscard]] Eigen::MatrixXd states() const
    {
        Eigen::MatrixXd result(terms_.uniform.size(), count());
        for (Eigen::Index k = 0; k < count(); ++k)
            result.col(k) = run_.levels()[static_cast<std::size_t>(k)].state;
        return result;
    }

    // Loads of one watt of each source as coefficients of the residual's vectors.
    [[nodiscard]] Eigen::MatrixXd source_columns(std::size_t segment)
    {
        const auto loads = run_.source_loads(segment);
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(residual_.count(), static_cast<Eigen::Index>(loads.size()));
        for (std::size_t r = 0; r < loads.size(); ++r)
            for (const auto& [functional, weight] : loads[r])
                result(residual_.first_functional() + static_cast<Eigen::Index>(functional),
                       static_cast<Eigen::Index>(r)) += weight;
        return result;
    }

    // -K V x, a column for each step.
    [[nodiscard]] Eigen::MatrixXd not_conducted(const Eigen::MatrixXd& columns) const
    {
        Eigen::MatrixXd result(residual_.count(), columns.cols());
        for (std::size_t s = 0; s < segments_.size(); ++s)
            result.middleCols(segments_[s].first, segments_[s].count) =
                -norms_[s].conducted(columns.middleCols(segments_[s].first, segments_[s].count));
        return result;
    }

    [[nodiscard]] Eigen::MatrixXd primal_residual() const
    {
        Eigen::MatrixXd result = not_conducted(states());
        for (Eigen::Index k = 0; k < count(); ++k) {
            const auto& level = run_.levels()[static_cast<std::size_t>(k)];
            result.col(k).head(residual_.states) = (level.before - level.state) / level.step.duration;
            result.col(k).segment(residual_.first_functional(), residual_.functionals) +=
                Eigen::Map<const Eigen::VectorXd>(level.watts.data(), residual_.functionals);
        }
        return result;
    }

    [[nodiscard]] Eigen::MatrixXd dual_residual(const Eigen::MatrixXd& duals, std::size_t output) const
    {
        Eigen::MatrixXd result = not_conducted(duals);
        for (Eigen::Index k = 0; k < count(); ++k) {
            const bool is_last = k + 1 == count();
            result.col(k).head(residual_.states) =
                ((is_last ? Eigen::VectorXd::Zero(duals.rows()).eval() : duals.col(k + 1).eval()) - duals.col(k)) /
                duration(k);
            if (is_last)
                result(residual_.first_functional() + static_cast<Eigen::Index>(output), k) += 1 / duration(k);
        }
        for (std::size_t s = 0; s < segments_.size(); ++s)
            for (Eigen::Index k = segments_[s].first; k < segments_[s].first + segments_[s].count; ++k) {
                const auto& slopes = run_.levels()[static_cast<std::size_t>(k)].slopes;
                const Eigen::VectorXd seen = seen_by_sources(s, duals.col(k));
                for (std::size_t r = 0; r < slopes.size(); ++r)
                    result.col(k) +=
                        slopes[r] * seen[static_cast<Eigen::Index>(r)] * loads_[s].col(static_cast<Eigen::Index>(r));
            }
        return result;
    }

    // b . V x of each source.
    [[nodiscard]] Eigen::VectorXd seen_by_sources(std::size_t segment, const Eigen::VectorXd& states) const
    {
        return loads_[segment].middleRows(residual_.first_functional(), residual_.functionals).transpose() *
               (terms_.functionals * states);
    }

    // Sizes of what conduction of states leaves out of the residual's vectors, for each step.
    [[nodiscard]] Eigen::VectorXd remainders(const Eigen::MatrixXd& columns) const
    {
        Eigen::VectorXd result(columns.cols());
        for (std::size_t s = 0; s < segments_.size(); ++s)
            result.segment(segments_[s].first, segments_[s].count) =
                norms_[s].remainder_squares(columns.middleCols(segments_[s].first, segments_[s].count)).cwiseSqrt();
        return result;
    }

    // Sum of dt |residual|^2. @param rest  sizes of their remainders
    [[nodiscard]] double sum_of_squares(const Eigen::MatrixXd& residuals, const Eigen::VectorXd& rest) const
    {
        double sum = 0;
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            const auto [segment, first, steps] = segments_[s];
            const Eigen::VectorXd main = norms_[s].squares(residuals.middleCols(first, steps));
            for (Eigen::Index k = 0; k < steps; ++k) {
                const double size = std::sqrt(main[k]) + rest[first + k];
                sum += duration(first + k) * size * size;
            }
        }
        return sum;
    }

    // |sum dt z . V^T residual|: zero but for cut terms, remainders, and for the tolerance of Newton's method.
    [[nodiscard]] double consistency(const Eigen::MatrixXd& duals) const
    {
        const Eigen::VectorXd of_duals = remainders(duals);
        const Eigen::MatrixXd of_run = states();
        double sum = 0, rest = 0;
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            const auto [segment, first, steps] = segments_[s];
            const Eigen::MatrixXd z = duals.middleCols(first, steps);
            const Eigen::VectorXd conducted =
                norms_[s].conduction_between(z, of_run.middleCols(first, steps), terms_.functionals * z);
            for (Eigen::Index k = 0; k < steps; ++k) {
                const auto& level = run_.levels()[static_cast<std::size_t>(first + k)];
                const Eigen::Map<const Eigen::VectorXd> watts(level.watts.data(), residual_.functionals);
                const Eigen::VectorXd rate = terms_.functionals.transpose() * watts -
                                             (level.state - level.before) / level.step.duration -
                                             terms_.solid * level.state;
                sum += level.step.duration * (z.col(k).dot(rate) - conducted[k]);
                rest += level.step.duration * of_duals[first + k] * remainders_[first + k];
            }
        }
        return std::abs(sum) + rest;
    }

    // Sets kappa, |H''| of each source and step, and products of the sources' loads.
    void look_at_laws()
    {
        const auto sources = static_cast<Eigen::Index>(problem_.sources.size());
        curvatures_ = Eigen::MatrixXd::Zero(sources, count());
        kappa_ = 1;
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            load_products_.push_back(norms_[s].products(loads_[s]));
            Eigen::VectorXd rising = Eigen::VectorXd::Zero(sources);
            for (Eigen::Index k = segments_[s].first; k < segments_[s].first + segments_[s].count; ++k)
                for (Eigen::Index r = 0; r < sources; ++r) {
                    const auto shape = shape_of(run_.levels()[static_cast<std::size_t>(k)], r);
                    rising[r] = std::max(rising[r], shape.largest_slope);
                    curvatures_(r, k) = shape.curvature;
                }
            kappa_ = std::min(kappa_, 1 - largest_share(load_products_[s], rising));
        }
    }

    // Largest sum of weight_r (b_r . e)^2 for an error of |e|_K = 1. @param products  b_q . K^-1 b_r
    [[nodiscard]] static double largest_share(const Eigen::MatrixXd& products, const Eigen::VectorXd& weights)
    {
        const Eigen::VectorXd root = weights.cwiseSqrt();
        const Eigen::MatrixXd scaled = root.asDiagonal() * products * root.asDiagonal();
        return scaled.size() == 0 ? 0
                                  : Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
                                        .eigenvalues()
                                        .maxCoeff();
    }

    [[nodiscard]] LawShape shape_of(const EulerRun::Level& level, Eigen::Index source) const
    {
        LawShape shape;
        const auto r = static_cast<std::size_t>(source);
        const auto& law = problem_.segments[level.step.segment].heat[r];
        if (!law)
            return shape;
        const double share = problem_.sources[r].share, from = level.temperatures[r] - far, step = 2 * far / places;
        double before = share * law(from).slope;
        shape.largest_slope = std::max(before, 0.0);
        for (int k = 1; k <= places; ++k) {
            const double slope = share * law(from + k * step).slope;
            shape.largest_slope = std::max(shape.largest_slope, slope);
            shape.curvature = std::max(shape.curvature, std::abs(slope - before) / step);
            before = slope;
        }
        return shape;
    }

    // Of sum of dt z . (heat of the laws less that of their tangents).
    [[nodiscard]] double curvature(const Eigen::MatrixXd& duals) const
    {
        double share = 0;
        for (std::size_t s = 0; s < segments_.size(); ++s) {
            Eigen::VectorXd largest = Eigen::VectorXd::Zero(curvatures_.rows());
            for (Eigen::Index k = segments_[s].first; k < segments_[s].first + segments_[s].count; ++k)
                largest =
                    largest.cwiseMax(seen_by_sources(s, duals.col(k)).cwiseAbs().cwiseProduct(curvatures_.col(k)));
            share = std::max(share, largest_share(load_products_[s], largest));
        }
        return share / 2 * primal_ / (kappa_ * kappa_);
    }

    const DenseTerms& terms_;
    const ResidualTerms& residual_;
    UniformLoads uniform_;
    const HeatProblem& problem_;
    EulerRun run_;
    std::vector<SegmentSteps> segments_;
    std::vector<ResidualNorm> norms_;     ///< per entry of segments_
    std::vector<Eigen::MatrixXd> loads_;  ///< the same: a column for each source
    Eigen::VectorXd remainders_;          ///< of each step's conduction
    double primal_ = 0;                   ///< sum of dt |r|^2
    double kappa_ = 1;
    Eigen::MatrixXd curvatures_;                  ///< per source and step: max |H''| [W/K2]
    std::vector<Eigen::MatrixXd> load_products_;  ///< per entry of segments_: b_q . K^-1 b_r
};

}  // namespace

Certificate certify(const std::shared_ptr<const PreparedTerms>& terms, const ResidualTerms& residual,
                    const HeatProblem& problem, const std::vector<double>& times,
                    const std::vector<std::size_t>& outputs)
{
    Certificate result;
    result.refused = refusal(terms->terms, problem);
    if (!result.refused.empty())
        return result;
    for (const auto& segment : problem.segments)
        if (!covers(residual, coefficients_of(problem, segment))) {
            result.refused = "a coefficient is below the range for which the certificate was made";
            return result;
        }
    Certifier certifier(terms, residual, problem);
    certifier.march(times);
    if (!(certifier.kappa() > 0)) {
        result.refused = "friction heat rises with the temperature faster than heat may flow off";
        return result;
    }
    result.bounds = certifier.bounds(outputs);
    return result;
}

}  // namespace deadpoint::reduce
