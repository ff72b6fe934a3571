/// deadpoint._field: meshes, loads, heat and full runs for Python. It brings PETSc, MPI and Gmsh.
#include "deadpoint/api/full/press_parts.hpp"
#include "deadpoint/api/full/result_writer.hpp"
#include "deadpoint/api/twin/listener.hpp"
#include "deadpoint/api/twin/results.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/bare_machine.hpp"
#include "deadpoint/fem/algebra/product_kernels.hpp"
#include "deadpoint/fem/algebra/session.hpp"
#include "deadpoint/full/run/press.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/problem/heat_tables.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "run_data.hpp"
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
    FieldPress(CasePointer of_, double size) : of(std::move(of_)), press(of->value(), size)
    {
        require_scale(size);
        living().insert(this);
    }
    ~FieldPress() { living().erase(this); }
    FieldPress(const FieldPress&) = delete;

    static std::set<FieldPress*>& living()
    {
        static std::set<FieldPress*> all;
        return all;
    }

    CasePointer of;
    full::Press press;
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
    require_scale(size);
    PythonObserver observer{py::none()};
    const auto found = compute(*of, [&] {
        full::Press press(of->value(), size);
        return check_press(of->read, press, observer);
    });
    observer.raise_or_stop();
    return findings(found);
}

// ---------------------------------------------------------------- tables before a run

py::dict loads(FieldPress& press, int segment, py::object receiver)
{
    PythonObserver observer(std::move(receiver));
    const auto found = compute(*press.of, [&] {
        return public_loads(press.press.loads(segment_of(press.of->value(), segment, true), observer));
    });
    observer.raise_or_stop();
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
    observer.raise_or_stop();
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
    observer.raise_or_stop();
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

std::shared_ptr<RunData> run(FieldPress& press, const fs::path& target, bool replace,
                             const std::optional<fs::path>& start_from, py::object receiver)
{
    auto data = std::make_shared<RunData>();
    data->of = press.of;
    PythonObserver observer(std::move(receiver));
    compute(*press.of, [&] {
        const auto start = std::chrono::steady_clock::now();
        Listener listener(observer);
        ResultWriter writer({target, replace, start_from.value_or(fs::path{})}, press.of->read.files);
        data->result = writer.run(press.press, press.of->read.warnings, listener);
        data->warnings = listener.warnings;
        data->machine = std::make_shared<const Machine>(without_mesh(press.press.machine(listener)));
        data->seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    });
    observer.raise();
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
