#pragma once

#include "deadpoint/error.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/largest_term.hpp"
#include "deadpoint/heat/sources.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace deadpoint::heat {

/// Inputs of the present preconditioner, which outlives its step. The same preconditioner can be
/// built again from them.
struct PreconditionerOrigin {
    std::size_t segment = 0;
    double time = 0;          ///< [s]
    double factor = -1;       ///< [s]; negative: none was made
    std::vector<double> air;  ///< per enclosure [K]
};
constexpr auto members(const PreconditionerOrigin*)
{
    return std::tuple{&PreconditionerOrigin::segment, &PreconditionerOrigin::time, &PreconditionerOrigin::factor,
                      &PreconditionerOrigin::air};
}

/// Newton's method for a stage:  M h(T) - factor (sources(T) - K T) = known.
///
/// Joint heat enters by its tangent, as terms of rank one. The energy balance uses the heat of the
/// tangent, so that the stage's heat balance is exact. If the oil temperatures have converged,
/// those used in the solve are kept for the same reason.
template <class System>
class StageSolver {
public:
    using Vector = typename System::Vector;

    StageSolver(System& system, HeatSources<System>& sources)
        : known(system.make_vector()), system_(system), sources_(sources), residual_(system.make_vector()),
          correction_(system.make_vector())
    {}

    Vector known;  ///< right-hand side of the next solve() [J]

    /// @param known_sump   OilMarch's of the stage
    /// @param temperature  the guess, then the solution
    /// @param stored       M h(T) of the solution [J]
    /// @return the sources at the solution, with the watts as rate: sources - K T
    /// @throws ConvergenceError if joint heat and temperatures do not agree; DomainError if a value is not finite
    Rate<Vector> solve(double time, double factor, const std::vector<double>& known_sump, Vector& temperature,
                       Vector& stored)
    {
        system_.impose(time, temperature);
        auto current = sources_.at(time, temperature);
        if (!sources_.oil.empty()) {
            sources_.joints.set_oil(sources_.oil.march(sources_.joints, current.balance, time, factor, known_sump));
            current = sources_.at(time, temperature);
        }
        for (int iteration = 0; iteration < most_iterations; ++iteration) {
            const double change = update(time, factor, current, temperature);
            auto updated = sources_.balance_at(time, temperature);
            const auto corrections = sources_.joints.tangent_less_law(current.balance, updated.balance);
            const auto reaches = sources_.oil.march(sources_.joints, updated.balance, time, factor, known_sump);
            const double oil_change = sources_.oil_change(reaches);
            current = std::move(updated);
            if (nearly_straight(corrections, current.balance) && change < settled &&
                oil_change <= oil_share_of_tolerance * step_tolerance(sources_.problem().time_tolerance)) {
                book(current, corrections);
                finish(factor, temperature, current, stored);
                return current;
            }
            if (oil_change > 0) {
                sources_.joints.set_oil(reaches);
                current = sources_.at(time, temperature);
            } else {
                sources_.complete(current);
            }
        }
        throw ConvergenceError("joint heat and temperatures did not agree within " + std::to_string(most_iterations) +
                               " iterations at t = " + std::to_string(time) +
                               " s; a heat law or film coefficient probably jumps, smooth it or shorten max_step");
    }

    /// Builds the matrix for stages of a given length, at a time and a temperature.
    void build(double time, double factor, const Vector& temperature)
    {
        time_ = time;
        if (sources_.air.count() > 0)
            sources_.build_air_loads(time, factor, temperature);
        const auto inside = sources_.air.temperatures();
        if (system_.build(factor, temperature, sources_.films.following(time, inside)))
            origin_ = {sources_.segment_index(), time, factor, inside};
    }

    /// Solves with that matrix and the tangents of the sources' heat that were set last.
    /// @throws as solve(); the message names the largest term of the heat balance
    void solve_linear(const Vector& right, Vector& solution, SolveTolerance tolerance, const char* what)
    {
        LowRank<Vector> low_rank{source_slopes_, {}};
        sources_.air.add_terms(low_rank.others);
        const auto with_term = [&](const Error& error) {
            return std::string(error.what()) + "\n  the largest term of the heat balance at t = " + short_text(time_) +
                   " s is " + largest();
        };
        try {
            iterations += system_.solve(right, solution, low_rank, tolerance, what);
        } catch (const NotFinite& error) {
            throw DomainError(with_term(error) + "\n  help: give it a value that can be meant");
        } catch (const ConvergenceError& error) {
            throw ConvergenceError(with_term(error));
        }
    }

    void set_source_slopes(std::vector<double> slopes) { source_slopes_ = std::move(slopes); }
    /// A balance at finite temperatures, for messages.
    void begin_step(const HeatBalance& start) { start_ = &start; }
    [[nodiscard]] const PreconditionerOrigin& origin() const { return origin_; }
    void set_origin(PreconditionerOrigin origin) { origin_ = std::move(origin); }

    int iterations = 0;  ///< of linear solves
    int solves = 0;

private:
    static constexpr int most_iterations = 20;
    static constexpr double settled = 1e-7;  // [K]
    // Joint heat may differ from its tangent within a stage by this share.
    static constexpr double largest_curvature = 1e-5;
    // The temperatures of the oil within a stage must agree to this share of the step's tolerance.
    static constexpr double oil_share_of_tolerance = 1e-3;

    // One linear solve; returns the largest change if the matrix depends on temperature, else 0
    // [K].
    double update(double time, double factor, const Rate<Vector>& current, Vector& temperature)
    {
        build(time, factor, temperature);
        set_residual(factor, temperature, current.watts);
        const auto of_air = sources_.air.residual(current.balance);
        sources_.air.eliminate(of_air, residual_);
        source_slopes_ = current.balance.source_slope;
        solve_linear(residual_, correction_, {1e-13, solver_tolerance()}, "the temperature field");
        ++solves;
        system_.add(-1, correction_, temperature);
        require_finite(temperature, time);
        const double air_change = sources_.air.update(of_air, correction_);
        return system_.follows_temperature() ? std::max(system_.largest(correction_), air_change) : 0;
    }

    // Where Newton's method must settle, a solve must leave less than that.
    [[nodiscard]] double solver_tolerance() const
    {
        const double wanted = sources_.problem().solver_tolerance;
        return system_.follows_temperature() ? std::min(wanted, 0.1 * settled) : wanted;
    }

    // M h(T) - factor (sources - K T) - known. Where the matrix is M + factor K, it takes one product.
    void set_residual(double factor, const Vector& temperature, const Vector& sources)
    {
        if (system_.is_linear()) {
            system_.apply_stage(temperature, residual_);
        } else {
            system_.conduct(temperature, correction_);
            system_.store(temperature, residual_);
            system_.add(factor, correction_, residual_);
        }
        system_.add(-factor, sources, residual_);
        system_.add(-1, known, residual_);
        system_.clear_prescribed(residual_);
    }

    // Computes the stored heat at the end, and turns the sources into the rate: by the stage's
    // formula (stored - known) / factor if it holds for every unknown.
    void finish(double factor, const Vector& temperature, Rate<Vector>& rate, Vector& stored)
    {
        system_.store(temperature, stored);
        if (system_.is_linear()) {
            system_.combine({{1 / factor, &stored}, {-1 / factor, &known}}, rate.watts);
        } else {
            system_.conduct(temperature, residual_);
            system_.add(-1, residual_, rate.watts);
        }
    }

    // Where the rate follows from the stored heat, finish() needs no watts.
    void book(Rate<Vector>& rate, const std::vector<double>& corrections) const
    {
        if (system_.is_linear()) {
            rate.pending.clear();
            sources_.correct(rate.balance, corrections);
        } else {
            sources_.complete(rate);
            sources_.correct(rate, corrections);
        }
    }

    [[nodiscard]] static bool nearly_straight(const std::vector<double>& corrections, const HeatBalance& balance)
    {
        const auto add_size = [](double sum, double heat) { return sum + std::abs(heat); };
        const double curvature = std::accumulate(corrections.begin(), corrections.end(), 0.0, add_size);
        const double heat = std::accumulate(balance.source_heat.begin(), balance.source_heat.end(), 1e-300, add_size);
        return curvature <= largest_curvature * heat;
    }

    void require_finite(const Vector& temperature, double time) const
    {
        if (!system_.is_finite(temperature))
            throw DomainError("a temperature became non-finite at t = " + std::to_string(time) +
                              " s; look for a heat law or film that is not finite at the temperatures reached");
    }

    [[nodiscard]] std::string largest() const
    {
        static const HeatBalance none;
        return largest_term(sources_.problem(), sources_.segment(), system_.geometry(), sources_.joints,
                            start_ ? *start_ : none, time_, system_.terms());
    }

    System& system_;
    HeatSources<System>& sources_;
    Vector residual_, correction_;
    std::vector<double> source_slopes_;  ///< [W/K]
    double time_ = 0;                    ///< of the last build() [s]
    const HeatBalance* start_ = nullptr;
    PreconditionerOrigin origin_;
};

}  // namespace deadpoint::heat
