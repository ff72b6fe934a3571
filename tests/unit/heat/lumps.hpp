#pragma once

#include "deadpoint/heat/run.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/reduce/online/dense_system.hpp"

#include <Eigen/Dense>
#include <tuple>
#include <utility>
#include <vector>

/// Small machines of lumps, each a part of one temperature: systems whose solutions are known on paper.
namespace lumps {

using deadpoint::HeatProblem;
using deadpoint::reduce::DenseSystem;
using deadpoint::reduce::DenseTerms;
using deadpoint::reduce::LowRankTerm;

/// What a machine consists of. Heat flows between lumps through `solid` links, interfaces and surfaces.
struct Machine {
    std::vector<double> capacity;                          ///< [J/K]
    std::vector<std::tuple<int, int, double>> links;       ///< lump, lump, conductance [W/K]
    std::vector<std::tuple<int, int, double>> interfaces;  ///< side a, side b, area [m2]
    std::vector<std::pair<int, double>> surfaces;          ///< lump, area [m2]
    std::vector<int> probes;                               ///< lumps
};

/// States of lumps: their temperatures times the roots of their capacities. Loads are watts divided by these.
Eigen::VectorXd roots(const Machine& machine);
Eigen::VectorXd states_of(const Machine& machine, const Eigen::VectorXd& temperatures);
Eigen::VectorXd temperatures_of(const Machine& machine, const Eigen::VectorXd& states);
Eigen::VectorXd loads_of(const Machine& machine, const Eigen::VectorXd& watts);
Eigen::VectorXd watts_of(const Machine& machine, const Eigen::VectorXd& loads);

/// The terms of a machine; body heat k of the problem falls into the parts that it names, by equal shares.
DenseTerms terms_of(const Machine& machine, const HeatProblem& problem);

struct Quiet : deadpoint::Observer {};

/// A problem's run on such a machine, all lumps at one temperature.
struct Run {
    Run(const Machine& machine, const HeatProblem& problem, double start);
    const deadpoint::ThermalHistory& go();
    /// Temperatures of the lumps [K].
    Eigen::VectorXd temperatures();
    Machine machine;
    DenseSystem system;
    deadpoint::heat::HeatRun<DenseSystem> run;
};

deadpoint::TimeCourse steady(double value);

/// A segment without heat at an ambient temperature, for a problem's lists.
deadpoint::HeatSegment segment(const HeatProblem& problem, double duration, double ambient);

/// A film of constant coefficient [W/m2/K].
deadpoint::SurfaceCondition film(double coefficient);

}  // namespace lumps
