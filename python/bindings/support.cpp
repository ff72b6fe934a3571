#include "support.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <filesystem>
#include <new>

namespace deadpoint::python {
namespace {

constexpr auto progress_interval = std::chrono::milliseconds(100);
constexpr auto signal_interval = std::chrono::milliseconds(50);

/// Text of any bytes: messages quote files, which need not be UTF-8.
py::object text_of(const std::string& bytes)
{
    auto* text = PyUnicode_DecodeUTF8(bytes.data(), static_cast<py::ssize_t>(bytes.size()), "backslashreplace");
    if (text == nullptr)
        throw py::error_already_set();
    return py::reinterpret_steal<py::object>(text);
}

py::object finding(const Diagnostic& found)
{
    const auto& place = found.place;
    return py::module_::import("deadpoint._errors")
        .attr("Finding")(text_of(found.path), text_of(place.file), place.line, place.column,
                         found.severity == DiagnosticSeverity::error ? "error" : "warning", found.code,
                         text_of(found.message), text_of(found.help));
}

/// @param code  exit code of the command; 0: none of its four kinds
void set_error(int code, const std::string& text, const py::list& found)
{
    const auto made = py::module_::import("deadpoint._errors").attr("error_of")(code, text_of(text), found);
    PyErr_SetObject(py::type::of(made).ptr(), made.ptr());
}

void set_error(const Error& error)
{
    const auto* diagnosed = dynamic_cast<const Diagnosed*>(&error);
    set_error(error.exit_code(), error.what(), diagnosed ? findings(diagnosed->diagnostics()) : py::list());
}

}  // namespace

py::list findings(const std::vector<Diagnostic>& diagnostics)
{
    py::list result;
    for (const auto& found : diagnostics)
        result.append(finding(found));
    return result;
}

void translate_errors()
{
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown)
                std::rethrow_exception(thrown);
        } catch (const Error& error) {
            set_error(error);
        } catch (const std::filesystem::filesystem_error& error) {
            set_error(
                IoError(std::string(error.what()) + "\n  help: check the length of the path and its permissions"));
        } catch (const py::builtin_exception&) {
            throw;  // pybind11's own, of wrong arguments
        } catch (const std::bad_alloc&) {
            set_error(0, "out of memory\n  help: take fewer values at a time, or a coarser mesh", py::list());
        } catch (const std::exception& error) {
            set_error(0, std::string(error.what()) + "\n  help: this is a defect of deadpoint; please report it",
                      py::list());
        }
    });
}

template <class Call>
void PythonObserver::tell(const Call& call)
{
    if (receiver_.is_none())
        return;
    const py::gil_scoped_acquire lock;
    try {
        if (!error_)
            call();
    } catch (py::error_already_set& error) {
        stop_for(std::move(error));
    }
}

// Ctrl-C may come while the receiver is at work. It ends the run as a request to stop, not as an error.
void PythonObserver::stop_for(py::error_already_set error) const
{
    if (!error.matches(PyExc_KeyboardInterrupt))
        error_.emplace(std::move(error));
    stop_ = true;
}

void PythonObserver::stage(std::string_view name)
{
    tell([&] { receiver_.attr("stage")(std::string(name)); });
}

void PythonObserver::progress(double fraction, std::string_view detail)
{
    const auto now = Clock::now();
    if (now - told_ < progress_interval && fraction < 1)
        return;
    told_ = now;
    tell([&] { receiver_.attr("progress")(fraction, std::string(detail)); });
}

void PythonObserver::warn(std::string_view text)
{
    if (std::ranges::find(warnings, text) != warnings.end())
        return;
    warnings.emplace_back(text);
    tell([&] { receiver_.attr("warn")(std::string(text)); });
}

bool PythonObserver::cancelled() const
{
    const auto now = Clock::now().time_since_epoch();
    if (stop_ || now - Clock::duration(asked_.load()) < signal_interval)
        return stop_;
    asked_ = now.count();
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
        stop_for(py::error_already_set());
    return stop_;
}

void PythonObserver::raise()
{
    if (error_)
        throw std::move(*error_);
}

void PythonObserver::raise_or_stop()
{
    raise();
    if (!stop_)
        return;
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
}

}  // namespace deadpoint::python
