#pragma once

#include "deadpoint/heat/run.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/online/dense_system.hpp"

#include <Eigen/Dense>
#include <string>
#include <utility>
#include <vector>

/// Small machines of lumps, each a part of one temperature: systems whose solutions are known on paper.
namespace lumps {

using deadpoint::HeatProblem;
using deadpoint::reduce::DenseSystem;
using deadpoint::reduce::DenseTerms;

/// What a machine consists of. Heat flows between lumps through `solid` links, interfaces and surfaces.
struct Machine {
    std::vector<double> capacity;                          ///< [J/K]
    std::vector<std::tuple<int, int, double>> links;       ///< lump, lump, conductance [W/K]
    std::vector<std::tuple<int, int, double>> interfaces;  ///< side a, side b, area [m2]
    std::vector<std::pair<int, double>> surfaces;          ///< lump, area [m2]
    std::vector<int> probes;                               ///< lumps
};

inline Eigen::MatrixXd unit_block(Eigen::Index size, int row, int column, double value)
{
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size, size);
    block(row, column) = value;
    return block;
}

/// The terms of a machine; body heat k of the problem falls into the parts that it names, by equal shares.
inline DenseTerms terms_of(const Machine& machine, const HeatProblem& problem)
{
    const auto n = static_cast<Eigen::Index>(machine.capacity.size());
    DenseTerms terms;
    auto& layout = terms.geometry.layout;
    layout = {machine.interfaces.size(), machine.capacity.size(), machine.surfaces.size(), problem.body_heat.size(),
              machine.probes.size()};
    terms.mass = Eigen::Map<const Eigen::VectorXd>(machine.capacity.data(), n).asDiagonal();
    terms.solid = Eigen::MatrixXd::Zero(n, n);
    for (const auto& [a, b, conductance] : machine.links)
        terms.solid += unit_block(n, a, a, conductance) + unit_block(n, b, b, conductance) -
                       unit_block(n, a, b, conductance) - unit_block(n, b, a, conductance);
    terms.functionals = deadpoint::reduce::RowMatrix::Zero(static_cast<Eigen::Index>(layout.count()), n);
    const auto set = [&](std::size_t functional, int lump, double value) {
        terms.functionals(static_cast<Eigen::Index>(functional), lump) = value;
    };
    for (std::size_t i = 0; i < machine.interfaces.size(); ++i) {
        const auto& [a, b, area] = machine.interfaces[i];
        terms.joints.push_back({unit_block(n, a, a, area),
                                unit_block(n, b, b, area),
                                unit_block(n, a, b, area) + unit_block(n, b, a, area),
                                {}});
        terms.joints.back().turning = terms.joints.back().across;
        terms.geometry.interface_names.push_back("joint " + std::to_string(i));
        terms.geometry.interface_area.push_back(area);
        set(layout.mean(i, false), a, 1);
        set(layout.mean(i, true), b, 1);
    }
    for (std::size_t s = 0; s < machine.surfaces.size(); ++s) {
        const auto& [lump, area] = machine.surfaces[s];
        terms.films.push_back(unit_block(n, lump, lump, area));
        terms.geometry.surface_area.push_back(area);
        set(layout.surface(s), lump, area);
    }
    for (std::size_t p = 0; p < machine.capacity.size(); ++p)
        set(layout.part(p), static_cast<int>(p), 1);
    for (std::size_t k = 0; k < problem.body_heat.size(); ++k)
        for (const int part : problem.body_heat[k].parts)
            set(layout.body(k), part, 1.0 / static_cast<double>(problem.body_heat[k].parts.size()));
    for (std::size_t k = 0; k < machine.probes.size(); ++k)
        set(layout.probe(k), machine.probes[k], 1);
    terms.uniform = Eigen::VectorXd::Ones(n);
    return terms;
}

struct Quiet : deadpoint::Observer {};

/// A problem's run on such a machine, all lumps at one temperature.
struct Run {
    Run(const Machine& machine, const HeatProblem& problem, double start)
        : system(terms_of(machine, problem), problem), run(system, problem)
    {
        run.temperature().setConstant(start);
        std::vector<double> sumps, enclosures;
        for (const auto& circuit : problem.oil)
            sumps.push_back(circuit.sump_start);
        for (const auto& enclosure : problem.enclosures)
            enclosures.push_back(enclosure.start);
        run.set_media(sumps, enclosures);
    }
    const deadpoint::ThermalHistory& go()
    {
        Quiet observer;
        run.begin();
        return run.go({}, observer);
    }
    DenseSystem system;
    deadpoint::heat::HeatRun<DenseSystem> run;
};

inline deadpoint::TimeCourse steady(double value)
{
    return [value](double) { return value; };
}

/// A segment without heat at an ambient temperature, for a problem's lists.
inline deadpoint::HeatSegment segment(const HeatProblem& problem, double duration, double ambient)
{
    deadpoint::HeatSegment result;
    result.duration = duration;
    result.heat.resize(problem.sources.size());
    result.body_heat.resize(problem.body_heat.size());
    result.oil_flow.assign(problem.oil.size(), 0.0);
    result.ambient = steady(ambient);
    return result;
}

/// A film of constant coefficient [W/m2/K].
inline deadpoint::SurfaceCondition film(double coefficient)
{
    deadpoint::SurfaceCondition condition;
    condition.name = "film";
    condition.coefficient = coefficient;
    return condition;
}

}  // namespace lumps
