#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/heat/films.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/heat/system.hpp"
#include "deadpoint/reduce/online/dense_terms.hpp"

#include <Eigen/Dense>
#include <map>
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
/// materials over temperature. A convection law is evaluated at its surface's mean temperature T_m, with its tangent
/// there:
///   q(T) = q(T_m) + q'(T_m) (T - T_m),
/// so that the heat of the surface is that of the mean temperature. Factors of 1 + d K are kept per
/// d; terms of low rank are solved by Woodbury's formula.
class DenseSystem {
public:
    using Vector = Eigen::VectorXd;

    /// @param reference  temperature at which observed functionals are zero [K]
    /// @throws InputError if the terms do not fit the problem or each other (see conserve_heat()), or the problem
    ///         prescribes a temperature
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
    void conduct(const Vector& temperature, Vector& out) const { out.noalias() = stiffness_ * temperature; }
    void apply_stage(const Vector& in, Vector& out) const { out.noalias() = stage_ * in; }
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

    // the adjoint of the steps
    void begin_adjoint();
    void set_film_coefficients(const std::vector<double>& coefficients);
    void apply_mass(const Vector& in, Vector& out) const { out = in; }
    void apply_stiffness(const Vector& in, Vector& out) const { out.noalias() = stiffness_ * in + films_ * in; }
    int solve_adjoint(double factor, const Vector& right, Vector& solution);
    [[nodiscard]] std::vector<double> prescribed_shares(const Vector&, const Vector&, double, double) const
    {
        return std::vector<double>(problem_->surfaces.size(), 0.0);
    }
    [[nodiscard]] std::vector<double> start_shares(const Vector& weights, const Vector& start, double reference) const;

private:
    /// Of 1 + factor (K + films), and the products of the sources' loads for Woodbury's formula.
    struct Factored {
        Eigen::LLT<Eigen::MatrixXd> matrix;
        Eigen::MatrixXd solved_loads;  ///< A^-1 L
        Eigen::MatrixXd products;      ///< L^T A^-1 L
    };
    [[nodiscard]] const Factored& factored(double factor);
    [[nodiscard]] double mean(std::size_t surface, const Vector& temperature) const;
    [[nodiscard]] std::vector<double> irradiation(const Vector& temperature) const;
    [[nodiscard]] Eigen::MatrixXd stage_of(double factor) const;
    void forget_factors();

    DenseTerms terms_;
    const HeatProblem* problem_;
    double reference_;
    bool follows_;
    Eigen::MatrixXd stiffness_, films_, stage_, loads_;  ///< loads_: a column per source
    double factor_ = -1;
    std::map<double, Factored> factors_;  ///< by factor
};

}  // namespace deadpoint::reduce
