#pragma once

#include "deadpoint/core/vec.hpp"
#include "deadpoint/report/tables/csv.hpp"

#include <string>
#include <vector>

namespace deadpoint::casefile {
struct Case;
}

/// Temperature and displacement of places that no probe of the case named, from the field files of a run.
namespace deadpoint::report {

class ResultFiles;
struct Chart;

/// A place in a part.
struct ProbePlace {
    std::string name;
    std::string part;
    Vec3 position{};  ///< [m]
};

/// Values at a place, at ProbedFields::times.
struct ProbedPlace {
    ProbePlace place;
    double outside = 0;               ///< from the cells of its part, whose nearest place was taken [m]
    std::vector<double> temperature;  ///< [degC]
    std::vector<Vec3> displacement;   ///< [mm]; empty if the fields have none
};

struct ProbedFields {
    std::vector<double> times;  ///< of the fields [s]
    std::vector<ProbedPlace> places;
};

/// "part,x,y,z" or "name=part,x,y,z", with units: "frame,0 mm,120 mm,-30 mm". Without a name, the text is the name.
/// @throws InputError if it is not, or two places have one name
std::vector<ProbePlace> probe_places(const std::vector<std::string>& texts);

/// Reads the fields of a run at places, linear or trilinear between the corners of a cell.
///
/// A place may be off the cells by a tenth of the cell's size, as the surface of a bore is between the corners of
/// plane faces; the nearest place in a cell then counts, as for the probes of a case.
///
/// @param input  the case of the results, for the names of its parts
/// @throws InputError if the results hold no fields, a part is unknown, or a place is outside of the cells of its part
/// @throws IoError, InputError as ResultFiles::read() and parse_vtu()
ProbedFields probe_fields(const ResultFiles& results, const casefile::Case& input,
                          const std::vector<ProbePlace>& places);

/// Time, and temperature and displacement of each place.
std::vector<CsvColumn> probe_columns(const ProbedFields& fields);

/// Temperatures over time; circles mark the times of the fields.
Chart probe_chart(const ProbedFields& fields, const std::string& machine);

}  // namespace deadpoint::report
