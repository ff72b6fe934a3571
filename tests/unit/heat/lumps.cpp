#include "lumps.hpp"

#include <cmath>
#include <string>

namespace lumps {

Eigen::VectorXd roots(const Machine& machine)
{
    return Eigen::Map<const Eigen::ArrayXd>(machine.capacity.data(), static_cast<Eigen::Index>(machine.capacity.size()))
        .sqrt();
}

Eigen::VectorXd states_of(const Machine& machine, const Eigen::VectorXd& temperatures)
{
    return roots(machine).cwiseProduct(temperatures);
}

Eigen::VectorXd temperatures_of(const Machine& machine, const Eigen::VectorXd& states)
{
    return states.cwiseQuotient(roots(machine));
}

Eigen::VectorXd loads_of(const Machine& machine, const Eigen::VectorXd& watts)
{
    return watts.cwiseQuotient(roots(machine));
}

Eigen::VectorXd watts_of(const Machine& machine, const Eigen::VectorXd& loads)
{
    return loads.cwiseProduct(roots(machine));
}

DenseTerms terms_of(const Machine& machine, const HeatProblem& problem)
{
    const auto n = static_cast<Eigen::Index>(machine.capacity.size());
    DenseTerms terms;
    auto& layout = terms.geometry.layout;
    layout = {machine.interfaces.size(), machine.capacity.size(), machine.surfaces.size(), problem.body_heat.size(),
              machine.probes.size()};
    terms.uniform = roots(machine);
    const auto lump = [&](int k) -> Eigen::VectorXd { return Eigen::VectorXd::Unit(n, k) / terms.uniform[k]; };
    terms.solid = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [a, b, conductance] : machine.links)
        terms.solid += conductance * (lump(a) - lump(b)) * (lump(a) - lump(b)).transpose();
    terms.functionals = deadpoint::reduce::RowMatrix::Zero(static_cast<Eigen::Index>(layout.count()), n);
    const auto set = [&](std::size_t functional, int k, double value) {
        terms.functionals(static_cast<Eigen::Index>(functional), k) = value / terms.uniform[k];
    };
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i) {
        const auto& [a, b, area] = machine.interfaces[i];
        const double root = std::sqrt(area);
        const LowRankTerm between{root * (lump(a) - lump(b))};
        terms.joints.push_back({{root * lump(a)}, {root * lump(b)}, between, between});
        terms.geometry.interface_names.push_back("joint " + std::to_string(i));
        terms.geometry.interface_area.push_back(area);
        set(layout.mean(i, false), a, 1);
        set(layout.mean(i, true), b, 1);
    }
    for (std::size_t s = 0; s < machine.surfaces.size(); ++s) {
        const auto& [k, area] = machine.surfaces[s];
        terms.films.push_back({std::sqrt(area) * lump(k)});
        terms.geometry.surface_area.push_back(area);
        set(layout.surface(s), k, area);
    }
    for (std::size_t p = 0; p < machine.capacity.size(); ++p)
        set(layout.part(p), static_cast<int>(p), 1);
    for (std::size_t k = 0; k < problem.body_heat.size(); ++k)
        for (const int part : problem.body_heat[k].parts)
            set(layout.body(k), part, 1.0 / static_cast<double>(problem.body_heat[k].parts.size()));
    for (std::size_t k = 0; k < machine.probes.size(); ++k)
        set(layout.probe(k), machine.probes[k], 1);
    return terms;
}

Run::Run(const Machine& machine_, const HeatProblem& problem, double start)
    : machine(machine_), system(terms_of(machine, problem), problem), run(system, problem)
{
    run.temperature() = start * system.parts().uniform;
    std::vector<double> sumps, enclosures;
    for (const auto& circuit : problem.oil)
        sumps.push_back(circuit.sump_start);
    for (const auto& enclosure : problem.enclosures)
        enclosures.push_back(enclosure.start);
    run.set_media(sumps, enclosures);
}

const deadpoint::ThermalHistory& Run::go()
{
    Quiet observer;
    run.begin();
    return run.go({}, observer);
}

Eigen::VectorXd Run::temperatures() { return temperatures_of(machine, run.temperature()); }

deadpoint::TimeCourse steady(double value) { return deadpoint::TimeCourse::constant(value); }

deadpoint::HeatSegment segment(const HeatProblem& problem, double duration, double ambient)
{
    deadpoint::HeatSegment result;
    result.duration = duration;
    result.heat.resize(problem.sources.size());
    result.body_heat.resize(problem.body_heat.size());
    result.oil_flow.assign(problem.oil.size(), 0.0);
    result.ambient = steady(ambient);
    return result;
}

deadpoint::SurfaceCondition film(double coefficient)
{
    deadpoint::SurfaceCondition condition;
    condition.name = "film";
    condition.coefficient = coefficient;
    return condition;
}

}  // namespace lumps
