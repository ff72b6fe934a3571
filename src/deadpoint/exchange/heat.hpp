#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/laws/law_table.hpp"
#include "deadpoint/exchange/laws/laws.hpp"

#include <concepts>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// Input of the heat stage besides the machine, and its results. SI units, temperatures in kelvin.
namespace deadpoint {

/// What a step leaves out of a course that it takes for a parabola with the course's ends and integral.
struct Unseen {
    double integral = 0;  ///< largest integral of the difference since the step's start [unit of the course x s]
    double value = 0;     ///< largest difference [unit of the course]
};

/// A quantity over the time since the run began: a table of points, a function, or their sum. Tables are linear between
/// their points and hold the first and the last value beyond them.
class TimeCourse {
public:
    /// Features of a function that last shorter may be missed [s].
    static constexpr double finest = 1;
    /// A table with two equal times is a jump, which is made a ramp of this length about it, so that courses are
    /// continuous and keep their integral [s].
    static constexpr double jump = 1e-3;

    TimeCourse() = default;
    /// @param function  of the time [s]
    /// @param width     in which the function is smooth [s]
    template <class Function>
    requires(std::is_invocable_r_v<double, const Function&, double> &&
             !std::same_as<std::remove_cvref_t<Function>, TimeCourse>)
        TimeCourse(Function function, double width = finest)
        : function_(std::move(function)), width_(width)
    {}
    /// @param times  increasing, or twice the same at a jump; at least one [s]
    /// @throws DomainError if the sizes differ or times do not increase
    TimeCourse(std::vector<double> times, std::vector<double> values);
    static TimeCourse constant(double value) { return {{0.0}, {value}}; }

    /// False if it was not given.
    explicit operator bool() const { return function_ || !times_.empty(); }
    double operator()(double time) const;
    /// True if it is one value at all times.
    [[nodiscard]] bool is_constant() const { return !function_ && times_.size() < 2; }
    /// True if it has neither a point between two times nor a function.
    [[nodiscard]] bool is_linear(double from, double to) const;
    /// Exact of a table; of a function by Gauss' method on pieces of its width.
    [[nodiscard]] double mean(double from, double to) const;

    /// The table's points between two times, without these.
    [[nodiscard]] std::vector<double> points(double from, double to) const;
    /// The same, and in between times at distances of the function's width.
    [[nodiscard]] std::vector<double> looked_at(double from, double to) const;
    [[nodiscard]] Unseen unseen(double from, double to) const;

    [[nodiscard]] TimeCourse times(double factor) const;
    /// @param width  in which the function is smooth [s]
    [[nodiscard]] TimeCourse plus(const std::function<double(double)>& function, double width) const;

private:
    [[nodiscard]] double table(double time) const;
    [[nodiscard]] double table_integral(double from, double to) const;
    [[nodiscard]] double function_integral(double from, double to) const;
    [[nodiscard]] std::pair<std::size_t, std::size_t> between(double from, double to) const;

    std::vector<double> times_, values_;
    std::function<double(double)> function_;
    double width_ = finest;
};

/// Contact conductance of an interface. A contact layer without thickness, at T_f, receives
/// friction heat q and conducts to both sides and to the oil:  q + film_a (T_a - T_f) + film_b
/// (T_b - T_f) + oil (T_oil - T_f) = 0.
struct InterfaceLaw {
    double film_a = 0;           ///< [W/m2/K]
    double film_b = 0;           ///< [W/m2/K]
    double oil = 0;              ///< [W/m2/K]
    double oil_temperature = 0;  ///< [K]
    bool turns_fully = false;    ///< each side sees the other's mean around the circumference
    int source = -1;             ///< index into HeatProblem::sources, or none
    double heat_weight = 1;      ///< heat per area, relative to the other interfaces of that source
    int heat_part = -1;          ///< the friction heat goes into this part's volume, not into the contact layer
    /// Density of the load part of the friction heat, relative to its mean; empty: uniform. Not for
    /// interfaces that rotate.
    std::function<double(const Vec3&)> load_zone;
};

/// One side of an interface.
struct InterfaceSide {
    int interface = 0;
    bool b = false;
};

/// Friction heat of a friction law, uniform over the (weighted) area of the interfaces that name
/// it.
struct HeatSource {
    std::string name;
    double share = 1;  ///< of the whole press's heat that enters this model (symmetry factor, 0.5 in a half model)
    /// Sides whose mean temperatures differ by the ring temperature difference, inner less outer.
    std::vector<InterfaceSide> inner_rings, outer_rings;
};

/// Heat of another kind, from a motor or a clutch, uniform over the volume of parts or over a
/// surface.
struct BodyHeat {
    std::string name;
    std::vector<int> parts;
    int surface = -1;  ///< index into Machine::surfaces; instead of parts
};

/// Oil that flows through joints one after the other and warms. It reaches all interfaces of a
/// joint at one temperature and leaves warmer by their heat divided by the flow. Their
/// InterfaceLaw::oil is the effective coefficient against the oil that arrives (its warming within
/// the joint included).
struct OilCourse {
    std::string name;
    std::vector<std::vector<int>> joints;  ///< their interfaces, in the order of the oil
    bool cooled = true;            ///< a cooler brings the oil to `inlet_temperature`; else it comes from the sump
    double inlet_temperature = 0;  ///< [K]
    double sump_capacity = 0;      ///< [J/K], in this model
    double sump_loss = 0;          ///< to the ambient [W/K], in this model
    double sump_start = 0;         ///< temperature at the start [K]
};

/// Air of one temperature between surfaces and the room: C dT/dt = film heat of its surfaces + exchange (ambient - T) +
/// power.
struct Enclosure {
    std::string name;
    double capacity = 0;  ///< C [J/K], > 0, in this model
    double exchange = 0;  ///< with the segment's ambient [W/K], in this model
    double start = 0;     ///< temperature at the start [K]
};

struct SurfaceCondition {
    enum class Kind { film, temperature, flux };
    std::string name;
    int surface = -1;  ///< index into Machine::surfaces
    int part = -1;     ///< only the faces of that surface that lie on this part; -1: all of them
    Kind kind = Kind::film;
    double coefficient = 0;       ///< film [W/m2/K]
    std::vector<FilmLawAt> laws;  ///< film: one per segment, convection only; empty: the constant coefficient
    double emissivity =
        0;  ///< convection: emissivity to its ambient, or to the other surfaces of its HeatProblem::radiation
    TimeCourse ambient;  ///< film: if empty, the segment's
    int enclosure = -1;  ///< film: index into HeatProblem::enclosures, whose air it faces instead
    std::function<double(const Vec3&, double time)> temperature;
    std::vector<TimeCourse> temperature_courses;  ///< the same at some of its places, at which steps look
    TimeCourse flux;                              ///< [W/m2] into the part
};

/// Surfaces that radiate to each other only. Surface i emits the net power sum over j of
/// exchange_ij sigma (mean of T_i^4 - mean of T_j^4). The irradiation is uniform over each surface.
struct RadiantRoom {
    std::vector<int> surfaces;     ///< indices into HeatProblem::surfaces, films
    std::vector<double> exchange;  ///< row after row; symmetric, row i sums to emissivity times area of i [m2]
};

/// A segment of the operation with constant laws.
struct HeatSegment {
    double duration = 0;
    std::vector<LawTable> heat;               ///< per source [W] over its temperature [K]; empty: none
    std::vector<RingHeatLaw> ring_heat;       ///< per source, or none at all; empty function: none
    std::vector<double> zoned_heat;           ///< per source, or none at all: its load part, of the whole press [W]
    std::vector<TimeCourse> body_heat;        ///< per HeatProblem::body_heat, in this model [W]; empty function: none
    std::vector<TimeCourse> enclosure_power;  ///< per enclosure or none at all, in this model [W]; empty function: none
    std::vector<double> oil_flow;             ///< per circuit: mass flow times heat capacity, in this model [W/K]
    std::vector<InterfaceLaw> interfaces;     ///< as HeatProblem::interfaces, where they differ from those
    TimeCourse ambient;                       ///< over the time since the run began
};

struct HeatProbe {
    std::string name;
    int part = -1;
    Vec3 position{};
};

struct HeatProblem {
    std::vector<InterfaceLaw> interfaces;  ///< as Machine::interfaces
    std::vector<HeatSource> sources;
    std::vector<BodyHeat> body_heat;
    std::vector<OilCourse> oil;
    std::vector<Enclosure> enclosures;
    std::vector<SurfaceCondition> surfaces;
    std::vector<RadiantRoom> radiation;
    std::vector<HeatSegment> segments;
    std::vector<HeatProbe> probes;
    std::function<double(int part, const Vec3&)> initial_temperature;
    double time_tolerance = 0.005;   ///< target error of the run at probes, interfaces, sumps and enclosed air [K]
    double initial_step = 1;         ///< [s]
    double max_step = 1800;          ///< [s]
    double fixed_step = 0;           ///< [s]; > 0 switches the step control off
    double solver_tolerance = 1e-9;  ///< root mean square error of a linear solve [K]
    std::vector<double> field_times;
};

/// One scalar over time at the accepted steps, with its derivative, for cubic interpolation between them.
struct Series {
    std::vector<double> value;
    std::vector<double> rate;
};

/// One oil circuit at the accepted steps, in this model.
struct OilHistory {
    Series inlet;                ///< at the first joint [K]
    Series outlet;               ///< after the last one [K]
    Series sump;                 ///< [K]
    std::vector<double> heat;    ///< taken from the joints [W]
    std::vector<double> cooler;  ///< taken by the cooler [W]
};

/// The air of one enclosure at the accepted steps, in this model.
struct EnclosureHistory {
    Series temperature;                 ///< [K]
    std::vector<double> from_surfaces;  ///< [W]
    std::vector<double> power;          ///< [W]
    std::vector<double> to_room;        ///< [W]
};

struct EnergyBalance {
    double generated = 0;  ///< friction and other heat [J]
    double to_air = 0;     ///< of the room
    double to_oil = 0;
    double from_surfaces = 0;  ///< prescribed temperatures and fluxes, into the parts
    double stored = 0;         ///< in the parts and in enclosed air
    /// |generated + from_surfaces - to_air - to_oil - stored| over the largest of them.
    [[nodiscard]] double mismatch() const;
};

struct ThermalHistory {
    std::vector<double> time;         ///< of the accepted steps, from 0 [s]
    std::vector<Series> probes;       ///< [K]
    std::vector<Series> interface_a;  ///< mean temperature of side a, per interface [K]
    std::vector<Series> interface_b;
    std::vector<Series> part_means;                       ///< volume mean per part [K]
    std::vector<Series> functionals;                      ///< of the adjoints handed in
    std::vector<std::vector<double>> source_heat;         ///< per source, at the steps, in this model [W]
    std::vector<std::vector<double>> source_temperature;  ///< mean film temperature [K]
    std::vector<double> to_air;                           ///< of the room [W], in this model
    std::vector<double> to_oil;
    std::vector<std::vector<double>> body_heat;  ///< per HeatProblem::body_heat, in this model [W]
    std::vector<OilHistory> oil;                 ///< per circuit
    std::vector<EnclosureHistory> enclosures;
    std::vector<std::vector<double>> contributions;  ///< [part][step] of each functional chosen for attribution
    EnergyBalance energy;                            ///< in this model
    int rejected_steps = 0;
    int linear_iterations = 0;
    int linear_solves = 0;
    bool law_out_of_range = false;                  ///< of friction heat
    std::vector<bool> film_out_of_range;            ///< per surface condition: its law left its tested range somewhere
    std::vector<double> part_lowest, part_highest;  ///< nodal temperature of each part over the run [K]
    bool interrupted = false;
};

/// True if a run has no heat and all its temperatures stay within `tolerance` [K] of each other.
/// Its balance then consists of errors of solvers and rounding.
bool nothing_happens(const ThermalHistory& history, double tolerance);

/// Value of a series at any time within the history (cubic Hermite between the steps).
double interpolate(const std::vector<double>& time, const Series& series, double at);

}  // namespace deadpoint
