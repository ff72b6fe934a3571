#include "deadpoint/press/result/histories.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/exchange/machine.hpp"

#include <utility>

namespace deadpoint::press {
namespace {

void divide(Series& series, double by)
{
    for (double& value : series.value)
        value /= by;
    for (double& rate : series.rate)
        rate /= by;
}

/// Weighted area of the interfaces that each source heats [m2].
std::vector<double> weighted_areas(const Machine& machine, const HeatProblem& problem)
{
    std::vector<double> area(problem.sources.size(), 0.0);
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i)
        if (const auto& law = problem.interfaces[i]; law.source >= 0)
            area[law.source] += law.heat_weight * machine.interfaces[i].area;
    return area;
}

/// Sums the interfaces of one joint after the other.
class JointSums {
public:
    JointSums(const Machine& machine, const HeatProblem& problem, const ThermalHistory& history, double symmetry_factor)
        : machine_(machine), problem_(problem), history_(history), symmetry_factor_(symmetry_factor),
          source_area_(weighted_areas(machine, problem))
    {}

    /// The joint with these interfaces. @return whether they have an area at all
    bool sum(std::size_t first, std::size_t count, JointHistory& joint) const
    {
        const std::vector<double> zeros(history_.time.size(), 0.0);
        joint = {{zeros, zeros}, zeros};
        double area = 0;
        for (std::size_t contact = first; contact < first + count; ++contact) {
            add_interface(contact, joint);
            area += machine_.interfaces[contact].area;
        }
        if (area > 0)
            divide(joint.temperature, area);
        return area > 0;
    }

private:
    void add_interface(std::size_t contact, JointHistory& joint) const
    {
        const double area = machine_.interfaces[contact].area;
        const auto& a = history_.interface_a[contact];
        const auto& b = history_.interface_b[contact];
        for (std::size_t i = 0; i < history_.time.size(); ++i) {
            joint.temperature.value[i] += 0.5 * area * (a.value[i] + b.value[i]);
            joint.temperature.rate[i] += 0.5 * area * (a.rate[i] + b.rate[i]);
        }
        const auto& law = problem_.interfaces[contact];
        if (law.source < 0)
            return;
        const auto& heat = history_.source_heat[law.source];
        for (std::size_t i = 0; i < heat.size(); ++i)
            joint.heat[i] += symmetry_factor_ * heat[i] * law.heat_weight * area / source_area_[law.source];
    }

    const Machine& machine_;
    const HeatProblem& problem_;
    const ThermalHistory& history_;
    double symmetry_factor_;
    std::vector<double> source_area_;
};

std::vector<Named<JointHistory>> joints_of(const casefile::Case& input, const JointSums& sums)
{
    std::vector<Named<JointHistory>> result;
    std::size_t contact = 0;
    for (const auto& [name, joint] : input.joints) {
        JointHistory history;
        if (sums.sum(contact, joint.interfaces.size(), history))
            result.push_back({name, std::move(history)});
        contact += joint.interfaces.size();
    }
    return result;
}

/// The entries of a list of the problem beside the values of a list of its history.
template <class Entry, class History>
std::vector<Named<History>> pair(const std::vector<Entry>& entries, const std::vector<History>& values)
{
    std::vector<Named<History>> result;
    for (std::size_t i = 0; i < entries.size(); ++i)
        result.push_back({entries[i].name, values.at(i)});
    return result;
}

std::vector<Named<PartHistory>> parts_of(const Machine& machine, const ThermalHistory& history)
{
    std::vector<Named<PartHistory>> result;
    for (std::size_t p = 0; p < machine.parts.size(); ++p)
        result.push_back(
            {machine.parts[p].name, {history.part_means.at(p), history.part_lowest.at(p), history.part_highest.at(p)}});
    return result;
}

std::vector<Named<InterfaceHistory>> interfaces_of(const Machine& machine, const ThermalHistory& history)
{
    std::vector<Named<InterfaceHistory>> result;
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i)
        result.push_back({machine.interfaces[i].name, {history.interface_a.at(i), history.interface_b.at(i)}});
    return result;
}

/// h A (mean T_a - mean T_b): exact, since the conductance is even over the bond.
std::vector<Named<std::vector<double>>> bonds_of(const casefile::Case& input, const Machine& machine,
                                                 const HeatProblem& problem, const ThermalHistory& history)
{
    std::size_t i = 0;
    for (const auto& [name, joint] : input.joints)
        i += joint.interfaces.size();
    std::vector<Named<std::vector<double>>> result;
    for (; i < machine.interfaces.size(); ++i) {
        const auto& law = problem.interfaces[i];
        const double conductance =
            machine.interfaces[i].area * law.film_a * law.film_b / (law.film_a + law.film_b);  // [W/K]
        std::vector<double> heat;
        for (std::size_t k = 0; k < history.time.size(); ++k)
            heat.push_back(conductance * (history.interface_a[i].value[k] - history.interface_b[i].value[k]));
        result.push_back({machine.interfaces[i].name, std::move(heat)});
    }
    return result;
}

std::vector<Named<SourceHistory>> sources_of(const HeatProblem& problem, const ThermalHistory& history)
{
    std::vector<Named<SourceHistory>> result;
    for (std::size_t i = 0; i < problem.sources.size(); ++i)
        result.push_back({problem.sources[i].name, {history.source_heat.at(i), history.source_temperature.at(i)}});
    return result;
}

}  // namespace

Histories name_histories(const casefile::Case& input, const Machine& machine, const HeatProblem& problem,
                         const ThermalHistory& history, double symmetry_factor)
{
    Histories result;
    result.probes = pair(problem.probes, history.probes);
    result.interfaces = interfaces_of(machine, history);
    result.bonds = bonds_of(input, machine, problem, history);
    result.joints = joints_of(input, JointSums(machine, problem, history, symmetry_factor));
    result.parts = parts_of(machine, history);
    result.sources = sources_of(problem, history);
    result.body_heat = pair(problem.body_heat, history.body_heat);
    result.oil = pair(problem.oil, history.oil);
    result.enclosures = pair(problem.enclosures, history.enclosures);
    return result;
}

}  // namespace deadpoint::press
