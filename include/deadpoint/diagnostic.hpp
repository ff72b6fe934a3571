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

/// What an error says of a case, as data. CaseError and CaseDomainError have it.
class Diagnosed {
public:
    explicit Diagnosed(std::vector<Diagnostic> diagnostics) : diagnostics_(std::move(diagnostics)) {}
    virtual ~Diagnosed() = default;
    Diagnosed(const Diagnosed&) = default;
    Diagnosed& operator=(const Diagnosed&) = default;
    /// All that was found, warnings too, in the order of the files.
    [[nodiscard]] const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

/// A case with mistakes, found while it is read or later. `what()` shows all of them with their places, the lines and
/// the remedies.
class CaseError : public InputError, public Diagnosed {
public:
    CaseError(const std::string& message, std::vector<Diagnostic> diagnostics)
        : InputError(message), Diagnosed(std::move(diagnostics))
    {}
};

/// A case with values at which its laws or formulas mean nothing. `what()` as that of a CaseError.
class CaseDomainError : public DomainError, public Diagnosed {
public:
    CaseDomainError(const std::string& message, std::vector<Diagnostic> diagnostics)
        : DomainError(message), Diagnosed(std::move(diagnostics))
    {}
};

}  // namespace deadpoint
