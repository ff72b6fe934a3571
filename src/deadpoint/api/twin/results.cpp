#include "deadpoint/api/twin/results.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/vec.hpp"
#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/press/result/frame_result.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/result.hpp"

#include <algorithm>
#include <utility>

namespace deadpoint {
namespace {

using Kind = SeriesKind;

std::vector<double> scaled(std::vector<double> values, double factor)
{
    for (double& value : values)
        value *= factor;
    return values;
}

/// Collects the series of a run.
class RunSeries {
public:
    explicit RunSeries(const press::RunResult& result) : result_(result)
    {
        add_temperatures();
        add_joints();
        add_heat();
        add_oil_and_air();
        if (result.drift)
            add_chain(*result.drift);
        add_gaps();
        if (result.frame)
            add_forces(*result.frame);
    }

    std::vector<NamedSeries> take() { return std::move(series_); }

private:
    void add(Kind kind, const std::string& name, const char* quantity, const char* unit, const Series& course)
    {
        series_.push_back({kind, name, quantity, unit, course.value, course.rate});
    }
    void add(Kind kind, const std::string& name, const char* quantity, const char* unit, std::vector<double> values)
    {
        series_.push_back({kind, name, quantity, unit, std::move(values), {}});
    }
    /// Converts heat of the model to heat of the whole press.
    void add_heat(Kind kind, const std::string& name, const char* quantity, const std::vector<double>& watts)
    {
        add(kind, name, quantity, "W", scaled(watts, result_.symmetry_factor));
    }

    void add_temperatures()
    {
        for (const auto& [name, course] : result_.probes)
            add(Kind::probe, name, "temperature", "K", course);
        for (const auto& [name, sides] : result_.interfaces) {
            add(Kind::interface, name, "temperature a", "K", sides.a);
            add(Kind::interface, name, "temperature b", "K", sides.b);
        }
        for (std::size_t p = 0; p < result_.parts.size(); ++p) {
            const auto& [name, part] = result_.parts[p];
            add(Kind::part, name, "temperature", "K", part.mean);
            if (result_.drift)
                add(Kind::part, name, "gap", "m", result_.drift->by_part.at(p));
        }
    }

    void add_joints()
    {
        for (const auto& [name, joint] : result_.joints) {
            add(Kind::joint, name, "temperature", "K", joint.temperature);
            add(Kind::joint, name, "heat", "W", joint.heat);
        }
        for (const auto& [name, source] : result_.sources) {
            add_heat(Kind::source, name, "heat", source.heat);
            add(Kind::source, name, "temperature", "K", source.temperature);
        }
    }

    void add_heat()
    {
        for (const auto& [name, heat] : result_.body_heat)
            add_heat(Kind::heat_source, name, "heat", heat);
        add_heat(Kind::whole, "press", "heat to air", result_.thermal.to_air);
        add_heat(Kind::whole, "press", "heat to oil", result_.thermal.to_oil);
    }

    void add_oil_and_air()
    {
        for (const auto& [name, oil] : result_.oil) {
            add(Kind::oil, name, "inlet temperature", "K", oil.inlet);
            add(Kind::oil, name, "outlet temperature", "K", oil.outlet);
            add(Kind::oil, name, "sump temperature", "K", oil.sump);
            add_heat(Kind::oil, name, "heat", oil.heat);
            add_heat(Kind::oil, name, "cooler", oil.cooler);
        }
        for (const auto& [name, air] : result_.enclosures) {
            add(Kind::enclosure, name, "temperature", "K", air.temperature);
            add_heat(Kind::enclosure, name, "heat from surfaces", air.from_surfaces);
            add_heat(Kind::enclosure, name, "power", air.power);
            add_heat(Kind::enclosure, name, "heat to room", air.to_room);
        }
    }

    void add_chain(const DriftSeries& drift)
    {
        add(Kind::dimension, "E_SW", "change", "m", drift.gap);
        add(Kind::dimension, "E_BG", "change", "m", drift.bearing_to_ground);
        add(Kind::dimension, "E_WG", "change", "m", drift.table_to_ground);
        add(Kind::dimension, "E_CS", "change", "m", drift.crank_to_slide);
        add(Kind::dimension, "E_BC", "change", "m", drift.clearance);
    }

    void add_gaps()
    {
        if (result_.gaps.parallelism)
            for (const auto& corner : result_.gaps.parallelism->corners)
                add(Kind::corner, corner.name, "gap", "m", corner.gap);
        for (const auto& clearance : result_.gaps.clearances)
            add(Kind::clearance, clearance.name, "change", "m", clearance.change);
        if (result_.gaps.force)
            add(Kind::force, "die", "change", "N", *result_.gaps.force);
    }

    void add_forces(const press::FrameResult& frame)
    {
        for (const auto& rod : frame.rods)
            add(Kind::force, rod.part, "change", "N", rod.change);
        for (const auto& bond : frame.bonds)
            add(Kind::force, bond.name, "change", "N", bond.change);
    }

    const press::RunResult& result_;
    std::vector<NamedSeries> series_;
};

EnergyFigures energy_of(const press::RunResult& result)
{
    const auto& energy = result.thermal.energy;
    return {result.symmetry_factor * energy.generated, result.symmetry_factor * energy.from_surfaces,
            result.symmetry_factor * energy.to_air,    result.symmetry_factor * energy.to_oil,
            result.symmetry_factor * energy.stored,    energy.mismatch()};
}

void add_components(std::vector<NamedSeries>& series, Kind kind, const std::string& name,
                    const std::vector<Vec2>& forces)
{
    NamedSeries x{kind, name, "force x", "N", {}}, y{kind, name, "force y", "N", {}};
    for (const auto& force : forces) {
        x.values.push_back(force[0]);
        y.values.push_back(force[1]);
    }
    series.push_back(std::move(x));
    series.push_back(std::move(y));
}

}  // namespace

RunResult public_run(const casefile::Case& input, const press::RunResult& result, std::vector<std::string> warnings,
                     std::string folder)
{
    RunResult run(result.thermal.time, RunSeries(result).take());
    run.case_name = input.machine.name;
    run.case_hash = casefile::case_hash(input);
    run.initial_temperature = input.machine.initial_temperature;
    run.interrupted = result.thermal.interrupted;
    run.warnings = std::move(warnings);
    run.energy = energy_of(result);
    run.cells = result.cells;
    run.heat_unknowns = result.heat_unknowns;
    run.timings = result.timings;
    run.folder = std::move(folder);
    return run;
}

LoadsResult public_loads(const press::LoadsResult& loads)
{
    const auto& turn = loads.history;
    std::vector<NamedSeries> series{{Kind::slide, "slide", "height", "m", turn.height},
                                    {Kind::slide, "slide", "speed", "m/s", turn.slide_speed},
                                    {Kind::slide, "slide", "acceleration", "m/s2", turn.slide_acceleration},
                                    {Kind::slide, "slide", "process force", "N", turn.process_force},
                                    {Kind::drive, "drive", "torque", "N m", turn.drive_torque},
                                    {Kind::drive, "drive", "speed", "rad/s", turn.speed}};
    for (std::size_t j = 0; j < turn.joints.size(); ++j)
        if (!loads.images[j])
            add_components(series, Kind::joint, loads.linkage.joints[j].name, turn.joints[j].force);
    LoadsResult result(turn.time, std::move(series));
    result.segment = loads.segment;
    result.speed = loads.speed;
    result.angle = turn.angle;
    result.stroke = loads.stroke.stroke;
    for (const auto& warning : loads.warnings)
        result.warnings.push_back(warning.text);
    return result;
}

namespace {

std::vector<FilmRow> film_rows(const press::FilmTable& table)
{
    std::vector<FilmRow> rows;
    for (const auto* values : {&table.at_rest, &table.running})
        for (const auto& value : *values)
            rows.push_back({table.surface, table.law, table.area, table.ambient, value.speed, value.rise,
                            value.convection + value.radiation, value.in_range});
    return rows;
}

}  // namespace

HeatTables public_tables(const press::HeatTables& tables)
{
    HeatTables result{tables.segment, tables.speed, tables.temperatures, {}, {}, {}, tables.warnings};
    for (const auto& row : tables.joints)
        result.joints.push_back({row.row, row.law, row.lubricant, row.joints, row.heat});
    for (const auto& row : tables.conductances)
        result.conductances.push_back({row.joint, row.name, row.law, row.area, 1 / row.resistance()});
    for (const auto& table : tables.films)
        std::ranges::copy(film_rows(table), std::back_inserter(result.films));
    return result;
}

}  // namespace deadpoint
