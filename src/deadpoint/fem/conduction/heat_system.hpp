#pragma once

#include "deadpoint/fem/algebra/petsc.hpp"
#include "deadpoint/fem/space/fields.hpp"
#include "deadpoint/heat/system.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct InterfaceLaw;
struct Material;
}  // namespace deadpoint

/// Internal to fem/: the temperatures of a machine as a system of heat/.
namespace deadpoint::fem {

class Discretisation;
class HeatFunctionals;
class HeatMatrices;
class StageMatrix;

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
    ~HeatSystem();
    HeatSystem(const HeatSystem&) = delete;

    /// Adopts another problem if matrices and functionals can be used for it. Coefficients of
    /// joints and convection may differ.
    bool adopt(const HeatProblem& problem);
    void observe_with(Observation observation);
    [[nodiscard]] const Discretisation& space() const { return space_; }
    [[nodiscard]] StageMatrix& stage();
    /// How often cells have been integrated.
    [[nodiscard]] int integrations() const;
    [[nodiscard]] HeatMatrices& matrices();
    [[nodiscard]] const HeatFunctionals& functionals() const;
    [[nodiscard]] const std::vector<std::uint32_t>& part_of_unknown() const;

    // a vector space
    [[nodiscard]] OwnedVec make_vector() const;
    void copy(const OwnedVec& from, OwnedVec& to) const;
    void combine(const std::vector<heat::Scaled<OwnedVec>>& sum, OwnedVec& result) const;
    void add(double factor, const OwnedVec& term, OwnedVec& sum) const;
    [[nodiscard]] double total(const OwnedVec& vector) const;
    [[nodiscard]] double dot(const OwnedVec& a, const OwnedVec& b) const;
    [[nodiscard]] double largest(const OwnedVec& vector) const;
    [[nodiscard]] bool is_finite(const OwnedVec& vector) const;
    [[nodiscard]] bool any(bool flag) const;

    // functionals
    [[nodiscard]] const heat::HeatGeometry& geometry() const;
    [[nodiscard]] std::vector<double> evaluate(std::span<const std::size_t> which, const OwnedVec& vector) const;
    void add_loads(const std::vector<double>& watts, OwnedVec& vector) const;
    [[nodiscard]] std::vector<double> observe(const OwnedVec& vector, const OwnedVec& temperature, bool is_slope) const;
    void widen(const OwnedVec& temperature, std::vector<double>& lowest, std::vector<double>& highest) const;

    // terms
    void set_laws(const std::vector<InterfaceLaw>& laws, const std::vector<heat::Loads>& source_loads);
    [[nodiscard]] bool follows_temperature() const;
    [[nodiscard]] bool is_linear() const;
    void store(const OwnedVec& temperature, OwnedVec& stored) const;
    void conduct(const OwnedVec& temperature, OwnedVec& conducted) const;
    void apply_stage(const OwnedVec& in, OwnedVec& out) const;
    [[nodiscard]] double stored_between(const OwnedVec& from, const OwnedVec& to) const;

    // convection coefficients that depend on temperature
    [[nodiscard]] heat::FilmHeat add_films(const std::vector<heat::FilmAt>& films, const OwnedVec& temperature,
                                           OwnedVec& watts) const;
    void add_film_slopes(const std::vector<heat::FilmAt>& films, const OwnedVec& temperature, OwnedVec& load) const;
    void finish_load(OwnedVec& load) const;

    // prescribed temperatures
    [[nodiscard]] bool some_prescribed() const;
    void impose(double time, OwnedVec& temperature) const;
    void clear_prescribed(OwnedVec& vector) const;
    [[nodiscard]] double total_prescribed(const OwnedVec& vector) const;

    // the system of a stage
    bool build(double factor, const OwnedVec& temperature, const std::vector<heat::FilmAt>& films);
    int solve(const OwnedVec& right, OwnedVec& solution, const heat::LowRank<OwnedVec>& low_rank,
              heat::SolveTolerance tolerance, const std::string& what);
    [[nodiscard]] std::vector<heat::Term> terms() const;

    // the adjoint of the steps
    void begin_adjoint();
    void set_film_coefficients(const std::vector<double>& coefficients);
    void apply_mass(const OwnedVec& in, OwnedVec& out) const;
    void apply_stiffness(const OwnedVec& in, OwnedVec& out) const;
    /// @param tolerance  as a share of the solution's norm; 0: as sharp as the steps
    int solve_adjoint(double factor, const OwnedVec& right, OwnedVec& solution, double tolerance = 0);
    [[nodiscard]] std::vector<double> prescribed_shares(const OwnedVec& right, const OwnedVec& left, double time,
                                                        double reference) const;
    [[nodiscard]] std::vector<double> start_shares(const OwnedVec& weights, const OwnedVec& start,
                                                   double reference) const;

private:
    struct Parts;  ///< functionals, matrices and solvers

    const Discretisation& space_;
    const std::vector<Material>& materials_;
    const HeatProblem* problem_;
    Observation observation_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace deadpoint::fem
