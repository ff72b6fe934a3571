#pragma once

#include <stdexcept>
#include <string>

namespace deadpoint {

/// Kind of an error, for a caller or a shell script. The values are the exit codes of the command.
enum class ErrorKind : int { input = 2, domain = 3, convergence = 4, io = 5 };

/// Base of all errors that the library throws. `what()` states the error, its place and its remedy.
class Error : public std::runtime_error {
public:
    Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
    [[nodiscard]] ErrorKind kind() const noexcept { return kind_; }
    [[nodiscard]] int exit_code() const noexcept { return static_cast<int>(kind_); }

private:
    ErrorKind kind_;
};

/// The user's input is wrong: case file, mesh, geometry, command line.
struct InputError : Error {
    explicit InputError(const std::string& message) : Error(ErrorKind::input, message) {}
};
/// A value left the range in which a law is valid, or became non-finite.
struct DomainError : Error {
    explicit DomainError(const std::string& message) : Error(ErrorKind::domain, message) {}
};
/// A solver did not reach its tolerance.
struct ConvergenceError : Error {
    explicit ConvergenceError(const std::string& message) : Error(ErrorKind::convergence, message) {}
};
/// A file or folder could not be read or written.
struct IoError : Error {
    explicit IoError(const std::string& message) : Error(ErrorKind::io, message) {}
};

}  // namespace deadpoint
