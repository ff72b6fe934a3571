#include "deadpoint/heat/history.hpp"

#include "deadpoint/heat/balance.hpp"
#include "deadpoint/heat/functionals.hpp"
#include "deadpoint/heat/tr_bdf2.hpp"

#include <algorithm>
#include <array>

namespace deadpoint::heat {
namespace {

// The groups of series in the order of their values.
std::array<std::vector<Series>*, 5> groups(ThermalHistory& history)
{
    return {&history.probes, &history.interface_a, &history.interface_b, &history.part_means, &history.functionals};
}

// Adds the value of a scalar at the end of a step of length `dt`; without a step its slope is not set.
void append(Series& series, double middle, double end, double dt)
{
    series.rate.push_back(dt > 0 ? end_slope(series.value.back(), middle, end, dt) : 0);
    series.value.push_back(end);
}

}  // namespace

HistoryRecorder::HistoryRecorder(const HeatProblem& problem, const FunctionalLayout& layout, std::size_t functionals,
                                 std::size_t contributions)
{
    history_.probes.resize(layout.probes);
    history_.interface_a.resize(layout.interfaces);
    history_.interface_b.resize(layout.interfaces);
    history_.part_means.resize(layout.parts);
    history_.functionals.resize(functionals);
    history_.contributions.resize(contributions);
    history_.source_heat.resize(problem.sources.size());
    history_.source_temperature.resize(problem.sources.size());
    history_.body_heat.resize(problem.body_heat.size());
    history_.oil.resize(problem.oil.size());
    history_.enclosures.resize(problem.enclosures.size());
    history_.film_out_of_range.assign(problem.surfaces.size(), false);
    for (std::size_t k = 0; k < layout.probes; ++k)
        watched_.push_back(layout.probe(k));
    for (const bool side_b : {false, true})
        for (std::size_t i = 0; i < layout.interfaces; ++i)
            watched_.push_back(layout.mean(i, side_b));
    for (std::size_t p = 0; p < layout.parts; ++p)
        watched_.push_back(layout.part(p));
}

void HistoryRecorder::record(double time, const std::vector<double>& values, const std::vector<double>& slopes,
                             const HeatBalance& balance, const HeatBalance& middle, double dt)
{
    history_.time.push_back(time);
    std::size_t k = 0;
    for (auto* group : groups(history_))
        for (auto& series : *group) {
            series.value.push_back(values[k]);
            series.rate.push_back(slopes.empty() ? 0 : slopes[k]);
            ++k;
        }
    for (auto& series : history_.contributions)
        series.push_back(values[k++]);
    record_media(balance, middle, dt);
    record_heat(balance);
}

void HistoryRecorder::record_media(const HeatBalance& balance, const HeatBalance& middle, double dt)
{
    for (std::size_t c = 0; c < balance.oil.size(); ++c) {
        auto& circuit = history_.oil[c];
        const auto& from = dt > 0 ? middle.oil[c] : balance.oil[c];
        append(circuit.inlet, from.inlet, balance.oil[c].inlet, dt);
        append(circuit.outlet, from.outlet, balance.oil[c].outlet, dt);
        append(circuit.sump, from.sump, balance.oil[c].sump, dt);
        circuit.heat.push_back(balance.oil[c].heat);
        circuit.cooler.push_back(balance.oil[c].cooler);
    }
    for (std::size_t e = 0; e < balance.air.size(); ++e) {
        auto& enclosure = history_.enclosures[e];
        const auto& from = dt > 0 ? middle.air[e] : balance.air[e];
        append(enclosure.temperature, from.temperature, balance.air[e].temperature, dt);
        enclosure.from_surfaces.push_back(balance.air[e].from_surfaces);
        enclosure.power.push_back(balance.air[e].power);
        enclosure.to_room.push_back(balance.air[e].to_room);
    }
}

void HistoryRecorder::record_heat(const HeatBalance& balance)
{
    for (std::size_t r = 0; r < balance.source_heat.size(); ++r) {
        history_.source_heat[r].push_back(balance.source_heat[r]);
        history_.source_temperature[r].push_back(balance.source_temperature[r]);
    }
    for (std::size_t b = 0; b < balance.body_heat.size(); ++b)
        history_.body_heat[b].push_back(balance.body_heat[b]);
    history_.to_air.push_back(balance.to_air);
    history_.to_oil.push_back(balance.to_oil);
    history_.law_out_of_range = history_.law_out_of_range || !balance.in_range;
    for (std::size_t i = 0; i < balance.films_untested.size(); ++i)
        if (balance.films_untested[i] > 0)
            history_.film_out_of_range[i] = true;
}

void HistoryRecorder::fill_first_slopes(std::size_t row)
{
    if (row + 1 >= history_.time.size())
        return;
    const double dt = history_.time[row + 1] - history_.time[row];
    const auto fill = [&](Series& series) { series.rate[row] = (series.value[row + 1] - series.value[row]) / dt; };
    for (auto* group : groups(history_))
        std::ranges::for_each(*group, fill);
    for (auto& circuit : history_.oil)
        for (auto* series : {&circuit.inlet, &circuit.outlet, &circuit.sump})
            fill(*series);
    for (auto& enclosure : history_.enclosures)
        fill(enclosure.temperature);
}

void HistoryRecorder::add_energy(double dt, const HeatBalance& start, const HeatBalance& middle, const HeatBalance& end,
                                 double from_prescribed, double stored)
{
    const auto over_step = [&](double HeatBalance::*part) {
        return dt * (outer_weight * (start.*part + middle.*part) + diagonal * end.*part);
    };
    auto& energy = history_.energy;
    energy.generated += over_step(&HeatBalance::generated);
    energy.to_air += over_step(&HeatBalance::to_air);
    energy.to_oil += over_step(&HeatBalance::to_oil);
    energy.from_surfaces += over_step(&HeatBalance::flux) + from_prescribed;
    energy.stored += stored;
}

}  // namespace deadpoint::heat
