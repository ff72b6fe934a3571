#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Results by name. All values are in SI units; each series states its unit.
namespace deadpoint {

/// The kind of thing that a series describes.
enum class SeriesKind {
    probe,        ///< temperature of a point
    interface,    ///< "joint.interface": temperature a, temperature b
    joint,        ///< temperature, heat (friction, whole press); over a turn: force x, force y (on its first body)
    part,         ///< temperature (volume mean), gap (its contribution to E_SW, if the case has a dimension chain)
    source,       ///< a friction law: heat (whole press), temperature of its contact layers
    heat_source,  ///< a motor, a clutch: heat (whole press)
    oil,          ///< a circuit: inlet, outlet and sump temperature; heat, cooler (whole press)
    enclosure,    ///< enclosed air: temperature; heat from surfaces, power, heat to room (whole press)
    whole,        ///< "press": heat to air, heat to oil
    dimension,    ///< of the chain: E_SW (> 0: the gap opens), E_BG, E_WG, E_CS, E_BC, change since the start
    corner,       ///< of the slide: gap, change since the start
    clearance,    ///< of a bearing or guide: change since the start, < 0 closes
    force,        ///< of a rod, across a bond, or of the "die" at a fixed height: change since the start
    slide,        ///< "slide", over a turn: height, speed, acceleration, process force
    drive         ///< "drive", over a turn: torque, speed
};

/// The name of a kind: "probe", "heat source", ...
std::string_view kind_name(SeriesKind kind);

/// One quantity of one thing of the press over time, or over a turn of the crank.
struct NamedSeries {
    SeriesKind kind = SeriesKind::probe;
    std::string name;             ///< of the thing in the case: "ram", "crank_pin"; of the dimension: "E_SW"
    std::string quantity;         ///< "temperature", "heat", "change", ...
    std::string unit;             ///< "K", "W", "m", "N", "rad/s", ...
    std::vector<double> values;   ///< one per time (or crank position) of its result
    std::vector<double> rates{};  ///< their derivatives by time [unit/s]; empty: linear in between
};

/// Series that share their times.
class SeriesTable {
public:
    SeriesTable() = default;
    SeriesTable(std::vector<double> time, std::vector<NamedSeries> series)
        : time_(std::move(time)), series_(std::move(series))
    {}

    /// Ascending, from 0 [s]. The time at which a segment of the operation begins may occur twice,
    /// since heat may jump there.
    [[nodiscard]] const std::vector<double>& time() const noexcept { return time_; }
    [[nodiscard]] const std::vector<NamedSeries>& series() const noexcept { return series_; }
    /// @return null if there is no such series
    [[nodiscard]] const NamedSeries* find(SeriesKind kind, std::string_view name, std::string_view quantity) const;
    /// @throws InputError if there is no such series; the message suggests similar names
    [[nodiscard]] const NamedSeries& at(SeriesKind kind, std::string_view name, std::string_view quantity) const;
    /// Names of all things of a kind, in the order of the case, each once.
    [[nodiscard]] std::vector<std::string> names(SeriesKind kind) const;
    /// Value between the times: cubic (Hermite) if the series has rates, else linear; beyond the
    /// ends, the nearest value.
    /// @param time  [s]
    [[nodiscard]] double value(const NamedSeries& series, double time) const;

private:
    std::vector<double> time_;
    std::vector<NamedSeries> series_;
};

/// Heat balance of a run, of the whole press [J].
struct EnergyFigures {
    double generated = 0;      ///< friction and other heat
    double from_surfaces = 0;  ///< prescribed temperatures and fluxes, into the parts
    double to_air = 0;
    double to_oil = 0;
    double stored = 0;
    double mismatch = 0;  ///< |generated + from_surfaces - to_air - to_oil - stored| over the largest of them [-]
};

/// What a run computed, over its time steps.
struct RunResult : SeriesTable {
    using SeriesTable::SeriesTable;

    std::string case_name;
    std::string case_hash;           ///< of the case in SI units; the same as in the result files
    double initial_temperature = 0;  ///< [K]
    bool interrupted = false;        ///< the observer was cancelled: the series end there
    std::vector<std::string> warnings;
    EnergyFigures energy;
    long long cells = 0;
    long long heat_unknowns = 0;
    std::vector<std::pair<std::string, double>> timings;  ///< stage, wall time [s]
    std::string folder;                                   ///< of the result files; empty: none were written

    /// Temperature of a probe [K]. These throw InputError as at().
    [[nodiscard]] const NamedSeries& probe(std::string_view name) const;
    [[nodiscard]] const NamedSeries& joint_temperature(std::string_view name) const;
    /// Friction heat of a joint, of the whole press [W].
    [[nodiscard]] const NamedSeries& joint_heat(std::string_view name) const;
    [[nodiscard]] const NamedSeries& part_temperature(std::string_view name) const;
    /// E_SW, the change of the gap between slide and table since the start [m]; > 0: it opens.
    /// @throws InputError if the case has no dimension chain
    [[nodiscard]] const NamedSeries& gap() const;
};

/// Motion and forces over one turn of the crank; time() runs over the turn.
struct LoadsResult : SeriesTable {
    using SeriesTable::SeriesTable;

    int segment = 0;            ///< of the operation, from 0
    double speed = 0;           ///< of the crank, mean [rad/s]
    std::vector<double> angle;  ///< of the crank from its assembled position, one per time [rad]
    double stroke = 0;          ///< [m]
    std::vector<std::string> warnings;
};

/// Friction heat of a law over the temperature.
struct JointHeatRow {
    std::string name;  ///< in [friction] of the case
    std::string law;
    std::string lubricant;
    std::vector<std::string> joints;  ///< that name it
    std::vector<double> heat;         ///< at HeatTables::temperatures, of the whole press [W]
};

/// Contact conductance of an interface.
struct ConductanceRow {
    std::string joint;
    std::string interface;
    std::string law;         ///< "given" where the case states the value
    double area = 0;         ///< in contact, of the model [m2]
    double conductance = 0;  ///< of both sides in series [W/m2/K]
};

/// Coefficient of a surface at one rise above the air, by convection and radiation.
struct FilmRow {
    std::string surface;
    std::string law;
    double area = 0;         ///< of the model [m2]
    double ambient = 0;      ///< [K]
    double speed = 0;        ///< of the surface's law [rad/s, or m/s if it moves]
    double rise = 0;         ///< above the ambient [K]
    double coefficient = 0;  ///< convection and radiation [W/m2/K]
    bool in_range = true;    ///< of the law's tested range
};

/// Values of the laws of a case, before any field is solved.
struct HeatTables {
    int segment = 0;                   ///< of the operation, from 0
    double speed = 0;                  ///< of the crank [rad/s]
    std::vector<double> temperatures;  ///< of the joints [K]
    std::vector<JointHeatRow> joints;
    std::vector<ConductanceRow> conductances;
    std::vector<FilmRow> films;
    std::vector<std::string> warnings;
};

/// Size of a press that was meshed.
struct MeshFigures {
    struct Part {
        std::string name;
        std::string body;
        long long cells = 0;
    };
    std::size_t cells = 0;
    std::size_t nodes = 0;
    bool half_model = false;  ///< only half of the press is modelled
    std::vector<Part> parts;
};

}  // namespace deadpoint
