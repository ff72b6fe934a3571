#pragma once

#include "deadpoint/core/units.hpp"
#include "deadpoint/report/schema/columns.hpp"
#include "deadpoint/report/tables/csv.hpp"
#include "deadpoint/report/tables/sweep_figures.hpp"

#include <array>

/// The columns of a run's drift in tables of points.
namespace deadpoint::report {

struct DriftColumn {
    schema::Column column;
    double (*value)(const SweepDrift&);  ///< no_value: the run has none
};

inline constexpr std::array drift_columns{
    DriftColumn{schema::sweep::largest, [](const SweepDrift& d) { return micrometre * d.largest; }},
    DriftColumn{schema::sweep::largest_time, [](const SweepDrift& d) { return d.largest_time; }},
    DriftColumn{schema::sweep::end, [](const SweepDrift& d) { return micrometre * d.final; }},
    DriftColumn{schema::sweep::first_hour,
                [](const SweepDrift& d) { return d.gap ? micrometre * d.gap->first_hour_change : no_value; }},
    DriftColumn{schema::sweep::range, [](const SweepDrift& d) { return d.gap ? micrometre * d.gap->range : no_value; }},
    DriftColumn{schema::sweep::steady,
                [](const SweepDrift& d) { return d.gap ? d.gap->steady_from.value_or(no_value) : no_value; }},
};

}  // namespace deadpoint::report
