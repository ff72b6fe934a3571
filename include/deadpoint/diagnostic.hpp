#pragma once

#include "deadpoint/error.hpp"

#include <string>
#include <utility>
#include <vector>

/// What is wrong with a case file, as data.
namespace deadpoint {

/// A place in a text that was read.
struct FilePlace {
    std::string file;  ///< as messages name it; empty: nowhere
    int line = 0;      ///< from 1; 0: the file as a whole
    int column = 0;    ///< from 1, in characters (not bytes); 0: the line as a whole
};

enum class DiagnosticSeverity { error, warning };

/// One thing that is wrong with a case, or may be.
struct Diagnostic {
    std::string path;  ///< of the key: "joints.crank_pin.diameter"; empty where no key is meant
    FilePlace place;
    DiagnosticSeverity severity = DiagnosticSeverity::error;
    std::string code;     ///< short kebab-case name of the kind of mistake: "unit-mismatch"
    std::string message;  ///< what is wrong, in one sentence
    std::string help;     ///< what to do about it; may be empty
};

/// A case with mistakes. `what()` shows all of them with their places, the lines and the remedies.
class CaseError : public InputError {
public:
    CaseError(const std::string& message, std::vector<Diagnostic> diagnostics)
        : InputError(message), diagnostics_(std::move(diagnostics))
    {}
    /// All that was found, warnings too, in the order of the files.
    [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

}  // namespace deadpoint
