#include "deadpoint/core/mistakes.hpp"

#include <algorithm>

namespace deadpoint {
namespace {

constexpr std::string_view help_mark = "\n  help: ";

std::string text_of(const Diagnostic& d)
{
    return (d.path.empty() ? "" : d.path + ": ") + d.message + (d.help.empty() ? "" : std::string(help_mark) + d.help);
}

std::string text_of(const std::vector<Diagnostic>& found)
{
    std::string text;
    for (const auto& d : found)
        text += (text.empty() ? "" : "\n") + text_of(d);
    return text;
}

Diagnostic diagnostic(const std::string& path, std::string_view code, MessageAndHelp said)
{
    return {path, {}, DiagnosticSeverity::error, std::string(code), std::move(said.message), std::move(said.help)};
}

}  // namespace

MessageAndHelp split_help(std::string_view text)
{
    const auto at = text.rfind(help_mark);
    if (at == std::string_view::npos)
        return {std::string(text), {}};
    return {std::string(text.substr(0, at)), std::string(text.substr(at + help_mark.size()))};
}

CaseError mistake(const std::string& path, const std::string& message, const std::string& help)
{
    const std::vector<Diagnostic> found{diagnostic(path, "inconsistent", {message, help})};
    return {text_of(found), found};
}

std::string interface_path(const std::string& name)
{
    if (name.find('|') != std::string::npos)
        return "bonds";
    const auto dot = name.find('.');
    return dot == std::string::npos ? "joints"
                                    : "joints." + name.substr(0, dot) + ".interfaces." + name.substr(dot + 1);
}

void throw_about(const std::string& path, const Error& error)
{
    Mistakes mistakes;
    mistakes.add(path, error);
    mistakes.raise();
    throw InputError(error.what());  // there were no diagnostics; this cannot happen
}

void Mistakes::keep(Diagnostic found)
{
    const bool known = std::ranges::any_of(
        found_, [&](const Diagnostic& d) { return d.path == found.path && d.message == found.message; });
    if (!known)
        found_.push_back(std::move(found));
}

void Mistakes::add(const std::string& path, const std::string& message, const std::string& help)
{
    input_ = true;
    keep(diagnostic(path, code_, {message, help}));
}

void Mistakes::add(const std::string& path, const Error& error)
{
    input_ = input_ || error.kind() == ErrorKind::input;
    if (const auto* known = dynamic_cast<const Diagnosed*>(&error)) {
        for (const auto& found : known->diagnostics())
            keep(found);
        return;
    }
    const auto code = error.kind() == ErrorKind::input ? std::string_view(code_) : "out-of-range";
    keep(diagnostic(path, code, split_help(error.what())));
}

bool Mistakes::attempt(const std::string& path, const std::function<void()>& check)
{
    try {
        check();
        return true;
    } catch (const InputError& error) {
        add(path, error);
    } catch (const DomainError& error) {
        add(path, error);
    }
    return false;
}

void Mistakes::raise() const
{
    if (found_.empty())
        return;
    if (input_)
        throw CaseError(text_of(found_), found_);
    throw CaseDomainError(text_of(found_), found_);
}

}  // namespace deadpoint
