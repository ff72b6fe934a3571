#pragma once

#include "deadpoint/core/observer.hpp"
#include "deadpoint/fem/conduction/checkpoint.hpp"
#include "deadpoint/fem/conduction/heat_solver.hpp"

#include <chrono>
#include <tuple>

/// Internal to fem/: writes the state of HeatSolver between two steps, and puts it back.
namespace deadpoint::fem {

/// Every member function is collective.
class HeatCheckpoint {
public:
    /// @param solver  before its first step
    HeatCheckpoint(HeatSolver& solver, const CheckpointPlan& plan, Observer& observer);

    /// Puts the plan's file back: into the solver, which has begun the first segment, and into history and place. Hands
    /// on again what was handed on.
    /// @throws IoError if it is broken; InputError if it belongs to another version, case, mesh or start
    void restore(ThermalHistory& history, RunPlace& place, const FieldCallback& on_field);
    /// Writes a checkpoint if it is time, which the first rank's clock says, or `now`. What fails becomes a warning.
    void offer(const ThermalHistory& history, const RunPlace& place, bool now);

private:
    struct Kept;
    using Carried = std::tuple<double&, bool&, std::size_t&, int&, int&, std::vector<double>&>;
    [[nodiscard]] Carried solvers_own() const;
    [[nodiscard]] bool due() const;
    [[nodiscard]] Kept kept() const;
    [[nodiscard]] std::vector<Vec> vectors() const;
    void write(std::ostream& out, const ThermalHistory& history, const RunPlace& place) const;
    template <class Value>
    void write_field(BinaryWriter& writer, std::span<const Value> owned) const;
    template <class Value>
    [[nodiscard]] Field read_field(BinaryReader& reader) const;
    void check(const BinaryReader& reader, const Kept& kept, const RunPlace& place) const;
    void put_back(Kept& kept, std::size_t segment);
    void hand_on_again(BinaryReader& reader, const FieldCallback& on_field) const;

    HeatSolver& solver_;
    const CheckpointPlan& plan_;
    Observer& observer_;
    std::string start_;  ///< hash of where the run starts
    std::vector<std::size_t> order_;
    std::chrono::steady_clock::time_point last_;
    double cost_ = 0;  ///< of the last one [s]
};

}  // namespace deadpoint::fem
