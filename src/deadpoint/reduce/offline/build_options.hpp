#pragma once

#include "deadpoint/reduce/certificate/residual_cut.hpp"

#include <cstddef>

namespace deadpoint::reduce {

/// Largest error of a term that is projected to low rank, of its largest eigenvalue over the states.
struct Truncation {
    double joints = 1e-6;  ///< conduction between the sides of a joint, whose coefficients are large
    double others = 1e-4;  ///< films, and conduction from a joint's sides to its oil
};

/// A direction of a term is left out of a model if it takes at most this share of all heat from typical states.
struct LeastHeat {
    double of_large = 1e-9;
    double of_small = 1e-7;
};

/// How a reduced model is built. The numbers are those of a study on the shipped press (docs/reduced.md).
struct BuildOptions {
    int sets = 100;                    ///< of coefficients that a basis field is solved for
    int loads_per_set = 13;            ///< fields per set, besides that of E_SW
    double least = 2e-6;               ///< fields whose new share is smaller are dropped
    std::size_t largest_basis = 1000;  ///< number of states of the large model
    double dual_weight = 100;          ///< of fields of E_SW where those of the large model are chosen
    double slow_weight = 0.2;          ///< power of 1/shift in the same weights
    int training_runs = 250;           ///< of the large model
    int runs_per_dual = 3;             ///< dual states are those of one of so many training runs
    double early_share = 0.01;         ///< weight of states in the first minute of a segment
    double readings = 0.1;             ///< weight of sides and probes in the norm of errors, see error_norm()
    double dual_share = 1.3e-2;        ///< weight of the dual states
    double probe_duals = 0.3;          ///< of those of all probes, with those of E_SW as 1
    std::size_t dual_row = 0;          ///< of the observed functionals: E_SW
    bool has_dual = false;             ///< false: there is no such functional
    int test_runs = 12;                ///< with coefficients that no training run had
    std::size_t largest = 300;         ///< number of states of the small model
    double temperature = 0.1;          ///< wanted error of the small model against the large one [K]
    double gap = 5e-8;                 ///< the same of E_SW [m]
    std::size_t adjoints = 0;          ///< observed functionals; further rows split them by part
    double reference = 293.15;         ///< temperature without deformation [K]
    int threads = 1;
    bool certificate = false;  ///< makes ResidualTerms of the large model
    Truncation projection{};
    LeastHeat least_heat{};
    ResidualCut residual{};
};

}  // namespace deadpoint::reduce
