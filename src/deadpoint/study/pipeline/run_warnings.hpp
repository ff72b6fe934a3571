#pragma once

namespace deadpoint {
class Observer;
struct HeatProblem;
struct ThermalHistory;
}  // namespace deadpoint

/// Internal to study/: what a finished run must say about its laws and its balance.
namespace deadpoint::study {

/// Warns of laws that left their ranges and of an energy balance that does not close.
void warn_about(const ThermalHistory& history, const HeatProblem& problem, Observer& observer);

}  // namespace deadpoint::study
