#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace deadpoint::heat {

struct HeatBalance;

/// The air of one enclosure between two steps.
struct AirState {
    double start = 0;  ///< temperature [K]
    double slope = 0;  ///< [K/s]
    double now = 0;    ///< as last iterated [K]
};
constexpr auto members(const AirState*) { return std::tuple{&AirState::start, &AirState::slope, &AirState::now}; }

/// The air of enclosures, one unknown T_e each in addition to the temperature field.
///
/// With the slopes b [W/K] of its surfaces' heat by its temperature and f = d dt, a stage of
/// TR-BDF2 solves
///   [ A       -f b              ] [ change of T   ]     [ R   ]
///   [ -f b^T   C + f (sum b + G) ] [ change of T_e ] = - [ R_e ]
/// T_e is eliminated (Schur complement): A - f^2 b b^T / c_e stays positive definite, c_e = C + f (sum b + G).
template <class System>
class EnclosedAir {
public:
    using Vector = typename System::Vector;

    EnclosedAir(const std::vector<Enclosure>& enclosures, const System& system)
        : enclosures_(&enclosures), system_(&system), air_(enclosures.size())
    {
        for (auto& air : air_)
            air.load = system.make_vector();
    }

    [[nodiscard]] std::size_t count() const { return air_.size(); }
    /// As last iterated [K].
    [[nodiscard]] std::vector<double> temperatures() const
    {
        std::vector<double> result;
        for (const auto& air : air_)
            result.push_back(air.state.now);
        return result;
    }
    /// At the start of the step [K].
    [[nodiscard]] std::vector<double> at_start() const
    {
        std::vector<double> result;
        for (const auto& air : air_)
            result.push_back(air.state.start);
        return result;
    }
    void start_from(const std::vector<double>& temperature)
    {
        for (std::size_t k = 0; k < air_.size(); ++k)
            air_[k].state.start = air_[k].state.now = temperature.at(k);
    }
    [[nodiscard]] std::vector<AirState> states() const
    {
        std::vector<AirState> result;
        for (const auto& air : air_)
            result.push_back(air.state);
        return result;
    }
    void set_states(const std::vector<AirState>& states)
    {
        for (std::size_t k = 0; k < air_.size(); ++k)
            air_[k].state = states[k];
    }

    /// b of an enclosure, to be filled before complete_load().
    [[nodiscard]] Vector& load(std::size_t enclosure) { return air_[enclosure].load; }
    /// Builds b from a system's loads for stages of length `factor`.
    void complete_load(std::size_t enclosure, double factor)
    {
        auto& air = air_[enclosure];
        factor_ = factor;
        system_->finish_load(air.load);
        air.conductance = system_->total(air.load);
        system_->clear_prescribed(air.load);
    }
    /// Adds the terms that the air subtracts from the stage's matrix.
    void add_terms(std::vector<RankOne<Vector>>& terms) const
    {
        for (std::size_t k = 0; k < air_.size(); ++k)
            terms.push_back({factor_ * factor_ / pivot(k), &air_[k].load});
    }

    void begin_first_stage(double dt, bool slope_known, const HeatBalance& start)
    {
        for (std::size_t k = 0; k < air_.size(); ++k) {
            auto& [load, state, conductance, middle, known] = air_[k];
            state.now = state.start + (slope_known ? gamma_stage * dt * state.slope : 0);
            known = (*enclosures_)[k].capacity * state.start + diagonal * dt * start.air[k].kept();
        }
    }
    void begin_second_stage()
    {
        for (std::size_t k = 0; k < air_.size(); ++k) {
            auto& [load, state, conductance, middle, known] = air_[k];
            middle = state.now;
            known = (*enclosures_)[k].capacity * (bdf_middle * middle - bdf_now * state.start);
            state.now = state.start + (middle - state.start) / gamma_stage;
        }
    }
    /// R_e of the stage [J].
    [[nodiscard]] std::vector<double> residual(const HeatBalance& balance) const
    {
        std::vector<double> result;
        for (std::size_t k = 0; k < air_.size(); ++k)
            result.push_back((*enclosures_)[k].capacity * air_[k].state.now - factor_ * balance.air[k].kept() -
                             air_[k].known);
        return result;
    }
    /// Eliminates the air's residual: adds f R_e b / c_e to that of the field.
    void eliminate(const std::vector<double>& residual, Vector& field_residual) const
    {
        for (std::size_t k = 0; k < air_.size(); ++k)
            system_->add(factor_ * residual[k] / pivot(k), air_[k].load, field_residual);
    }
    /// The air's part of a solution whose field part is given [K].
    [[nodiscard]] std::vector<double> solution(const std::vector<double>& residual, const Vector& field) const
    {
        std::vector<double> result;
        for (std::size_t k = 0; k < air_.size(); ++k)
            result.push_back((residual[k] + factor_ * system_->dot(air_[k].load, field)) / pivot(k));
        return result;
    }
    /// Subtracts that from the temperatures; returns the largest change [K].
    double update(const std::vector<double>& residual, const Vector& field)
    {
        double largest = 0;
        const auto change = solution(residual, field);
        for (std::size_t k = 0; k < air_.size(); ++k) {
            air_[k].state.now -= change[k];
            largest = std::max(largest, std::abs(change[k]));
        }
        return largest;
    }

    /// Largest error of the step by its slopes [K].
    [[nodiscard]] double error(double dt) const
    {
        double largest = 0;
        for (const auto& air : air_) {
            const double middle = (air.middle - air.state.start) / (diagonal * dt) - air.state.slope;
            largest = std::max(largest, std::abs(step_error(dt, air.state.slope, middle, slope_at_end(air, dt))));
        }
        return largest;
    }
    /// Residual of the error estimate of a first step [J].
    [[nodiscard]] std::vector<double> first_error(double dt, const std::array<const HeatBalance*, 3>& stages) const
    {
        std::vector<double> result(air_.size(), 0.0);
        for (std::size_t k = 0; k < air_.size(); ++k)
            for (std::size_t i = 0; i < stages.size(); ++i)
                result[k] += dt * error_weights[i] * stages[i]->air[k].kept();
        return result;
    }
    /// Ends a step; returns the heat stored in it [J].
    double accept(double dt)
    {
        double stored = 0;
        for (std::size_t k = 0; k < air_.size(); ++k) {
            auto& air = air_[k];
            stored += (*enclosures_)[k].capacity * (air.state.now - air.state.start);
            air.state.slope = slope_at_end(air, dt);
            air.state.start = air.state.now;
        }
        return stored;
    }

private:
    struct Air {
        Vector load;  ///< b
        AirState state;
        double conductance = 0;  ///< sum of b [W/K]
        double middle = 0;       ///< temperature after the first stage [K]
        double known = 0;        ///< of the stage being solved [J]
    };
    [[nodiscard]] double pivot(std::size_t k) const
    {
        const auto& enclosure = (*enclosures_)[k];
        return enclosure.capacity + factor_ * (air_[k].conductance + enclosure.exchange);
    }
    [[nodiscard]] static double slope_at_end(const Air& air, double dt)
    {
        return end_slope(air.state.start, air.middle, air.state.now, dt);
    }

    const std::vector<Enclosure>* enclosures_;
    const System* system_;
    std::vector<Air> air_;
    double factor_ = 0;
};

}  // namespace deadpoint::heat
