#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <vector>

namespace deadpoint::heat {

struct FunctionalLayout;
struct HeatBalance;

/// Records the steps of a run.
class HistoryRecorder {
public:
    /// @param functionals    values that a system observes besides those of the layout, with their slopes
    /// @param contributions  further values without slopes
    HistoryRecorder(const HeatProblem& problem, const FunctionalLayout& layout, std::size_t functionals,
                    std::size_t contributions);

    /// Functionals of the layout whose values record() takes, in order: probes, sides a, sides b, parts.
    [[nodiscard]] const std::vector<std::size_t>& watched() const { return watched_; }

    /// Records a time.
    /// @param values  of the watched functionals, then what the system observes
    /// @param slopes  the same of the slope; empty where it is not known yet
    /// @param middle  balance at the middle of the step of length `dt` that ends here; with dt 0 there was none
    void record(double time, const std::vector<double>& values, const std::vector<double>& slopes,
                const HeatBalance& balance, const HeatBalance& middle, double dt);
    /// Gives the first time of a segment the slopes of the secant through the step that follows it.
    void fill_first_slopes(std::size_t row);
    /// Adds the heat of a step to the energy balance, with the weights of its stages.
    void add_energy(double dt, const HeatBalance& start, const HeatBalance& middle, const HeatBalance& end,
                    double from_prescribed, double stored);

    [[nodiscard]] const ThermalHistory& history() const { return history_; }
    [[nodiscard]] ThermalHistory& history() { return history_; }

private:
    void record_media(const HeatBalance& balance, const HeatBalance& middle, double dt);
    void record_heat(const HeatBalance& balance);

    ThermalHistory history_;
    std::vector<std::size_t> watched_;
};

}  // namespace deadpoint::heat
