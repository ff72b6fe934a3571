#pragma once

#include "deadpoint/reduce/certificate/residual_terms.hpp"

#include <optional>

namespace deadpoint {
class Observer;
}

/// Internal to fem/: products of a residual's vectors in the inverse of a conduction matrix.
namespace deadpoint::fem {

class BasisFields;
class Discretisation;
class HeatSystem;

/// A machine on one rank and a basis of fields.
struct ProjectedMachine {
    const Discretisation& space;
    HeatSystem& system;
    const BasisFields& fields;
    const Eigen::MatrixXd& correction;  ///< combinations of the fields that are the basis
    const Eigen::MatrixXd& observed;    ///< the observed functionals, a column for each
};

/// ResidualTerms but for products and the coefficients of K', which is the present conduction matrix of the system.
/// Solves with a sparse factor of it. @return nothing after Observer::cancelled()
std::optional<reduce::ResidualTerms> residual_terms(const ProjectedMachine& machine, const reduce::ResidualTask& task,
                                                    Observer& observer);

}  // namespace deadpoint::fem
