#pragma once

#include <functional>
#include <string>
#include <vector>

/// Fields of a machine, and functionals of them, as other stages hold them.
namespace deadpoint::fem {

/// This rank's share of a temperature field [K], opaque to other stages.
struct Field {
    std::vector<double> owned;
};
/// State from which a later run can continue.
struct ThermalState {
    Field temperature;
    std::vector<double> sumps;       ///< temperature of each oil circuit's sump [K]
    std::vector<double> enclosures;  ///< temperature of each enclosure's air [K]
};
/// This rank's share of a displacement field, on the mesh of the deformation [m].
struct Displacement {
    std::vector<double> owned;
};
/// A functional of the deformation as weights on the temperature field: value = sum of weight (T -
/// T_reference), or if a material's expansion depends on temperature, of weight times the rise of
/// Model::expansion_rise().
struct Adjoint {
    std::string name;
    std::vector<double> owned;
};

/// Which of the adjoints passed to Model::heat() are split by part: `count` from `first` on, or
/// none (-1).
struct Attribution {
    constexpr Attribution(int first_adjoint, int adjoints = 1)
        : first(first_adjoint), count(first_adjoint < 0 ? 0 : adjoints)
    {}
    int first;
    int count;
};

/// Values at nodes of the mesh for a field file; nodes without any hold not-a-number.
struct PointData {
    std::string name;
    int components = 1;
    std::vector<float> values;  ///< components times Machine::nodes
};

/// Called after each accepted step.
using StepCallback = std::function<void(double time)>;
/// Called for each wanted field time, in order.
using FieldCallback = std::function<void(double time, const Field&)>;

struct ModelSize {
    long long cells = 0;
    long long heat_unknowns = 0;
    long long deformation_cells = 0;
    long long deformation_unknowns = 0;
};

}  // namespace deadpoint::fem
