#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

namespace deadpoint {
struct HeatProblem;
struct HeatSegment;
class TimeCourse;
}  // namespace deadpoint

/// The scalars of a heat balance at one time, the records of accepted steps, and what steps take of courses over time.
namespace deadpoint::heat {

/// An oil circuit at one time.
struct OilFlow {
    double inlet = 0;            ///< [K]
    double outlet = 0;           ///< [K]
    double sump = 0;             ///< [K]
    double sump_rate = 0;        ///< dT/dt of the sump; 0 if it follows at once [K/s]
    double sump_relaxation = 0;  ///< -d(sump_rate)/d(sump) [1/s]
    double heat = 0;             ///< from the joints [W]
    double cooler = 0;           ///< taken by the cooler [W]
};
constexpr auto members(const OilFlow*)
{
    return std::tuple{&OilFlow::inlet,           &OilFlow::outlet, &OilFlow::sump,  &OilFlow::sump_rate,
                      &OilFlow::sump_relaxation, &OilFlow::heat,   &OilFlow::cooler};
}

/// The air of an enclosure at one time.
struct AirFlow {
    double temperature = 0;    ///< [K]
    double from_surfaces = 0;  ///< [W]
    double power = 0;          ///< [W]
    double to_room = 0;        ///< [W]
    [[nodiscard]] double kept() const { return from_surfaces + power - to_room; }
};
constexpr auto members(const AirFlow*)
{
    return std::tuple{&AirFlow::temperature, &AirFlow::from_surfaces, &AirFlow::power, &AirFlow::to_room};
}

/// The scalars with which the balance of a stage is linear in the temperatures, all of the model.
struct StageRecord {
    double time = 0;                      ///< [s]
    std::vector<double> source_heat;      ///< per source, as in the energy balance [W]
    std::vector<double> body_heat;        ///< [W]
    std::vector<double> oil_temperature;  ///< per interface, as used in the solve [K]
    std::vector<double> film_mean;        ///< per surface condition: mean temperature; 0 where it is prescribed [K]
    std::vector<double>
        variable_to_air;       ///< per surface condition whose coefficient depends on temperature: total heat loss [W]
    std::vector<AirFlow> air;  ///< per enclosure
};
constexpr auto members(const StageRecord*)
{
    return std::tuple{
        &StageRecord::time,      &StageRecord::source_heat,     &StageRecord::body_heat, &StageRecord::oil_temperature,
        &StageRecord::film_mean, &StageRecord::variable_to_air, &StageRecord::air};
}

/// Everything scalar that enters the heat balance at one time.
struct HeatBalance : StageRecord {
    std::vector<double> source_slope;        ///< of a source's heat by the solids' part of its film temperature [W/K]
    std::vector<double> source_temperature;  ///< mean film temperature per source [K]
    std::vector<double> film;                ///< mean film temperature per interface [K]
    std::vector<OilFlow> oil;                ///< per circuit
    double generated = 0;                    ///< friction and other heat [W]
    double to_air = 0;                       ///< of the room [W]
    double to_oil = 0;                       ///< [W]
    double flux = 0;                         ///< through surfaces of prescribed flux, into the parts [W]
    bool in_range = true;                    ///< of the laws of friction heat
    std::vector<double> films_untested;      ///< per surface condition: area where its law is out of range [m2]
};
constexpr auto members(const HeatBalance*)
{
    return std::tuple_cat(members(static_cast<const StageRecord*>(nullptr)),
                          std::tuple{&HeatBalance::source_slope, &HeatBalance::source_temperature, &HeatBalance::film,
                                     &HeatBalance::oil, &HeatBalance::generated, &HeatBalance::to_air,
                                     &HeatBalance::to_oil, &HeatBalance::flux, &HeatBalance::in_range,
                                     &HeatBalance::films_untested});
}

/// An accepted step, enough to run it backward.
struct StepRecord {
    std::size_t segment = 0;
    std::size_t row = 0;  ///< of the history that holds its end
    double duration = 0;  ///< [s]
    StageRecord start, middle, end;
};
constexpr auto members(const StepRecord*)
{
    return std::tuple{&StepRecord::segment, &StepRecord::row,    &StepRecord::duration,
                      &StepRecord::start,   &StepRecord::middle, &StepRecord::end};
}

/// The three times of a step [s].
struct StepTimes {
    double start = 0, middle = 0, end = 0;

    /// Value of a course at one of the times, or at any other one. In the middle it is the one with which the step's
    /// quadrature, weights outer_weight, outer_weight, diagonal, gives the integral of the course: no energy is lost or
    /// won. Where the course is linear over the step that is its value.
    [[nodiscard]] double value(const TimeCourse& course, double time) const;
};

inline StepTimes times_of(const StepRecord& step) { return {step.start.time, step.middle.time, step.end.time}; }

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
