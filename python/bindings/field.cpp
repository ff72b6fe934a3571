/// deadpoint._field: meshes, loads, heat and full runs for Python. It brings PETSc, MPI and Gmsh.
#include "deadpoint/api/results.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/bare_machine.hpp"
#include "deadpoint/fem/algebra/product_kernels.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/study/pipeline/loads.hpp"
#include "deadpoint/study/pipeline/press.hpp"
#include "deadpoint/study/pipeline/run.hpp"
#include "deadpoint/study/result/heat_tables.hpp"
#include "deadpoint/study/result/loads_result.hpp"
#include "run_data.hpp"
#include "run_folder.hpp"
#include "support.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <set>
#include <utility>

namespace deadpoint::python {
namespace {

namespace fs = std::filesystem;

using CasePointer = std::shared_ptr<const CaseData>;

/// MPI and PETSc, from the first use to the end of the interpreter.
std::unique_ptr<fem::Session>& session()
{
    static std::unique_ptr<fem::Session> kept;
    return kept;
}

/// Runs work without the lock of the interpreter, in one thread at a time, since PETSc and Gmsh are not thread-safe.
template <class Work>
auto compute(const CaseData& of, const Work& work)
{
    static std::mutex one;
    const py::gil_scoped_release unlocked;
    const std::lock_guard lock(one);
    if (!session() && !fem::is_open())
        session() = std::make_unique<fem::Session>();
    return casefile::with_places(of.value(), work);
}

/// A press with its mesh and its model, which later runs share. All that live are known, since their models must be
/// gone before MPI and PETSc close.
struct FieldPress {
    FieldPress(CasePointer of_, double size) : of(std::move(of_)), press(of->value(), size) { living().insert(this); }
    ~FieldPress() { living().erase(this); }
    FieldPress(const FieldPress&) = delete;

    static std::set<FieldPress*>& living()
    {
        static std::set<FieldPress*> all;
        return all;
    }

    CasePointer of;
    study::Press press;
};

/// At the end of the interpreter, which may destroy objects later.
void close_session()
{
    for (auto* press : FieldPress::living())
        press->press.drop_model();
    session().reset();
}

void take(FieldPress& press, const CasePointer& of)
{
    compute(*of, [&] { press.press.take(of->value()); });
    press.of = of;
}

py::list check(const CasePointer& of, double size)
{
    auto found = of->read.diagnostics;
    const auto add = [&](const Diagnosed& error) {
        found.insert(found.end(), error.diagnostics().begin(), error.diagnostics().end());
    };
    try {
        Observer silent;
        compute(*of, [&] { study::Press(of->value(), size).check(silent); });
    } catch (const CaseError& error) {
        add(error);
    } catch (const CaseDomainError& error) {
        add(error);
    }
    return findings(found);
}

// ---------------------------------------------------------------- tables before a run

py::dict loads(FieldPress& press, int segment, py::object receiver)
{
    PythonObserver observer(std::move(receiver));
    const auto found = compute(*press.of, [&] {
        return public_loads(press.press.loads(segment_of(press.of->value(), segment, true), observer));
    });
    observer.raise();
    py::list series;
    for (const auto& one : found.series())
        series.append(py::make_tuple(std::string(kind_name(one.kind)), one.name, one.quantity, one.unit, one.values));
    py::dict result;
    result["segment"] = found.segment;
    result["speed"] = found.speed;
    result["stroke"] = found.stroke;
    result["time"] = found.time();
    result["angle"] = found.angle;
    result["series"] = series;
    result["warnings"] = found.warnings;
    return result;
}

py::dict heat(FieldPress& press, int segment, py::object receiver)
{
    PythonObserver observer(std::move(receiver));
    const auto found = compute(*press.of, [&] {
        return public_tables(press.press.heat_tables(segment_of(press.of->value(), segment, false), observer));
    });
    observer.raise();
    py::list joints, conductances, films;
    for (const auto& row : found.joints)
        joints.append(py::make_tuple(row.name, row.law, row.lubricant, row.joints, row.heat));
    for (const auto& row : found.conductances)
        conductances.append(py::make_tuple(row.joint, row.interface, row.law, row.area, row.conductance));
    for (const auto& row : found.films)
        films.append(py::make_tuple(row.surface, row.law, row.area, row.ambient, row.speed, row.rise, row.coefficient,
                                    row.in_range));
    py::dict result;
    result["segment"] = found.segment;
    result["speed"] = found.speed;
    result["temperatures"] = found.temperatures;
    result["joints"] = joints;
    result["conductances"] = conductances;
    result["films"] = films;
    result["warnings"] = found.warnings;
    return result;
}

py::dict mesh(FieldPress& press, py::object receiver)
{
    PythonObserver observer(std::move(receiver));
    const auto* machine = compute(*press.of, [&] { return &press.press.machine(observer); });
    observer.raise();
    py::dict parts, result;
    for (const auto& part : machine->parts)
        parts[py::str(part.name)] = part.cell_count;
    result["cells"] = machine->cells.size();
    result["nodes"] = machine->nodes.size();
    result["half_model"] = machine->half_model;
    result["parts"] = parts;
    return result;
}

// ---------------------------------------------------------------- runs

/// What a run writes into its folder.
void add_files(study::RunOptions& options, const std::string& path, const casefile::Case& input,
               const std::vector<std::string>& warnings)
{
    options.state_file = path + "/state.bin";
    options.field_folder = input.output.fields ? path : std::string{};
    options.comments = {"deadpoint " + std::string(library_version()),
                        "case " + input.machine.name + ", hash " + casefile::case_hash(input)};
    for (const auto& warning : warnings)
        options.comments.push_back("warning: " + warning);
    options.view = true;
}

study::RunOptions run_options(const std::optional<fs::path>& start_from)
{
    study::RunOptions options;
    options.causes = true;
    if (start_from) {
        report::ResultFiles(*start_from).check("state.bin");
        options.start_from = (*start_from / "state.bin").string();
    }
    return options;
}

std::shared_ptr<RunData> run(FieldPress& press, const std::optional<fs::path>& target, bool replace,
                             const std::optional<fs::path>& start_from, py::object receiver)
{
    auto data = std::make_shared<RunData>();
    data->of = press.of;
    const auto& input = press.of->value();
    PythonObserver observer(std::move(receiver));
    compute(*press.of, [&] {
        const auto start = std::chrono::steady_clock::now();
        auto options = run_options(start_from);
        std::optional<RunFolder> folder;
        if (target)
            folder.emplace(*target, replace, *press.of);
        press.press.mesh(observer);
        if (folder)
            add_files(options, folder->path(), input, observer.warnings);
        data->result = press.press.run(options, observer);
        data->result.timings.insert(data->result.timings.begin(), {"mesh", press.press.mesh_seconds()});
        const auto& machine = press.press.machine(observer);
        if (folder)
            folder->write(input, machine, data->result, observer.warnings);
        data->machine = std::make_shared<const Machine>(without_mesh(machine));
        data->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    });
    observer.raise();
    data->warnings = std::move(observer.warnings);
    return data;
}

}  // namespace

PYBIND11_MODULE(_field, module)
{
    using py::arg;
    translate_errors();
    fem::choose_product_kernels();
    py::module_::import("deadpoint._reduced");  // declares Case and Run
    module.doc() = "Meshes, loads, heat and full runs. Brings PETSc, MPI and Gmsh.";
    py::module_::import("atexit").attr("register")(py::cpp_function(&close_session));
    module.def("check", &check, arg("case"), arg("size"));

    py::class_<FieldPress, std::shared_ptr<FieldPress>>(module, "FieldPress")
        .def(py::init<CasePointer, double>(), arg("case"), arg("size"))
        .def("take", &take, arg("case"))
        .def("mesh", &mesh, arg("receiver"))
        .def("loads", &loads, arg("segment"), arg("receiver"))
        .def("heat", &heat, arg("segment"), arg("receiver"))
        .def("run", &run, arg("folder"), arg("replace"), arg("start_from"), arg("receiver"));
}

}  // namespace deadpoint::python
