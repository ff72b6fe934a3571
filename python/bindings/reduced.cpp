/// deadpoint._reduced: cases, results and the reduced press for Python. It loads no PETSc, MPI or Gmsh.
#include "deadpoint/casefile/files/case_base.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/drift/chain.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/run/run_summary.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_folder.hpp"
#include "deadpoint/report/page/run_folder.hpp"
#include "deadpoint/report/probe/field_files.hpp"
#include "deadpoint/report/run/run_files.hpp"
#include "deadpoint/report/schema/schema.hpp"
#include "deadpoint/twin/calibrate/forward.hpp"
#include "deadpoint/twin/map/reduced_sweep.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "deadpoint/twin/run/run_sensitivities.hpp"
#include "run_data.hpp"
#include "support.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <utility>

namespace deadpoint::python {
namespace {

namespace fs = std::filesystem;

using CasePointer = std::shared_ptr<const CaseData>;
using Numbers = py::array_t<double>;

/// An array that owns its numbers.
Numbers as_array(std::vector<double> values)
{
    auto* kept = new std::vector<double>(std::move(values));
    const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<double>*>(p); });
    return Numbers(static_cast<py::ssize_t>(kept->size()), kept->data(), owner);
}

std::shared_ptr<CaseData> read_case(const fs::path& file, const std::vector<std::string>& settings, double size,
                                    bool allow_outside)
{
    auto data = std::make_shared<CaseData>();
    data->file = file;
    data->options = {settings, size, allow_outside};
    data->read = read_with_diagnostics(file, data->options);
    if (!data->read.errors.empty())
        throw CaseError(data->read.errors, std::move(data->read.diagnostics));
    return data;
}

py::dict schema_of_tables()
{
    py::dict result;
    for (const auto& file : report::schema::files()) {
        py::list columns;
        for (const auto& column : file.columns)
            columns.append(py::make_tuple(std::string(column.kind), std::string(column.heading),
                                          std::string(column.unit), std::string(column.meaning)));
        result[py::str(file.name)] = py::make_tuple(file.meaning, columns);
    }
    return result;
}

py::dict dimensions()
{
    py::dict result;
    for (const auto& dimension : report::schema::dimensions())
        result[dimension.name] = dimension.meaning;
    return result;
}

// ---------------------------------------------------------------- runs

py::dict tables_of(const RunData& run)
{
    py::dict result;
    for (auto& table : report::course_tables(run.of->value(), run.result)) {
        py::list columns;
        for (auto& column : table.columns) {
            auto* numbers = std::get_if<std::vector<double>>(&column.values);
            py::object values = numbers ? py::object(as_array(std::move(*numbers)))
                                        : py::cast(std::get<std::vector<std::string>>(column.values));
            columns.append(py::make_tuple(column.kind, column.name, column.unit, values));
        }
        result[py::str(table.file)] = columns;
    }
    return result;
}

std::string summary_of(const RunData& run)
{
    return report::summary_text(run.of->value(), *run.machine, run.result, run.warnings);
}

void write_folder(const RunData& run, const fs::path& target, bool replace_it)
{
    using enum report::ResultFolder::IfExists;
    report::ResultFolder folder(report::FolderClaim(target), replace_it ? replace : refuse, run.of->read.files);
    report::finish_run_folder(folder, run.of->value(), *run.machine, run.result, run.warnings);
}

// ---------------------------------------------------------------- folders of results

/// Bytes of a listed file that are as they were written; nothing where the folder has no such file.
std::optional<py::bytes> read_listed(const report::ResultFiles& files, const std::string& name)
{
    std::optional<std::string> text;
    {
        const py::gil_scoped_release unlocked;
        text = files.read(name);
    }
    return text ? std::optional(py::bytes(*text)) : std::nullopt;
}

/// Checks that all files are there as they were written: the sizes of all, the contents of those that are read whole.
void check_listed(const report::ResultFiles& files)
{
    const auto read_later = [](const std::string& name) {
        return name.ends_with(".vtu") || name.ends_with(".bin");  // large, and checked when they are used
    };
    for (const auto& [name, file] : files.listed())
        read_later(name) ? files.check_size(name) : files.check(name);
}

/// An array that owns its numbers, in rows where there are several components.
template <class Value>
py::array as_rows(std::vector<Value> values, int components)
{
    auto* kept = new std::vector<Value>(std::move(values));
    const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<Value>*>(p); });
    const auto count = static_cast<py::ssize_t>(kept->size());
    if (components == 1)
        return py::array_t<Value>({count}, kept->data(), owner);
    return py::array_t<Value>({count / components, static_cast<py::ssize_t>(components)}, kept->data(), owner);
}

py::dict piece_of(VtuContents& piece)
{
    std::vector<double> points;
    points.reserve(3 * piece.grid.points.size());
    for (const auto& point : piece.grid.points)
        points.insert(points.end(), point.begin(), point.end());
    std::vector<std::uint8_t> types;
    for (const auto type : piece.grid.types)
        types.push_back(static_cast<std::uint8_t>(type));
    py::dict at_points, in_cells, result;
    for (auto& array : piece.arrays)
        (array.place == VtuArray::Place::point ? at_points : in_cells)[py::str(array.name)] =
            std::visit([&](auto& values) { return as_rows(std::move(values), array.components); }, array.values);
    result["points"] = as_rows(std::move(points), 3);
    result["connectivity"] = as_rows(std::move(piece.grid.connectivity), 1);
    result["offsets"] = as_rows(std::move(piece.grid.offsets), 1);
    result["types"] = as_rows(std::move(types), 1);
    result["point_data"] = at_points;
    result["cell_data"] = in_cells;
    return result;
}

/// Grids and arrays of a field file, one of each rank.
py::list pieces_of(const report::ResultFiles& files, const std::string& name)
{
    std::vector<VtuContents> pieces;
    {
        const py::gil_scoped_release unlocked;
        pieces = report::field_pieces(files, name);
    }
    py::list result;
    for (auto& piece : pieces)
        result.append(piece_of(piece));
    return result;
}

/// Times [s] and files of the fields, in the order of their list.
std::vector<std::pair<double, std::string>> times_of_fields(const report::ResultFiles& files)
{
    if (!files.listed().contains("fields.pvd"))
        return {};
    std::vector<std::pair<double, std::string>> result;
    for (auto& entry : report::field_times(files))
        result.emplace_back(entry.time, std::move(entry.file));
    return result;
}

// ---------------------------------------------------------------- the reduced press

/// A reduced press with what its runs share. Any number of threads may use it.
struct Rom {
    explicit Rom(const fs::path& file_) : file(file_), press(twin::read_reduced(file_)) {}

    fs::path file;
    twin::ReducedPress press;
    twin::SharedParts shared;
};

std::shared_ptr<RunData> run_reduced(const std::shared_ptr<Rom>& rom, const CasePointer& of,
                                     const std::shared_ptr<Rom>& large, bool figures_only, py::object receiver)
{
    auto run = std::make_shared<RunData>();
    run->of = of;
    run->machine = std::shared_ptr<const Machine>(rom, &rom->press.machine);
    PythonObserver observer(std::move(receiver));
    {
        const py::gil_scoped_release unlocked;
        for (const auto& warning : of->read.warnings)
            observer.warn(warning);
        const auto start = std::chrono::steady_clock::now();
        const auto detail = figures_only ? twin::ReducedDetail::figures : twin::ReducedDetail::all;
        run->result = casefile::with_places(of->value(), [&] {
            return twin::run_reduced(of->value(), rom->press, {large ? &large->press : nullptr, nullptr}, detail,
                                     observer, nullptr, &rom->shared);
        });
        run->result.reduced->file = rom->file.filename().string();
        run->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    observer.raise();
    run->warnings = std::move(observer.warnings);
    return run;
}

py::dict info_of(const Rom& rom)
{
    const auto& press = rom.press;
    py::list box, errors, parts, interfaces;
    for (const auto& one : press.box)
        box.append(py::make_tuple(one.name, static_cast<int>(one.kind), one.from, one.to));
    for (const auto& error : press.errors)
        errors.append(py::make_tuple(error.of, error.temperature, error.gap));
    for (const auto& part : press.machine.parts)
        parts.append(part.name);
    for (const auto& contact : press.machine.interfaces)
        interfaces.append(contact.name);
    py::dict info;
    info["name"] = press.name;
    info["version"] = press.version;
    info["case_hash"] = press.case_hash;
    info["large_file"] = press.large_file;
    info["states"] = press.states;
    info["unknowns"] = press.unknowns;
    info["cells"] = press.cells;
    info["has_chain"] = press.chain.has_value();
    info["box"] = box;
    info["errors"] = errors;
    info["parts"] = parts;
    info["interfaces"] = interfaces;
    return info;
}

py::list outputs_of(const Rom& rom, const CasePointer& of)
{
    twin::require_fit(of->value(), rom.press);
    py::list result;
    for (const auto& output : twin::forward_outputs(of->value(), rom.press))
        result.append(
            py::make_tuple(output.kind == twin::ForwardOutput::Kind::probe ? "probe" : "dimension", output.name));
    return result;
}

py::dict sensitivities_of(const Rom& rom, const CasePointer& of, py::object receiver)
{
    PythonObserver observer(std::move(receiver));
    press::Sensitivities found;
    {
        const py::gil_scoped_release unlocked;
        found = casefile::with_places(of->value(), [&] {
            twin::require_fit(of->value(), rom.press);
            return twin::run_sensitivities(of->value(), rom.press, observer);
        });
    }
    observer.raise_or_stop();
    py::list rows;
    for (const auto& one : found.of)
        rows.append(py::make_tuple(one.coefficient, one.value, one.unit, one.change, one.gap, one.temperature));
    py::dict result;
    result["time"] = found.time;
    result["has_gap"] = found.has_gap;
    result["probes"] = found.probes;
    result["rows"] = rows;
    return result;
}

/// Keys that change together, by a factor or (shift) by a difference.
using Keys = std::tuple<std::string, std::vector<std::string>, bool>;

std::vector<twin::CaseParameter> parameters_of(const casefile::Case& input, const std::vector<Keys>& keys)
{
    using Kind = twin::CaseParameter::Kind;
    std::vector<twin::CaseParameter> result;
    for (const auto& [name, patterns, shifts] : keys)
        result.push_back({name, twin::keys_of(input, patterns, name), shifts ? Kind::shift : Kind::factor});
    return result;
}

/// Outputs over time, and their derivatives by the logarithms of factors and by shifts.
py::tuple derivatives_of(const Rom& rom, const CasePointer& of, const std::vector<Keys>& keys, int threads)
{
    twin::Forecast forecast;
    PythonObserver observer{py::none()};
    try {
        const py::gil_scoped_release unlocked;
        forecast = casefile::with_places(of->value(), [&] {
            const twin::ForwardModel model(of->value(), rom.press, parameters_of(of->value(), keys),
                                           {0, threads, nullptr});
            return model.run(std::vector<double>(keys.size(), 0.0), true, observer);
        });
    } catch (const twin::Stopped&) {
        observer.raise_or_stop();
    }
    py::list values, slopes;
    for (auto& value : forecast.value)
        values.append(as_array(std::move(value)));
    for (auto& of_parameter : forecast.derivative) {
        py::list row;
        for (auto& derivative : of_parameter)
            row.append(as_array(std::move(derivative)));
        slopes.append(row);
    }
    return py::make_tuple(as_array(std::move(forecast.time)), values, slopes);
}

// ---------------------------------------------------------------- many runs

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// Figures of the points of a map, each with one number for each point; not a number where a point failed.
class Figures {
public:
    Figures(const casefile::Case& input, std::size_t points)
        : end_(points, nothing), largest_(points, nothing), warm_up_(points, nothing), errors_(points)
    {
        for (const auto& [name, probe] : input.probes)
            probes_.emplace_back(name, std::vector<double>(points, nothing));
    }

    /// By any thread.
    void keep(std::size_t point, const casefile::Case& input, const press::RunResult& result)
    {
        for (std::size_t p = 0; p < probes_.size(); ++p)
            probes_[p].second[point] = result.thermal.probes[p].value.back();
        if (!result.drift)
            return;
        const auto summary = press::summarise(input, result);
        end_[point] = summary.final_gap;
        largest_[point] = summary.largest_gap;
        warm_up_[point] = summary.warm_up_time.value_or(nothing);
    }
    void fail(std::size_t point, std::string reason) { errors_[point] = std::move(reason); }

    /// Moves everything out.
    py::dict get()
    {
        py::dict probes, result;
        for (auto& [name, values] : probes_)
            probes[py::str(name)] = as_array(std::move(values));
        result["gap_end"] = as_array(std::move(end_));
        result["gap_largest"] = as_array(std::move(largest_));
        result["warm_up"] = as_array(std::move(warm_up_));
        result["probes"] = probes;
        result["errors"] = errors_;
        return result;
    }

private:
    std::vector<double> end_, largest_, warm_up_;
    std::vector<std::pair<std::string, std::vector<double>>> probes_;
    std::vector<std::string> errors_;
};

py::dict map_of(const Rom& rom, const CasePointer& of, const std::vector<std::vector<std::string>>& settings,
                int threads, py::object receiver)
{
    std::vector<twin::SweepPoint> points;
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < settings.size(); ++k) {
        auto overrides = of->options.overrides;
        overrides.insert(overrides.end(), settings[k].begin(), settings[k].end());
        points.push_back({std::to_string(k), std::move(overrides), {}});
        all.push_back(k);
    }
    Figures figures(of->value(), points.size());
    std::optional<casefile::CaseBase> base;  // read once for all points
    twin::ReducedSweep sweep;
    sweep.threads = std::max(threads, 1);
    sweep.read = [&](const twin::SweepPoint& point) { return base->with(point.overrides); };
    sweep.record = [&](std::size_t point, const casefile::Case& input, const press::RunResult& result) {
        figures.keep(point, input, result);
        return press::RunRecord{};
    };
    sweep.take = [&](std::size_t point, twin::EndedPoint ended) {
        if (ended.outcome.state == twin::PointOutcome::State::failed)
            figures.fail(point, ended.outcome.reason);
    };
    PythonObserver observer(std::move(receiver));
    {
        const py::gil_scoped_release unlocked;
        base.emplace(of->file, access_of(of->options));
        twin::run_points_reduced(points, all, rom.press, sweep, observer);
    }
    observer.raise();
    auto result = figures.get();
    result["interrupted"] = observer.cancelled();
    result["warnings"] = observer.warnings;
    return result;
}

}  // namespace

PYBIND11_MODULE(_reduced, module)
{
    using py::arg;
    translate_errors();
    module.doc() = "Cases, results and the reduced press. Loads no PETSc, MPI or Gmsh.";
    module.def("version", [] { return std::string(library_version()); });
    module.def("schema", &schema_of_tables);
    module.def("dimensions", &dimensions);

    py::class_<CaseData, std::shared_ptr<CaseData>>(module, "Case")
        .def(py::init(&read_case), arg("file"), arg("settings"), arg("size"), arg("allow_outside"),
             py::call_guard<py::gil_scoped_release>())
        .def_property_readonly("name", [](const CaseData& of) { return of.value().machine.name; })
        .def_property_readonly("hash", [](const CaseData& of) { return casefile::case_hash(of.value()); })
        .def_property_readonly("text", [](const CaseData& of) { return casefile::write_case(of.value()); })
        .def_property_readonly("findings", [](const CaseData& of) { return findings(of.read.diagnostics); });

    py::class_<report::ResultFiles>(module, "Files")
        .def(py::init<fs::path>(), arg("folder"), py::call_guard<py::gil_scoped_release>())
        .def_property_readonly("names",
                               [](const report::ResultFiles& files) {
                                   std::vector<std::string> names;
                                   for (const auto& [name, file] : files.listed())
                                       names.push_back(name);
                                   return names;
                               })
        .def("check", &check_listed, py::call_guard<py::gil_scoped_release>())
        .def("read", &read_listed, arg("name"))
        .def("field_times", &times_of_fields, py::call_guard<py::gil_scoped_release>())
        .def("fields", &pieces_of, arg("name"));

    py::class_<RunData, std::shared_ptr<RunData>>(module, "Run")
        .def("tables", &tables_of)
        .def("summary", &summary_of)
        .def("write", &write_folder, arg("folder"), arg("replace"), py::call_guard<py::gil_scoped_release>())
        .def_property_readonly("case_text", [](const RunData& run) { return casefile::write_case(run.of->value()); })
        .def_readonly("seconds", &RunData::seconds)
        .def_property_readonly("interrupted", [](const RunData& run) { return run.result.thermal.interrupted; })
        .def_property_readonly("warnings", [](const RunData& run) { return run.warnings; });

    py::class_<Rom, std::shared_ptr<Rom>>(module, "Rom")
        .def(py::init<const fs::path&>(), arg("file"), py::call_guard<py::gil_scoped_release>())
        .def("info", &info_of)
        .def("outputs", &outputs_of, arg("case"))
        .def(
            "misfits", [](const Rom& rom, const CasePointer& of) { return twin::misfits(of->value(), rom.press); },
            arg("case"))
        .def("run", &run_reduced, arg("case"), arg("large"), arg("figures_only"), arg("receiver"))
        .def("sensitivities", &sensitivities_of, arg("case"), arg("receiver"))
        .def("derivatives", &derivatives_of, arg("case"), arg("keys"), arg("threads"))
        .def("map", &map_of, arg("case"), arg("settings"), arg("threads"), arg("receiver"));
}

}  // namespace deadpoint::python
