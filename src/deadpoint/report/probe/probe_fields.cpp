#include "deadpoint/report/probe/probe_fields.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/core/quantity.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/read_vtu.hpp"
#include "deadpoint/press/run/field_place.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/probe/field_files.hpp"
#include "deadpoint/report/tables/svg_chart.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <set>

namespace deadpoint::report {
namespace {

constexpr double allowed_outside = 0.1;  ///< of the size of a cell; an eighth of a circle bulges by this share

std::vector<std::string> split(const std::string& text)
{
    std::vector<std::string> pieces(1);
    for (const char c : text) {
        if (c == ',') {
            pieces.emplace_back();
        } else {
            pieces.back() += c;
        }
    }
    return pieces;
}

std::string trimmed(const std::string& text)
{
    const auto first = text.find_first_not_of(' ');
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

ProbePlace place_of(const std::string& text)
{
    const auto equals = text.find('=');
    const auto pieces = split(equals == std::string::npos ? text : text.substr(equals + 1));
    if (pieces.size() != 4) {
        throw InputError(
            fmt::format("--at '{}' is not a place\n  help: give the part and its three coordinates with units, like "
                        "--at \"frame,0 mm,120 mm,-30 mm\"",
                        text));
    }
    ProbePlace place{trimmed(equals == std::string::npos ? text : text.substr(0, equals)), trimmed(pieces[0]), {}};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto value = try_parse_quantity(pieces[i + 1], Dimension::length);
        if (const auto* problem = std::get_if<QuantityProblem>(&value)) {
            throw InputError(fmt::format("--at '{}': {} of the place: {}\n  help: {}", text, "xyz"[i],
                                         problem -> message, problem -> help));
        }
        place.position[i] = std::get<double>(value);
    }
    return place;
}

std::int32_t part_number(const casefile::Case& input, const ProbePlace& place)
{
    const auto found = input.parts.find(place.part);
    if (found != input.parts.end()) {
        return static_cast<std::int32_t>(std::distance(input.parts.begin(), found));
    }
    std::vector<std::string> names;
    for (const auto& [name, part] : input.parts) {
        names.push_back(name);
    }
    const auto near = closest_name(place.part, names);
    throw InputError(fmt::format("--at '{}': the results have no part '{}'\n  help: {}", place.name, place.part,
                                 near.empty() ? fmt::format("they have {}", fmt::join(names, ", "))
                                              : fmt::format("did you mean '{}'?", near)));
}

/// A place in one of the pieces.
struct PlaceInPieces {
    std::size_t piece = 0;
    press::FieldPlace place;
};

PlaceInPieces find(const std::vector<VtuContents>& pieces, std::int32_t part, const Vec3& position)
{
    PlaceInPieces best;
    best.place.outside = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const auto found = press::find_place(pieces[k].grid, parts_of(pieces[k]), part, position);
        if (found.outside < best.place.outside) {
            best = {k, found};
        }
    }
    return best;
}

void require_inside(const ProbePlace& place, const press::FieldPlace& found)
{
    if (!std::isfinite(found.outside)) {
        throw InputError(fmt::format(
            "--at '{}': part '{}' has no cells in the fields\n  help: in a half model, name the part on the "
            "side x <= 0",
            place.name, place.part));
    }
    if (found.outside > allowed_outside * found.cell_size) {
        throw InputError(fmt::format(
            "--at '{}': the place is {:.4g} mm outside of part '{}'\n  help: its nearest place is {:.6g} mm,"
            "{:.6g} mm,{:.6g} mm",
            place.name, 1e3 * found.outside, place.part, 1e3 * found.nearest[0], 1e3 * found.nearest[1],
            1e3 * found.nearest[2]));
    }
}

/// The values of an array at a place, one for each component; empty if there is no such array.
std::vector<double> values_at(const VtuContents& piece, const press::FieldPlace& place, const std::string& name)
{
    const auto* array = piece.find(name);
    if (array == nullptr || array->place != VtuArray::Place::point) {
        return {};
    }
    const auto components = static_cast<std::size_t>(array->components);
    std::vector<double> result(components, 0.0);
    std::visit(
        [&](const auto& values) {
            for (std::size_t k = 0; k < place.nodes.size(); ++k) {
                for (std::size_t i = 0; i < components && place.weights[k] != 0; ++i) {
                    result[i] += place.weights[k] * static_cast<double>(values[components * place.nodes[k] + i]);
                }
            }
        },
        array->values);
    return result;
}

void add_time(const std::vector<VtuContents>& pieces, const PlaceInPieces& at, ProbedPlace& to)
{
    const auto& piece = pieces.at(at.piece);
    const auto temperature = values_at(piece, at.place, "temperature [degC]");
    if (temperature.empty()) {
        throw InputError("a field file has no temperature\n  help: compute the case again");
    }
    to.temperature.push_back(temperature[0]);
    if (const auto moved = values_at(piece, at.place, "displacement [mm]"); moved.size() == 3) {
        to.displacement.push_back({moved[0], moved[1], moved[2]});
    }
}

}  // namespace

std::vector<ProbePlace> probe_places(const std::vector<std::string>& texts)
{
    std::vector<ProbePlace> places;
    std::set<std::string> names;
    for (const auto& text : texts) {
        places.push_back(place_of(text));
        if (!names.insert(places.back().name).second) {
            throw InputError(fmt::format("--at names two places '{}'\n  help: give each its own name, like "
                                         "--at \"tip=frame,0 mm,120 mm,-30 mm\"",
                                         places.back().name));
        }
    }
    return places;
}

ProbedFields probe_fields(const ResultFiles& results, const casefile::Case& input,
                          const std::vector<ProbePlace>& places)
{
    std::vector<std::int32_t> parts;
    ProbedFields fields;
    for (const auto& place : places) {
        parts.push_back(part_number(input, place));
        fields.places.push_back({place, 0, {}, {}});
    }
    std::vector<PlaceInPieces> found;
    for (const auto& [time, file] : field_times(results)) {
        const auto pieces = field_pieces(results, file);
        for (std::size_t k = found.size(); k < places.size(); ++k) {  // all fields of a run have one mesh
            found.push_back(find(pieces, parts[k], places[k].position));
            require_inside(places[k], found[k].place);
            fields.places[k].outside = found[k].place.outside;
        }
        fields.times.push_back(time);
        for (std::size_t k = 0; k < places.size(); ++k) {
            add_time(pieces, found[k], fields.places[k]);
        }
    }
    return fields;
}

std::vector<CsvColumn> probe_columns(const ProbedFields& fields)
{
    std::vector<CsvColumn> columns{{"time", "s", fields.times}};
    for (const auto& probed : fields.places) {
        columns.push_back({probed.place.name + " temperature", "degC", probed.temperature});
        for (std::size_t i = 0; i < 3 && !probed.displacement.empty(); ++i) {
            std::vector<double> moved;
            for (const auto& at_time : probed.displacement) {
                moved.push_back(1e3 * at_time[i]);
            }
            columns.push_back({fmt::format("{} displacement {}", probed.place.name, "xyz"[i]), "um", std::move(moved)});
        }
    }
    return columns;
}

Chart probe_chart(const ProbedFields& fields, const std::string& machine)
{
    Chart chart;
    chart.title = "Temperature of places asked for";
    chart.subtitle = machine + ", from its fields";
    chart.x_label = "time [h]";
    chart.y_label = "temperature [degC]";
    chart.marker_note = "times with fields";
    chart.include_zero = false;
    for (const auto& probed : fields.places) {
        ChartSeries series;
        series.name = probed.place.name;
        series.y = probed.temperature;
        for (std::size_t k = 0; k < fields.times.size(); ++k) {
            series.x.push_back(fields.times[k] / 3600);
            series.markers.push_back({series.x[k], series.y[k]});
        }
        chart.series.push_back(std::move(series));
    }
    return chart;
}

}  // namespace deadpoint::report
