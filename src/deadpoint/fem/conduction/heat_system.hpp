#pragma once

#include "deadpoint/exchange/material.hpp"
#include "deadpoint/fem/conduction/stage_matrix.hpp"
#include "deadpoint/fem/elastic/expansion.hpp"
#include "deadpoint/fem/fields.hpp"
#include "deadpoint/fem/space/vectors.hpp"
#include "deadpoint/heat/adjoint.hpp"

#include <string>
#include <vector>

/// Internal to fem/: the temperatures of a machine as a system of heat/.
namespace deadpoint::fem {

/// Values that a run records besides the functionals of the heat balance: functionals of the
/// deformation.
struct Observation {
    const std::vector<Adjoint>* adjoints = nullptr;
    double reference = 0;  ///< temperature without deformation [K]
    Attribution attribution{-1};
};

/// The system of heat/system.hpp on finite elements, with vectors and matrices of PETSc. Every member is collective.
class HeatSystem {
public:
    using Vector = OwnedVec;

    HeatSystem(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem);
    HeatSystem(const HeatSystem&) = delete;

    /// Adopts another problem if matrices and functionals can be used for it. Coefficients of
    /// joints and convection may differ.
    bool adopt(const HeatProblem& problem);
    void observe_with(Observation observation) { observation_ = observation; }
    [[nodiscard]] const Discretisation& space() const { return space_; }
    [[nodiscard]] StageMatrix& stage() { return stage_; }
    /// How often cells have been integrated.
    [[nodiscard]] int integrations() const { return matrices_.integrations(); }

    // a vector space
    [[nodiscard]] OwnedVec make_vector() const;
    void copy(const OwnedVec& from, OwnedVec& to) const { DEADPOINT_PETSC(VecCopy(from, to)); }
    void combine(const std::vector<heat::Scaled<OwnedVec>>& sum, OwnedVec& result) const;
    void add(double factor, const OwnedVec& term, OwnedVec& sum) const { DEADPOINT_PETSC(VecAXPY(sum, factor, term)); }
    [[nodiscard]] double total(const OwnedVec& vector) const;
    [[nodiscard]] double dot(const OwnedVec& a, const OwnedVec& b) const;
    [[nodiscard]] double largest(const OwnedVec& vector) const;
    [[nodiscard]] bool is_finite(const OwnedVec& vector) const;
    [[nodiscard]] bool any(bool flag) const;

    // functionals
    [[nodiscard]] const heat::HeatGeometry& geometry() const { return functionals_.geometry(); }
    [[nodiscard]] std::vector<double> evaluate(std::span<const std::size_t> which, const OwnedVec& vector) const
    {
        return functionals_.evaluate(which, vector);
    }
    void add_loads(const std::vector<double>& watts, OwnedVec& vector) const { functionals_.add_loads(watts, vector); }
    [[nodiscard]] std::vector<double> observe(const OwnedVec& vector, const OwnedVec& temperature, bool is_slope) const;
    void widen(const OwnedVec& temperature, std::vector<double>& lowest, std::vector<double>& highest) const;

    // terms
    void set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads);
    [[nodiscard]] bool follows_temperature() const { return films_.some() || maps_.vary(); }
    [[nodiscard]] bool is_linear() const { return !follows_temperature() && !prescribed_.some(); }
    void store(const OwnedVec& temperature, OwnedVec& stored) const { maps_.store(temperature, stored); }
    void conduct(const OwnedVec& temperature, OwnedVec& conducted) const { maps_.conduct(temperature, conducted); }
    void apply_stage(const OwnedVec& in, OwnedVec& out) const { DEADPOINT_PETSC(MatMult(stage_.assembled(), in, out)); }
    [[nodiscard]] double stored_between(const OwnedVec& from, const OwnedVec& to) const
    {
        return maps_.stored_between(from, to);
    }

    // convection coefficients that depend on temperature
    [[nodiscard]] heat::FilmHeat add_films(const std::vector<heat::FilmAt>& films, const OwnedVec& temperature,
                                           OwnedVec& watts) const
    {
        return films_.add_heat(films, temperature, watts);
    }
    void add_film_slopes(const std::vector<heat::FilmAt>& films, const OwnedVec& temperature, OwnedVec& load) const
    {
        films_.add_slopes(films, temperature, load);
    }
    void finish_load(OwnedVec& load) const;

    // prescribed temperatures
    [[nodiscard]] bool some_prescribed() const { return prescribed_.some(); }
    void impose(double time, OwnedVec& temperature) const { prescribed_.impose(time, temperature); }
    void clear_prescribed(OwnedVec& vector) const { prescribed_.clear(vector); }
    [[nodiscard]] double total_prescribed(const OwnedVec& vector) const { return prescribed_.total(vector); }

    // the system of a stage
    bool build(double factor, const OwnedVec& temperature, const std::vector<heat::FilmAt>& films);
    int solve(const OwnedVec& right, OwnedVec& solution, const heat::LowRank<OwnedVec>& low_rank,
              heat::SolveTolerance tolerance, const std::string& what)
    {
        return stage_.solve(right, solution, low_rank, tolerance, what.c_str());
    }
    [[nodiscard]] std::vector<heat::Term> terms() const;

    // the adjoint of the steps
    void begin_adjoint();
    void set_film_coefficients(const std::vector<double>& coefficients);
    void apply_mass(const OwnedVec& in, OwnedVec& out) const { DEADPOINT_PETSC(MatMult(matrices_.mass(), in, out)); }
    void apply_stiffness(const OwnedVec& in, OwnedVec& out) const;
    int solve_adjoint(double factor, const OwnedVec& right, OwnedVec& solution);
    [[nodiscard]] std::vector<double> prescribed_shares(const OwnedVec& right, const OwnedVec& left, double time,
                                                        double reference) const
    {
        return prescribed_.shares(right, left, time, reference);
    }
    [[nodiscard]] std::vector<double> start_shares(const OwnedVec& weights, const OwnedVec& start,
                                                   double reference) const
    {
        return prescribed_.start_shares(weights, start, reference);
    }

private:
    [[nodiscard]] SparseFunctional combined(const heat::Loads& loads) const;

    const Discretisation& space_;
    const std::vector<Material>& materials_;
    const HeatProblem* problem_;
    Expansion expansion_;
    HeatFunctionals functionals_;
    HeatMatrices matrices_;
    PrescribedTemperatures prescribed_;
    OwnedVec pattern_;
    MaterialMaps maps_;
    FilmPoints films_;
    StageMatrix stage_;
    Observation observation_;
};

}  // namespace deadpoint::fem
