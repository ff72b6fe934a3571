#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace deadpoint {
struct Machine;
}
namespace deadpoint::casefile {
struct Case;
}

/// Histories of probes, joints, parts and media over the steps of a run, by name.
namespace deadpoint::press {

template <class History>
struct Named {
    std::string name;
    History history;
};

/// Both sides of an interface of a joint, or of a bond with a conductance.
struct InterfaceHistory {
    Series a;  ///< mean temperature of side a [K]
    Series b;
};

struct JointHistory {
    Series temperature;        ///< area mean of both sides of its interfaces [K]
    std::vector<double> heat;  ///< friction heat, whole press [W]
};

struct PartHistory {
    Series mean;         ///< volume mean of the temperature [K]
    double lowest = 0;   ///< of its nodes over the run [K]
    double highest = 0;  ///< [K]
};

/// A friction law and the interfaces it heats.
struct SourceHistory {
    std::vector<double> heat;         ///< in the model [W]
    std::vector<double> temperature;  ///< mean of its films [K]
};

/// Values at ThermalHistory::time. Heat is that of the model (half of the press in a half model),
/// except for joints.
struct Histories {
    std::vector<Named<Series>> probes;                ///< [K]
    std::vector<Named<InterfaceHistory>> interfaces;  ///< "joint.interface", then bonds as "part|part"
    std::vector<Named<std::vector<double>>> bonds;    ///< heat from the first part to the second, of those bonds [W]
    std::vector<Named<JointHistory>> joints;          ///< those with an interface
    std::vector<Named<PartHistory>> parts;
    std::vector<Named<SourceHistory>> sources;
    std::vector<Named<std::vector<double>>> body_heat;  ///< of motors and the like [W]
    std::vector<Named<OilHistory>> oil;                 ///< circuits
    std::vector<Named<EnclosureHistory>> enclosures;
};

/// Names the lists of a history by its problem.
/// @param whole  factor from the model to the whole press
Histories name_histories(const casefile::Case& input, const Machine& machine, const HeatProblem& problem,
                         const ThermalHistory& history, double symmetry_factor);

/// The history of that name, or null.
template <class History>
const History* find(const std::vector<Named<History>>& list, std::string_view name)
{
    for (const auto& entry : list)
        if (entry.name == name)
            return &entry.history;
    return nullptr;
}

template <class History>
std::vector<std::string> names_of(const std::vector<Named<History>>& list)
{
    std::vector<std::string> names;
    for (const auto& entry : list)
        names.push_back(entry.name);
    return names;
}

}  // namespace deadpoint::press
