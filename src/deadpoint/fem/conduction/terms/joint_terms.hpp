#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/fem/conduction/terms/sparse_term.hpp"

#include <vector>

namespace deadpoint {

struct Contact;
struct HeatProblem;
struct InterfaceLaw;
}  // namespace deadpoint

/// Internal to fem/: contributions of joints and convection to the conduction matrix, term by term.
namespace deadpoint::fem {

/// The contact layer of an interface conducts  c_aa J_aa + c_bb J_bb + c_ab J_ab  with coefficients
/// of its law and integrals J of its two sides:
///   c_aa = h_a (S - h_a) / S,   c_bb = h_b (S - h_b) / S,   c_ab = -h_a h_b / S,   S = h_a + h_b + g.
/// J_ab couples opposite points, or, where a joint turns fully, the means of both sides around the circumference, strip
/// by strip along the axis: sum over strips and modes m of moment_a moment_b^T / norm, with the modes 1 and z.
struct JointTerm {
    SparseTerm aa, bb;
    SparseTerm across;   ///< J_ab and its transpose of opposite points
    SparseTerm turning;  ///< of means around the circumference
};

struct JointCoefficients {
    double aa = 0, bb = 0, across = 0, turning = 0;
    bool operator==(const JointCoefficients&) const = default;
};
JointCoefficients coefficients_of(const InterfaceLaw& law);

class JointTerms {
public:
    /// Integrates the terms that the laws of all segments need.
    JointTerms(const Discretisation& space, const HeatProblem& problem);

    /// Adds the places of all entries.
    void add_couplings(Couplings& couplings) const;
    /// True if the terms can be used for these laws; false if a joint turns that did not turn when
    /// they were integrated.
    [[nodiscard]] bool serve(const std::vector<InterfaceLaw>& laws) const;
    void add_to(Mat stiffness, const std::vector<JointCoefficients>& coefficients) const;
    /// Per interface.
    [[nodiscard]] const std::vector<JointTerm>& terms() const { return terms_; }

private:
    /// Turning joints: per axial strip the moments of both sides' unknowns, (dof, zeroth, first).
    struct Strip {
        std::vector<std::pair<PetscInt, std::array<double, 2>>> a, b;
        std::array<double, 2> norm{};
    };
    [[nodiscard]] std::vector<Strip> strips_of(const Contact& contact) const;
    void integrate(std::size_t interface, bool across);
    void integrate_turning(std::size_t interface);

    const Discretisation& space_;
    std::vector<JointTerm> terms_;
    std::vector<bool> across_;                ///< per interface: integrated
    std::vector<std::vector<Strip>> strips_;  ///< per interface; none where it does not turn
};

/// F_f of each surface with a constant convection coefficient: integral of N N^T; empty for all
/// others.
std::vector<SparseTerm> film_terms(const Discretisation& space, const HeatProblem& problem);

}  // namespace deadpoint::fem
