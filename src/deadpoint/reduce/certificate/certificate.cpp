#include "deadpoint/reduce/certificate/certificate.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/reduce/certificate/bends.hpp"
#include "deadpoint/reduce/certificate/euler_run.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <span>

namespace deadpoint::reduce {
namespace {

// Distances from a source's temperature at which its law is looked at [K].
constexpr std::array distances{0.1, 0.2, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0};

constexpr double law_rounding = 1e-12;  // of a law

// Least fall of a law's heat, times what one watt heats its source (b . K^-1 b). Heat that falls less counts as heat
// that does not fall.
constexpr double least_fall = 1e-2;

// Steps times outputs that are worked on at once, where there are several outputs.
constexpr Eigen::Index columns_at_a_time = 512;

Eigen::MatrixXd side_by_side(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right)
{
    Eigen::MatrixXd result(left.rows(), left.cols() + right.cols());
    result << left, right;
    return result;
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

/// Steps [first, first + count), in all of which heat is conducted alike and sources load the same places.
struct Stretch {
    std::vector<double> coefficients;  ///< of the conduction matrix
    Eigen::MatrixXd loads;             ///< of one watt of each source by the residual's vectors, a column for each
    Eigen::Index first = 0, count = 0;
};

/// A source's law around a temperature, a continuous one and jumps. With its tangent there,
/// |continuous law - tangent| <= curvature/2 e^2 and <= bend |e| at distances e.
struct LawShape {
    double steepest_rise = 0, gentlest_fall = 0;  ///< [W/K], not below 0
    double curvature = 0;                         ///< [W/K2]
    double bend = 0;                              ///< [W/K]
    double jump = 0;                              ///< sum of the sizes of all jumps [W]
};

struct Jump {
    double at = 0, size = 0;
};

/// Where a table rises or falls by more than 1e-6 of its value within a hundred thousandth of a kelvin.
std::vector<Jump> jumps_of(const LawTable& law)
{
    constexpr double narrow = 1e-5, least = 1e-6;
    std::vector<Jump> found;
    const auto &at = law.points(), &value = law.values();
    for (std::size_t k = 1; k < at.size(); ++k)
        if (at[k] - at[k - 1] < narrow &&
            std::abs(value[k] - value[k - 1]) > least * std::max(std::abs(value[k]), std::abs(value[k - 1])))
            found.push_back({(at[k - 1] + at[k]) / 2, value[k] - value[k - 1]});
    return found;
}

/// A law without its jumps within the distances that are looked at, and the sum of their sizes.
struct WithoutJumps {
    WithoutJumps(const LawTable& law_, double at_) : law(law_), at(at_)
    {
        for (const auto& one : jumps_of(law))
            if (std::abs(one.at - at) <= distances.back()) {
                jumps.push_back(one);
                size += std::abs(one.size);
            }
    }
    [[nodiscard]] LawValue operator()(double temperature) const
    {
        auto value = law(temperature);
        for (const auto& one : jumps)
            value.value -= one.size * ((temperature > one.at ? 1 : 0) - (at > one.at ? 1 : 0));
        return value;
    }
    const LawTable& law;
    double at = 0;
    std::vector<Jump> jumps;
    double size = 0;
};

class Certifier {
public:
    Certifier(const std::shared_ptr<const PreparedTerms>& terms, const ResidualTerms& residual,
              const HeatProblem& problem)
        : terms_(terms->terms), residual_(residual), uniform_(uniform_loads(terms_, residual)), problem_(problem),
          run_(terms, problem)
    {}

    void march(const std::vector<double>& times)
    {
        run_.march(steps_of(times));
        divide();
        for (const auto& stretch : stretches_)
            norms_.emplace_back(residual_, uniform_, stretch.coefficients);
        seen_ = seen_by_terms(residual_, uniform_, states());
        on_states_ = unconducted_on_states();
        // One pass over the root for the residual of the run and the loads of all stretches.
        const Eigen::MatrixXd rooted = upper_product(residual_.root, side_by_side(primal_residual(), all_loads()));
        look_at_laws(rooted.rightCols(rooted.cols() - count()));
        remainders_ = remainders(seen_);
        primal_ = sum_of_squares(rooted.leftCols(count()), remainders_ + sizes_of_jumps());
    }

    /// Not positive: the sources may feed an error.
    [[nodiscard]] double kappa() const { return kappa_; }

    /// Value of an output after the last step.
    [[nodiscard]] double value(const heat::Loads& output) const
    {
        return weights_of(output).dot(run_.levels().back().state);
    }

    /// @param outputs  as of certify()
    [[nodiscard]] std::vector<double> bounds(const std::vector<heat::Loads>& outputs)
    {
        Eigen::MatrixXd weights(terms_.uniform.size(), static_cast<Eigen::Index>(outputs.size()));
        for (std::size_t k = 0; k < outputs.size(); ++k)
            weights.col(static_cast<Eigen::Index>(k)) = weights_of(outputs[k]);
        const auto duals = run_.duals(weights);
        const auto at_a_time =
            static_cast<std::size_t>(columns_at_a_time / std::clamp<Eigen::Index>(count(), 1, columns_at_a_time));
        std::vector<double> result;
        for (std::size_t first = 0; first < outputs.size(); first += at_a_time) {
            const std::size_t some = std::min(at_a_time, outputs.size() - first);
            const auto bounds = bounds_of({duals.data() + first, some}, {outputs.data() + first, some});
            result.insert(result.end(), bounds.begin(), bounds.end());
        }
        return result;
    }

private:
    // Bounds of outputs with these duals, in one pass over the factors and one over the root.
    [[nodiscard]] std::vector<double> bounds_of(std::span<const Eigen::MatrixXd> duals,
                                                std::span<const heat::Loads> outputs) const
    {
        const Eigen::Index steps = count(), all = steps * static_cast<Eigen::Index>(duals.size());
        Eigen::MatrixXd states(terms_.uniform.size(), all), residuals(residual_.count(), all);
        for (std::size_t k = 0; k < duals.size(); ++k)
            states.middleCols(static_cast<Eigen::Index>(k) * steps, steps) = duals[k];
        const auto seen = seen_by_terms(residual_, uniform_, states);
        const auto seen_of = [&](std::size_t k) { return seen.columns(static_cast<Eigen::Index>(k) * steps, steps); };
        for (std::size_t k = 0; k < duals.size(); ++k)
            residuals.middleCols(static_cast<Eigen::Index>(k) * steps, steps) =
                dual_residual(duals[k], seen_of(k), outputs[k]);
        const Eigen::MatrixXd rooted = upper_product(residual_.root, residuals);
        std::vector<double> result;
        for (std::size_t k = 0; k < duals.size(); ++k) {
            const auto rest = remainders(seen_of(k));
            const double dual = sum_of_squares(rooted.middleCols(static_cast<Eigen::Index>(k) * steps, steps), rest);
            result.push_back(std::sqrt(primal_ * dual) / kappa_ + consistency(duals[k], seen_of(k), rest) +
                             curvature(duals[k]));
        }
        return result;
    }
    [[nodiscard]] double duration(Eigen::Index step) const
    {
        return run_.levels()[static_cast<std::size_t>(step)].step.duration;
    }
    [[nodiscard]] const double* slopes_at(Eigen::Index step) const
    {
        return run_.levels()[static_cast<std::size_t>(step)].slopes.data();
    }
    [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(run_.levels().size()); }

    // Weights of the states in an output.
    [[nodiscard]] Eigen::VectorXd weights_of(const heat::Loads& output) const
    {
        const auto functionals = static_cast<std::size_t>(terms_.functionals.rows());
        Eigen::VectorXd weights = Eigen::VectorXd::Zero(terms_.uniform.size());
        for (const auto& [of, factor] : output) {
            const bool is_observed = of >= functionals;
            weights += factor * (is_observed ? terms_.observed : terms_.functionals)
                                    .row(static_cast<Eigen::Index>(is_observed ? of - functionals : of))
                                    .transpose();
        }
        return weights;
    }

    [[nodiscard]] Eigen::MatrixXd states() const
    {
        Eigen::MatrixXd result(terms_.uniform.size(), count());
        for (Eigen::Index k = 0; k < count(); ++k)
            result.col(k) = run_.levels()[static_cast<std::size_t>(k)].state;
        return result;
    }

    void divide()
    {
        std::optional<std::size_t> present;
        for (Eigen::Index k = 0; k < count(); ++k) {
            const auto segment = run_.levels()[static_cast<std::size_t>(k)].step.segment;
            if (present != segment) {
                Stretch next{coefficients_of(problem_, problem_.segments[segment]), source_columns(segment), k, 0};
                if (stretches_.empty() || next.coefficients != stretches_.back().coefficients ||
                    next.loads != stretches_.back().loads)
                    stretches_.push_back(std::move(next));
                present = segment;
            }
            ++stretches_.back().count;
        }
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

    // Loads of all stretches, side by side.
    [[nodiscard]] Eigen::MatrixXd all_loads() const
    {
        const auto sources = static_cast<Eigen::Index>(problem_.sources.size());
        Eigen::MatrixXd result(residual_.count(), sources * static_cast<Eigen::Index>(stretches_.size()));
        for (std::size_t s = 0; s < stretches_.size(); ++s)
            result.middleCols(static_cast<Eigen::Index>(s) * sources, sources) = stretches_[s].loads;
        return result;
    }

    // -K V x, a column for each step.
    [[nodiscard]] Eigen::MatrixXd not_conducted(const SeenByTerms& seen) const
    {
        Eigen::MatrixXd result(residual_.count(), count());
        for (std::size_t s = 0; s < stretches_.size(); ++s)
            result.middleCols(stretches_[s].first, stretches_[s].count) =
                -norms_[s].conducted(seen.columns(stretches_[s].first, stretches_[s].count));
        return result;
    }

    [[nodiscard]] Eigen::MatrixXd primal_residual() const
    {
        Eigen::MatrixXd result = not_conducted(seen_);
        for (Eigen::Index k = 0; k < count(); ++k) {
            const auto& level = run_.levels()[static_cast<std::size_t>(k)];
            result.col(k).head(residual_.states) = (level.before - level.state) / level.step.duration;
            result.col(k).segment(residual_.first_functional(), residual_.functionals) +=
                Eigen::Map<const Eigen::VectorXd>(level.watts.data(), residual_.functionals);
        }
        return result;
    }

    [[nodiscard]] Eigen::MatrixXd dual_residual(const Eigen::MatrixXd& duals, const SeenByTerms& seen,
                                                const heat::Loads& output) const
    {
        Eigen::MatrixXd result = not_conducted(seen);
        for (Eigen::Index k = 0; k < count(); ++k) {
            const bool is_last = k + 1 == count();
            result.col(k).head(residual_.states) =
                ((is_last ? Eigen::VectorXd::Zero(duals.rows()).eval() : duals.col(k + 1).eval()) - duals.col(k)) /
                duration(k);
            for (const auto& [of, factor] : is_last ? output : heat::Loads{})
                result(residual_.first_functional() + static_cast<Eigen::Index>(of), k) += factor / duration(k);
        }
        for (const auto& [coefficients, loads, first, steps] : stretches_) {
            Eigen::MatrixXd heat = seen_by_sources(loads, duals.middleCols(first, steps));
            for (Eigen::Index k = 0; k < steps; ++k)
                heat.col(k).array() *= Eigen::Map<const Eigen::ArrayXd>(slopes_at(first + k), heat.rows());
            result.middleRows(residual_.first_functional(), residual_.functionals).middleCols(first, steps) +=
                loads.middleRows(residual_.first_functional(), residual_.functionals) * heat;
        }
        return result;
    }

    // b . V x of each source, column by column.
    [[nodiscard]] Eigen::MatrixXd seen_by_sources(const Eigen::MatrixXd& loads, const Eigen::MatrixXd& states) const
    {
        return loads.middleRows(residual_.first_functional(), residual_.functionals).transpose() *
               (terms_.functionals * states);
    }

    // Sizes of what conduction of states leaves out of the residual's vectors, for each step.
    [[nodiscard]] Eigen::VectorXd remainders(const SeenByTerms& seen) const
    {
        Eigen::VectorXd result(count());
        for (std::size_t s = 0; s < stretches_.size(); ++s)
            result.segment(stretches_[s].first, stretches_[s].count) =
                norms_[s].remainder_squares(seen.columns(stretches_[s].first, stretches_[s].count)).cwiseSqrt();
        return result;
    }

    // Sum of dt |residual|^2. @param rooted  the root times the residuals @param rest  sizes of their remainders
    [[nodiscard]] double sum_of_squares(const Eigen::MatrixXd& rooted, const Eigen::VectorXd& rest) const
    {
        double sum = 0;
        for (std::size_t s = 0; s < stretches_.size(); ++s) {
            const auto first = stretches_[s].first, steps = stretches_[s].count;
            const Eigen::VectorXd main = norms_[s].squares(rooted.middleCols(first, steps));
            for (Eigen::Index k = 0; k < steps; ++k) {
                const double size = std::sqrt(main[k]) + rest[first + k];
                sum += duration(first + k) * size * size;
            }
        }
        return sum;
    }

    // V^T residual but for the heat that terms conduct, a column for each step.
    [[nodiscard]] Eigen::MatrixXd unconducted_on_states() const
    {
        Eigen::MatrixXd result = -transposed_product(terms_.solid, states());
        for (Eigen::Index k = 0; k < count(); ++k) {
            const auto& level = run_.levels()[static_cast<std::size_t>(k)];
            const Eigen::Map<const Eigen::VectorXd> watts(level.watts.data(), residual_.functionals);
            result.col(k) += terms_.functionals.transpose() * watts - (level.state - level.before) / duration(k);
        }
        return result;
    }

    // |sum dt z . V^T residual|: zero but for cut terms and for the tolerance of Newton's method.
    // @param of_duals  sizes of their remainders
    [[nodiscard]] double consistency(const Eigen::MatrixXd& duals, const SeenByTerms& seen,
                                     const Eigen::VectorXd& of_duals) const
    {
        double sum = 0, rest = 0;
        const Eigen::MatrixXd functionals = terms_.functionals * duals;
        for (std::size_t s = 0; s < stretches_.size(); ++s) {
            const auto first = stretches_[s].first, steps = stretches_[s].count;
            const Eigen::VectorXd conducted = norms_[s].conducted_between(
                seen.columns(first, steps), functionals.middleCols(first, steps), seen_.columns(first, steps));
            for (Eigen::Index k = 0; k < steps; ++k)
                sum -= duration(first + k) * conducted[k];
        }
        for (Eigen::Index k = 0; k < count(); ++k) {
            sum += duration(k) * duals.col(k).dot(on_states_.col(k));
            rest += duration(k) * of_duals[k] * remainders_[k];
        }
        return std::abs(sum) + rest;
    }

    // Sets kappa, the shape of each law at each step, and products of the sources' loads.
    // @param rooted_loads  the root times the loads of all stretches
    void look_at_laws(const Eigen::MatrixXd& rooted_loads)
    {
        const auto sources = static_cast<Eigen::Index>(problem_.sources.size());
        curvatures_ = bends_ = falls_ = jumps_ = Eigen::MatrixXd::Zero(sources, count());
        kappa_ = 1;
        for (std::size_t s = 0; s < stretches_.size(); ++s) {
            load_products_.push_back(
                norms_[s].products(rooted_loads.middleCols(static_cast<Eigen::Index>(s) * sources, sources)));
            Eigen::VectorXd rising = Eigen::VectorXd::Zero(sources);
            for (Eigen::Index k = stretches_[s].first; k < stretches_[s].first + stretches_[s].count; ++k)
                for (Eigen::Index r = 0; r < sources; ++r) {
                    const auto shape = shape_of(run_.levels()[static_cast<std::size_t>(k)], r);
                    rising[r] = std::max(rising[r], shape.steepest_rise);
                    bends_(r, k) = shape.bend;
                    if (shape.gentlest_fall * load_products_[s](r, r) > least_fall)
                        falls_(r, k) = shape.gentlest_fall;
                    curvatures_(r, k) = shape.curvature;
                    jumps_(r, k) = shape.jump;
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
        const auto& table = problem_.segments[level.step.segment].heat[r];
        if (!table)
            return shape;
        const WithoutJumps law(table, level.temperatures[r]);
        const double share = problem_.sources[r].share, at = level.temperatures[r];
        const auto here = law(at);
        shape.jump = share * law.size;
        shape.steepest_rise = std::max(share * here.slope, 0.0);
        shape.gentlest_fall = std::max(0.0, -share * here.slope);
        for (const double distance : distances)
            for (const double e : {-distance, distance}) {
                const auto there = law(at + e);
                shape.steepest_rise = std::max(shape.steepest_rise, share * there.slope);
                shape.gentlest_fall = std::min(shape.gentlest_fall, std::max(0.0, -share * there.slope));
                const double left = std::abs(there.value - here.value - here.slope * e);
                const double off = share * std::max(0.0, left - law_rounding * std::abs(here.value));
                shape.curvature = std::max(shape.curvature, 2 * off / (e * e));
                shape.bend = std::max(shape.bend, off / distance);
            }
        return shape;
    }

    // Bound of the sum of dt z . (heat of the laws less that of their tangents).
    [[nodiscard]] double curvature(const Eigen::MatrixXd& duals) const
    {
        Eigen::MatrixXd seen(curvatures_.rows(), count());
        for (const auto& [coefficients, loads, first, steps] : stretches_)
            seen.middleCols(first, steps) = seen_by_sources(loads, duals.middleCols(first, steps)).cwiseAbs();
        const Eigen::MatrixXd weights = seen.cwiseProduct(curvatures_);
        const Eigen::MatrixXd without_fall = (falls_.array() > 0).select(0.0, weights);
        const double of_continuous = std::min(
            curvature_by_energy(weights),
            std::min(curvature_by_energy(without_fall), curvature_without_falls(seen)) + curvature_by_falls(seen));
        return of_continuous + by_jumps(seen);
    }

    // Sources and steps whose heat does not fall, each source alone: (b . e)^2 / (b . K^-1 b) <= |e|_K^2, and
    // sum of dt |e|_K^2 <= sum of dt |r|^2 / kappa^2. @param seen  |b . z|
    [[nodiscard]] double curvature_without_falls(const Eigen::MatrixXd& seen) const
    {
        double sum = 0;
        for (Eigen::Index r = 0; r < seen.rows(); ++r) {
            std::vector<BentLaw> laws;
            for (std::size_t s = 0; s < stretches_.size(); ++s) {
                const double own = load_products_[s](r, r);
                for (Eigen::Index k = stretches_[s].first; k < stretches_[s].first + stretches_[s].count; ++k)
                    if (!(falls_(r, k) > 0) && bends_(r, k) > 0 && own > 0)
                        laws.push_back({duration(k), seen(r, k), curvatures_(r, k), bends_(r, k), 1 / own});
            }
            sum += largest_of_bent(laws, primal_ / (kappa_ * kappa_));
        }
        return sum;
    }

    // What jumps may add to sum of dt z . heat. @param seen  |b . z|
    [[nodiscard]] double by_jumps(const Eigen::MatrixXd& seen) const
    {
        double sum = 0;
        for (Eigen::Index k = 0; k < count(); ++k)
            sum += duration(k) * seen.col(k).dot(jumps_.col(k));
        return sum;
    }

    // Sizes of the heat of all jumps as a part of the residual, for each step.
    [[nodiscard]] Eigen::VectorXd sizes_of_jumps() const
    {
        Eigen::VectorXd result(count());
        for (std::size_t s = 0; s < stretches_.size(); ++s)
            for (Eigen::Index k = stretches_[s].first; k < stretches_[s].first + stretches_[s].count; ++k)
                result[k] = load_products_[s].diagonal().cwiseMax(0.0).cwiseSqrt().dot(jumps_.col(k));
        return result;
    }

    // Half of sum of dt w (b . e)^2 by |b|.
    [[nodiscard]] double curvature_by_energy(const Eigen::MatrixXd& weights) const
    {
        double share = 0;
        for (std::size_t s = 0; s < stretches_.size(); ++s)
            share = std::max(
                share,
                largest_share(load_products_[s],
                              weights.middleCols(stretches_[s].first, stretches_[s].count).rowwise().maxCoeff()));
        return share / 2 * primal_ / (kappa_ * kappa_);
    }

    // Falling heat takes energy from an error: sum of dt |H'| (b . e)^2 <= sum of dt |r|^2 / (4 kappa).
    // @param seen  |b . z|
    [[nodiscard]] double curvature_by_falls(const Eigen::MatrixXd& seen) const
    {
        std::vector<BentLaw> laws;
        for (Eigen::Index k = 0; k < count(); ++k)
            for (Eigen::Index r = 0; r < seen.rows(); ++r)
                if (falls_(r, k) > 0)
                    laws.push_back({duration(k), seen(r, k), curvatures_(r, k), bends_(r, k), falls_(r, k)});
        return largest_of_bent(laws, primal_ / (4 * kappa_));
    }

    const DenseTerms& terms_;
    const ResidualTerms& residual_;
    UniformLoads uniform_;
    const HeatProblem& problem_;
    EulerRun run_;
    std::vector<Stretch> stretches_;
    std::vector<ResidualNorm> norms_;  ///< of each stretch
    Eigen::VectorXd remainders_;       ///< of each step's conduction
    SeenByTerms seen_;                 ///< of the run's states
    Eigen::MatrixXd on_states_;        ///< see unconducted_on_states()
    double primal_ = 0;                ///< sum of dt |r|^2
    double kappa_ = 1;
    Eigen::MatrixXd curvatures_, bends_, falls_, jumps_;  ///< per source and step, of LawShape
    std::vector<Eigen::MatrixXd> load_products_;          ///< of each stretch: b_q . K^-1 b_r
};

}  // namespace

Certificate certify(const std::shared_ptr<const PreparedTerms>& terms, const ResidualTerms& residual,
                    const HeatProblem& problem, const std::vector<double>& times,
                    const std::vector<heat::Loads>& outputs)
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
        result.refused = std::isnan(certifier.kappa())
                             ? "the sizes of its residual are no finite numbers"
                             : "friction heat rises with the temperature faster than heat may flow off";
        return result;
    }
    result.bounds = certifier.bounds(outputs);
    for (const auto& output : outputs)
        result.values.push_back(certifier.value(output));
    const auto finite = [](double number) { return std::isfinite(number); };
    if (!std::ranges::all_of(result.bounds, finite) || !std::ranges::all_of(result.values, finite))
        return {"the bound is no finite number", {}, {}};
    return result;
}

}  // namespace deadpoint::reduce
