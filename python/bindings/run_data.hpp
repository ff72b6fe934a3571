#pragma once

#include "deadpoint/api/twin/diagnostics.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press.hpp"
#include "deadpoint/press/result/run_result.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

/// The objects that pass from one extension module to the other; deadpoint._reduced declares them to Python.
namespace deadpoint::python {

/// A case that was read.
struct CaseData {
    std::filesystem::path file;
    ReadOptions options;
    CheckedCase read;
    [[nodiscard]] const casefile::Case& value() const { return read.value; }
};

/// A finished run.
struct RunData {
    std::shared_ptr<const CaseData> of;
    std::shared_ptr<const Machine> machine;
    press::RunResult result;
    std::vector<std::string> warnings;
    double seconds = 0;  ///< wall time inside the library
};

}  // namespace deadpoint::python
