#pragma once

#include "deadpoint/exchange/heat.hpp"

#include <vector>

/// Ends of steps: where courses bend, and what a step that passes over such a point would not see.
namespace deadpoint::heat {

/// What a step would not see of the courses of a segment.
struct UnseenCourses {
    double ambient = 0;            ///< of the segment [K s]
    std::vector<double> surfaces;  ///< per surface condition: of its own ambient [K s] or its flux [J/m2]
    std::vector<double> bodies;    ///< per HeatProblem::body_heat [J]
    std::vector<double> powers;    ///< per enclosure [J]
    double prescribed = 0;         ///< of prescribed temperatures [K]
    /// True if there is heat to be looked at.
    [[nodiscard]] bool some_heat() const;
    /// Largest ratio of an entry of heat to the one of a longer step; infinite if that one is 0.
    [[nodiscard]] double share_of(const UnseenCourses& longer) const;
};

/// Times between two others at which the courses of a segment bend, ascending, each once.
class StepEnds {
public:
    explicit StepEnds(const HeatProblem& problem) : problem_(&problem) {}
    void enter(const HeatSegment& segment);

    /// Points of tables.
    [[nodiscard]] std::vector<double> points(double from, double to) const;
    /// The same, and where functions are looked at.
    [[nodiscard]] std::vector<double> looked_at(double from, double to) const;
    /// True if a table of prescribed temperatures has a point there, so that slopes of temperatures jump.
    [[nodiscard]] bool bends_prescribed(double time) const;
    /// Energies of short features are larger by sqrt(d dt / duration): a stage spreads them over d dt, but a surface
    /// that takes up heat within t warms with its square root.
    [[nodiscard]] UnseenCourses unseen(double from, double to) const;

private:
    [[nodiscard]] std::vector<double> merged(double from, double to,
                                             std::vector<double> (TimeCourse::*of)(double, double) const) const;

    const HeatProblem* problem_;
    const HeatSegment* segment_ = nullptr;
    std::vector<const TimeCourse*> courses_;  ///< all of the segment
};

}  // namespace deadpoint::heat
