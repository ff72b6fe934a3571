#pragma once

#include "deadpoint/error.hpp"

#include <string>
#include <utility>
#include <vector>

/// Mistakes and warnings of a case file, as data.
namespace deadpoint {

/// A place in a text that was read.
struct FilePlace {
    std::string file;  ///< as messages name it; empty: nowhere
    int line = 0;      ///< from 1; 0: the file as a whole
    int column = 0;    ///< from 1, in characters (not bytes); 0: the line as a whole
};

enum class DiagnosticSeverity { error, warning };

/// One mistake or warning of a case.
struct Diagnostic {
    std::string path;  ///< of the key: "joints.crank_pin.diameter"; empty where no key is meant
    FilePlace place;
    DiagnosticSeverity severity = DiagnosticSeverity::error;
    std::string code;     ///< short kebab-case name of the kind of mistake: "unit-mismatch"
    std::string message;  ///< the mistake, in one sentence
    std::string help;     ///< the remedy; may be empty
};

/// A case with mistakes. `what()` lists all of them with place, line and remedy.
class CaseError : public InputError {
public:
    CaseError(const std::string& message, std::vector<Diagnostic> diagnostics)
        : InputError(message), diagnostics_(std::move(diagnostics))
    {}
    /// All mistakes and warnings, in the order of the files.
    [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

}  // namespace deadpoint
