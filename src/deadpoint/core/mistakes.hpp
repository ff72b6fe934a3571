#pragma once

#include "deadpoint/diagnostic.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Mistakes of a case that are found after reading. They have a path; who holds the text of the case finds the place
/// (casefile/files/case_source.hpp).
///
/// A path leads to the key at fault: "joints.crank_pin.centre". An item of a list goes by its number, from 0, or its
/// name: "joints.crank_pin.interfaces.bush". Where a path leads nowhere, its longest beginning counts that leads to a
/// key.
namespace deadpoint {

/// One mistake. Its text is "path: message", then the help.
CaseError mistake(const std::string& path, const std::string& message, const std::string& help = {});

/// Mistakes that independent checks of a stage find, to be thrown together at its end.
class Mistakes {
public:
    /// @param code  of mistakes that do not have their own, in kebab-case
    explicit Mistakes(std::string code = "inconsistent") : code_(std::move(code)) {}

    /// Each is kept once.
    void add(const std::string& path, const std::string& message, const std::string& help = {});
    /// An error that does not say which key it is about is about `path`.
    void add(const std::string& path, const Error& error);
    /// Runs a check and adds its error.
    /// @return whether nothing was wrong
    /// @throws what is no InputError and no DomainError, as it comes
    bool attempt(const std::string& path, const std::function<void()>& check);
    [[nodiscard]] bool empty() const { return found_.empty(); }
    /// @throws CaseError with all mistakes; CaseDomainError where all of them are values out of range
    void raise() const;

private:
    void keep(Diagnostic found);

    std::string code_;
    std::vector<Diagnostic> found_;
    bool input_ = false;  ///< one of them at least is wrong input
};

/// @throws CaseError or CaseDomainError, by the kind of the error, about `path` where it does not say itself about what
[[noreturn]] void throw_about(const std::string& path, const Error& error);

/// Runs what may find a mistake; an error that does not say which key it is about is about `path`.
template <class Action>
decltype(auto) about(const std::string& path, const Action& action)
{
    try {
        return action();
    } catch (const InputError& error) {
        throw_about(path, error);
    } catch (const DomainError& error) {
        throw_about(path, error);
    }
}

/// Path of an interface by its name in a machine, "joint.interface".
std::string interface_path(const std::string& name);

/// A message, and what follows it as "\n  help: ...".
struct MessageAndHelp {
    std::string message;
    std::string help;
};
MessageAndHelp split_help(std::string_view text);

}  // namespace deadpoint
