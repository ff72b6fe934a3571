#pragma once

#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/heat/balance.hpp"

#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
}  // namespace deadpoint

namespace deadpoint::heat {

class JointBalance;
struct HeatBalance;

/// Circulating oil, marched from joint to joint, and its sumps, one unknown each in addition to the
/// field.
///
/// Oil that reaches a joint at t leaves it at t + heat / flow. A sump of capacity C has
///   C ds/dt = flow (outlet - s) - loss (s - ambient),
/// and without a cooler feeds the first joint itself. A sump without capacity follows at once.
class OilMarch {
public:
    explicit OilMarch(const HeatProblem& problem) : problem_(&problem) {}

    void enter(const HeatSegment& segment) { segment_ = &segment; }
    /// Sets the times of the step, for the courses.
    void set_step(const StepTimes& step) { step_ = step; }
    [[nodiscard]] bool empty() const { return problem_->oil.empty(); }
    /// At the start of the step, per circuit [K].
    [[nodiscard]] const std::vector<double>& sumps() const { return sump_; }
    void set_sumps(std::vector<double> temperature) { sump_ = std::move(temperature); }

    /// Marches the oil past the contact layers of a balance at the end of a stage of length
    /// `factor`: sets the circuits of the balance and returns the temperature at which the oil
    /// reaches each interface [K].
    /// @param known right-hand side of each sump in the stage: C s = C known + factor (gains) [K]
    std::vector<double> march(const JointBalance& joints, HeatBalance& balance, double time, double factor,
                              const std::vector<double>& known) const;
    /// Right-hand sides of the sumps in the two stages of a step.
    [[nodiscard]] std::vector<double> known_in_first_stage(double factor, const HeatBalance& start) const;
    [[nodiscard]] std::vector<double> known_in_second_stage(const HeatBalance& middle) const;
    /// Largest error of the sumps in a step [K]. A sump forgets an error only with its own
    /// relaxation. The errors of 1 / (1 - exp(-relaxation dt)) steps add up, and their sum must
    /// keep to the time tolerance.
    /// @param slope_known  false in the first step of a segment, whose estimate is filtered by the stage's equation
    [[nodiscard]] double step_error(double dt, bool slope_known, const HeatBalance& start, const HeatBalance& middle,
                                    const HeatBalance& end) const;
    /// Ends a step.
    void accept(const HeatBalance& end);

private:
    double outlet(std::size_t circuit, double inlet, const JointBalance& joints, const HeatBalance& balance,
                  std::vector<double>& reaches) const;
    void march_circuit(std::size_t circuit, const JointBalance& joints, HeatBalance& balance, double time,
                       double factor, double known, std::vector<double>& reaches) const;

    const HeatProblem* problem_;
    const HeatSegment* segment_ = nullptr;
    StepTimes step_;
    std::vector<double> sump_;
};

}  // namespace deadpoint::heat
