#pragma once

#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/observer.hpp"

#include <chrono>
#include <span>
#include <string>
#include <vector>

namespace deadpoint {
class BinaryReader;
class BinaryWriter;
}  // namespace deadpoint

namespace deadpoint::fem {
struct CheckpointPlan;
}

namespace deadpoint::heat {

template <class System>
class HeatRun;
struct PreconditionerOrigin;

}  // namespace deadpoint::heat

/// Internal to fem/: writes and restores the state of a run between two steps.
namespace deadpoint::fem {

/// Every member function is collective.
class HeatCheckpoint {
public:
    /// @param start  the temperatures from which the run starts
    HeatCheckpoint(heat::HeatRun<HeatSystem>& run, const CheckpointPlan& plan, const ThermalState& start,
                   Observer& observer);

    /// Restores a run that has begun from the plan's file, and passes on again the fields that it
    /// had passed on.
    /// @throws IoError if it is broken; InputError if it belongs to another version, case, mesh or start
    void restore(const FieldCallback& on_field);
    /// Writes a checkpoint if the interval has passed on the first rank's clock, or with `now`. A
    /// failure becomes a warning. After keep() only with `now`, so that a run that is resumed keeps the same state.
    void offer(bool now);
    /// Writes the plan's kept file. A failure becomes a warning.
    void keep();

private:
    [[nodiscard]] bool due() const;
    void write_on_first(const std::string& file, const char* without) const;
    [[nodiscard]] std::vector<Vec> vectors() const;
    void write(std::ostream& out) const;
    template <class Value>
    void write_field(BinaryWriter& writer, std::span<const Value> owned) const;
    template <class Value>
    [[nodiscard]] Field read_field(BinaryReader& reader) const;
    void make_preconditioner(const heat::PreconditionerOrigin& origin);
    void hand_on_again(BinaryReader& reader, std::size_t count, const FieldCallback& on_field) const;

    heat::HeatRun<HeatSystem>& run_;
    const Discretisation& space_;
    const CheckpointPlan& plan_;
    Observer& observer_;
    std::string start_;  ///< hash of where the run starts
    std::vector<std::size_t> order_;
    std::chrono::steady_clock::time_point last_;
    double cost_ = 0;  ///< of the last one [s]
    bool kept_ = false;
};

}  // namespace deadpoint::fem
