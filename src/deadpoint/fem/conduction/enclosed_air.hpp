#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/conduction/heat_rate.hpp"

#include <array>
#include <vector>

/// Internal to fem/: the air of enclosures, one unknown T_e each beside the field of temperatures.
///
/// With the slopes b_i [W/K] of its films by its temperature and f = d dt, a stage of TR-BDF2 solves
///   [ A       -f b              ] [ change of T   ]     [ R   ]
///   [ -f b^T   C + f (sum b + G) ] [ change of T_e ] = - [ R_e ]
/// T_e is taken out: A - f^2 b b^T / c_e stays positive definite, c_e = C + f (sum b + G).
namespace deadpoint::fem {

/// The air of one enclosure between two steps.
struct AirState {
    double start = 0;  ///< temperature [K]
    double slope = 0;  ///< [K/s]
    double now = 0;    ///< as last iterated [K]
};

class EnclosedAir {
public:
    /// @param pattern  a vector of the field's layout
    EnclosedAir(const std::vector<Enclosure>& enclosures, Vec pattern);
    /// Takes like enclosures over.
    void adopt(const std::vector<Enclosure>& enclosures) { enclosures_ = &enclosures; }
    void start_from(const std::vector<double>& temperature);
    /// Between two steps.
    [[nodiscard]] std::vector<AirState> between_steps() const;
    void go_on_from(const std::vector<AirState>& states);

    [[nodiscard]] std::size_t count() const { return air_.size(); }
    /// As last iterated [K].
    [[nodiscard]] double temperature(std::size_t enclosure) const { return air_[enclosure].now; }
    /// At the start of the step [K].
    [[nodiscard]] std::vector<double> at_start() const;
    /// b, to be filled by unknown; then set_factor() completes it.
    [[nodiscard]] Vec load(std::size_t enclosure) const { return air_[enclosure].load; }
    /// @param held  this rank's unknowns of prescribed temperature, from its first
    void set_factor(double factor, const std::vector<PetscInt>& held);
    /// The rank-one terms of the system: out -= f^2 b (b . in) / c_e.
    void multiply(Vec in, Vec out) const;

    void begin_first_stage(double dt, bool slope_known, const HeatRate& at_start);
    void begin_second_stage();
    [[nodiscard]] std::vector<double> residual(const HeatRate& rate) const;
    /// Brings a residual of the air into that of the field.
    void take_out(const std::vector<double>& residual, Vec field_residual) const;
    /// Solution for the residual, its field part being `solution` [K].
    [[nodiscard]] std::vector<double> solution(const std::vector<double>& residual, Vec solution) const;
    /// Subtracts that; returns the largest change [K].
    double move(const std::vector<double>& residual, Vec solution);

    /// Largest error of the step by its slopes, as HeatSolver::estimate_error [K].
    [[nodiscard]] double error(double dt) const;
    /// Residual of the error estimate of a first step.
    [[nodiscard]] std::vector<double> first_error(double dt, const std::array<const HeatRate*, 3>& rates) const;
    /// Ends a step; returns the heat stored in it [J].
    double accept(double dt);

private:
    struct Air {
        OwnedVec load;                 ///< b
        double conductance = 0;        ///< sum of b [W/K]
        double start = 0, middle = 0;  ///< temperature at the start of the step and after its first stage [K]
        double slope = 0;              ///< at the start [K/s]
        double now = 0;                ///< as last iterated [K]
        double known = 0;              ///< of the stage being solved [J]
    };
    [[nodiscard]] double pivot(std::size_t enclosure) const;
    [[nodiscard]] static double slope_at_end(const Air& air, double dt);

    const std::vector<Enclosure>* enclosures_;
    std::vector<Air> air_;
    double factor_ = 0;
};

}  // namespace deadpoint::fem
