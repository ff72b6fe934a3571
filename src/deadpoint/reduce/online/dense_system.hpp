#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"
#include "deadpoint/reduce/online/shifted_solver.hpp"

#include <Eigen/Dense>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct InterfaceLaw;
}  // namespace deadpoint

/// Internal to reduce/, since it shows Eigen: a small system of temperatures with dense matrices.
namespace deadpoint::reduce {

/// The system of heat/system.hpp on the terms of reduce/online/dense_terms. It has no prescribed temperatures and no
/// materials over temperature.
///
/// A film that follows the temperature is evaluated at its surface's mean temperature T_m with its tangent there, and
/// with the variance of the temperature over the surface:
///   q(T) = q(T_m) + q'(T_m) (T - T_m) + q''(T_m) / 2 var,   var = mean of (T - T_m)^2.
/// So the heat of the surface is right to third order in T - T_m. For radiation q'' is exact. For convection
///   q''(T_m) var = q(T_m + s) + q(T_m - s) - 2 q(T_m),   s^2 = var,
/// which is right to the same order, and holds where a law bends sharply, as natural convection at the air's
/// temperature.
///
/// The matrix of a stage holds slopes q' of an earlier time where they differ little: it is reduced to tridiagonal form
/// anew only if Newton's method would converge too slowly with them. The balance always has the present slopes.
class DenseSystem {
public:
    using Vector = Eigen::VectorXd;

    /// @param terms  shared by any number of systems
    /// @param reference  temperature at which observed functionals are zero [K]
    /// @throws InputError if the terms do not fit the problem, or the problem prescribes a temperature
    DenseSystem(std::shared_ptr<const PreparedTerms> terms, const HeatProblem& problem, double reference = 0);
    /// @throws InputError as PreparedTerms also
    DenseSystem(DenseTerms terms, const HeatProblem& problem, double reference = 0);
    DenseSystem(const DenseSystem&) = delete;

    /// As given, after conserve_heat().
    [[nodiscard]] const DenseTerms& parts() const { return terms_; }

    // a vector space
    [[nodiscard]] Vector make_vector() const { return Vector::Zero(terms_.uniform.size()); }
    void copy(const Vector& from, Vector& to) const { to = from; }
    void combine(const std::vector<heat::Scaled<Vector>>& sum, Vector& result) const;
    void add(double factor, const Vector& term, Vector& sum) const { sum += factor * term; }
    [[nodiscard]] double total(const Vector& vector) const { return vector.dot(terms_.uniform); }
    [[nodiscard]] double dot(const Vector& a, const Vector& b) const { return a.dot(b); }
    [[nodiscard]] double largest(const Vector& vector) const;  ///< of the means of joints, parts, surfaces, and probes
    [[nodiscard]] bool is_finite(const Vector& vector) const { return vector.allFinite(); }
    [[nodiscard]] bool any(bool flag) const { return flag; }

    // functionals
    [[nodiscard]] const heat::HeatGeometry& geometry() const { return terms_.geometry; }
    [[nodiscard]] std::vector<double> evaluate(std::span<const std::size_t> which, const Vector& vector) const;
    void add_loads(const std::vector<double>& watts, Vector& vector) const;
    [[nodiscard]] std::vector<double> observe(const Vector& vector, const Vector& temperature, bool is_slope) const;
    void widen(const Vector& temperature, std::vector<double>& lowest, std::vector<double>& highest) const;

    // terms
    void set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads);
    [[nodiscard]] bool follows_temperature() const { return follows_; }
    [[nodiscard]] bool is_linear() const { return !follows_; }
    void store(const Vector& temperature, Vector& stored) const { stored = temperature; }
    void conduct(const Vector& temperature, Vector& out) const { out = conduction_->matrix().times(temperature); }
    void apply_stage(const Vector& in, Vector& out) const { out = in + factor_ * conduction_->matrix().times(in); }
    [[nodiscard]] double stored_between(const Vector& from, const Vector& to) const
    {
        return terms_.uniform.dot(to - from);
    }

    // convection coefficients that depend on temperature
    [[nodiscard]] heat::FilmHeat add_films(const std::vector<heat::FilmAt>& films, const Vector& temperature,
                                           Vector& watts) const;
    void add_film_slopes(const std::vector<heat::FilmAt>& films, const Vector& temperature, Vector& load) const;
    void finish_load(Vector&) const {}

    // prescribed temperatures: none
    [[nodiscard]] bool some_prescribed() const { return false; }
    void impose(double, Vector&) const {}
    void clear_prescribed(Vector&) const {}
    [[nodiscard]] double total_prescribed(const Vector&) const { return 0; }

    // the system of a stage
    bool build(double factor, const Vector& temperature, const std::vector<heat::FilmAt>& films);
    int solve(const Vector& right, Vector& solution, const heat::LowRank<Vector>& low_rank, heat::SolveTolerance,
              const std::string& what);
    [[nodiscard]] std::vector<heat::Term> terms() const { return {}; }
    /// Form of K in the last build(); null if a film follows the temperature.
    [[nodiscard]] std::shared_ptr<const TridiagonalForm> tridiagonal() const
    {
        return follows_ ? nullptr : conduction_->form();
    }

    // the adjoint of the steps
    void begin_adjoint();
    void set_film_coefficients(const std::vector<double>& coefficients);
    void apply_mass(const Vector& in, Vector& out) const { out = in; }
    void apply_stiffness(const Vector& in, Vector& out) const { out = of_adjoint().times(in); }
    int solve_adjoint(double factor, const Vector& right, Vector& solution, double tolerance = 0);
    [[nodiscard]] std::vector<double> prescribed_shares(const Vector&, const Vector&, double, double) const
    {
        return std::vector<double>(problem_->surfaces.size(), 0.0);
    }
    [[nodiscard]] std::vector<double> start_shares(const Vector& weights, const Vector& start, double reference) const;

private:
    using Row = Eigen::Index;
    [[nodiscard]] Row surface_row(std::size_t surface) const;
    void multiply_functionals(Row first, Row count, const Vector& vector, double* values) const;
    void add_functionals(Row first, Row count, const double* weights, Vector& sum) const;
    void clear_adjoint();
    /// Rows of PreparedTerms::deviations of the films that follow the temperature.
    struct Run {
        Row first = 0, count = 0;
    };
    [[nodiscard]] Vector deviations(const Vector& temperature) const;
    [[nodiscard]] Vector surface_means(const Vector& temperature) const;
    [[nodiscard]] std::vector<double> variances(const Vector& deviations) const;
    [[nodiscard]] std::vector<double> irradiation(const Vector& means, const std::vector<double>& variances) const;
    [[nodiscard]] SymmetricMatrix with_slopes(const std::vector<double>& slopes) const;
    [[nodiscard]] bool reduced_slopes_serve(double factor) const;
    void reduce();
    [[nodiscard]] const SymmetricMatrix& of_adjoint() const;

    std::shared_ptr<const PreparedTerms> prepared_;
    const DenseTerms& terms_;
    const HeatProblem* problem_;
    double reference_;
    bool follows_ = false;
    std::shared_ptr<const Conduction> conduction_;  ///< K without films that follow the temperature
    SymmetricMatrix with_films_;                    ///< K with their coefficients, for the adjoint
    std::vector<Run> runs_;
    Eigen::MatrixXd loads_;               ///< a column per source
    std::vector<std::size_t> following_;  ///< surfaces whose films follow the temperature
    std::vector<double> slopes_;          ///< of the last build(), per surface [W/m2/K]
    std::vector<double> reduced_slopes_;  ///< those in the matrix of the solver
    bool reduced_ = false;                ///< the solver has the present matrix
    double factor_ = -1;
    ShiftedSolver solver_;
    std::map<double, Eigen::LLT<Eigen::MatrixXd>> adjoint_;  ///< of the films' present coefficients, by factor
    std::map<double, ShiftedFactor> adjoint_factors_;        ///< the same where no film follows the temperature
};

}  // namespace deadpoint::reduce
