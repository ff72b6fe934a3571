#pragma once

#include "deadpoint/diagnostic.hpp"
#include "deadpoint/observer.hpp"

#include <atomic>
#include <chrono>
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <vector>

/// What both extension modules share: errors, messages and the request to stop.
namespace deadpoint::python {

namespace py = pybind11;

/// From now on what the library throws reaches Python as the classes of deadpoint._errors, running out of memory and
/// failing file systems too. Wrong types of arguments stay TypeErrors.
void translate_errors();

/// Diagnostics as a list of deadpoint.Finding.
py::list findings(const std::vector<Diagnostic>& diagnostics);

/// Passes messages of a run to a Python object with the methods stage(name), progress(fraction, detail) and warn(text),
/// or to nothing. The run has released the lock of the interpreter. After Ctrl-C, and after an exception of the object,
/// the run ends at its next step. Several threads may ask whether to stop, one tells.
class PythonObserver : public Observer {
public:
    explicit PythonObserver(py::object receiver) : receiver_(std::move(receiver)) {}

    void stage(std::string_view name) override;
    void progress(double fraction, std::string_view detail) override;
    void warn(std::string_view text) override;
    [[nodiscard]] bool cancelled() const override;

    /// To be called after the run, with the lock: raises what the receiver or a handler of a signal has raised.
    void raise();
    /// The same for work that keeps nothing after Ctrl-C: it raises KeyboardInterrupt then.
    void raise_or_stop();
    std::vector<std::string> warnings;  ///< each once

private:
    using Clock = std::chrono::steady_clock;

    template <class Call>
    void tell(const Call& call);
    void stop_for(py::error_already_set error) const;

    py::object receiver_;
    Clock::time_point told_{};
    mutable std::atomic<Clock::rep> asked_ = Clock::now().time_since_epoch().count();
    mutable std::atomic<bool> stop_ = false;
    mutable std::optional<py::error_already_set> error_;  ///< used with the lock only
};

}  // namespace deadpoint::python
