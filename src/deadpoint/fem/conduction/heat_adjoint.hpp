#pragma once

#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/fem/conduction/heat_solver.hpp"

/// Internal to fem/: which heat has moved a functional of the temperature field.
namespace deadpoint::fem {

/// Runs the discrete adjoint of the time steps backward over the steps of a finished run.
///
/// With t = T - T_reference and the scalars of each step as booked, a step of length dt is linear, d = diagonal dt:
///
///     (M + d K_m) t_m = M t_0 + d (f_0 - K_0 t_0) + d f_m
///     (M + d K_1) t_1 = M (bdf_middle t_m - bdf_now t_0) + d f_1
///
/// K_0, K_m and K_1 differ only in films that follow the temperature: each takes the mean coefficient of its surface at
/// that stage. Materials that follow it have their constants, enclosed air its temperature as booked. For weights l_1
/// on t_1 the transposed step gives those on its loads, d y_2 on f_1 and d y_1 on f_m and f_0, and those on t_0:
///
///     (M + d K_1) y_2 = l_1
///     (M + d K_m) y_1 = bdf_middle M y_2
///     l_0 = M y_1 - d K_0 y_1 - bdf_now M y_2
///
/// Prescribed unknowns have no equation: y is 0 there, and what stands against their temperature is the rest of the
/// right side, l_1 - (M + d K_1) y_2 and bdf_middle M y_2 - (M + d K_m) y_1.
///
/// It uses up the vectors of the solver: take its state() before.
class HeatAdjoint {
public:
    explicit HeatAdjoint(HeatSolver& solver);

    /// @param weights  of the functional: value = sum of weight (T - T_reference), by owned unknown
    /// @param row      of the run's history: the time of the functional
    HeatCauses causes(const std::vector<double>& weights, std::size_t row);
    [[nodiscard]] int iterations() const { return iterations_; }

private:
    void enter(std::size_t segment);
    void step_back(const StepRecord& step);
    void use_films(const StageRecord& stage);
    [[nodiscard]] bool radiates_inside(std::size_t film) const;
    [[nodiscard]] double surroundings(std::size_t film, const StageRecord& stage) const;
    [[nodiscard]] double mean_coefficient(std::size_t film, const StageRecord& stage) const;
    void apply_stiffness(Vec in, Vec out);
    void solve_stage(double factor, const StageRecord& stage, Vec weights, Vec solution);
    void add_prescribed(Vec weights, double time);
    void add_loads(Vec solution, double factor, const std::vector<const StageRecord*>& stages);
    void add_load(const std::vector<double>& products, double factor, const StageRecord& stage);
    void add_start(Vec weights);

    HeatSolver& solver_;
    const HeatProblem& problem_;
    HeatCauses causes_;
    std::vector<double> film_coefficients_;  ///< in HeatSolver::variable_, per film
    Vec weights_, solution_, middle_weights_, middle_solution_, change_, mass_product_, stiffness_product_;
    double change_over_ = 0;  ///< length of the step that change_ belongs to; 0: none [s]
    int iterations_ = 0;
};

}  // namespace deadpoint::fem
