#include "deadpoint/casefile/files/case_source.hpp"

#include "deadpoint/casefile/syntax/document.hpp"

#include <algorithm>
#include <optional>

namespace deadpoint::casefile {
namespace {

FilePlace place_in(const Sources& sources, const Place& place)
{
    if (place.file < 0)
        return {};
    return {sources.name(place.file), place.line, place.line > 0 ? place.column : 0};
}

DiagnosticSeverity severity_of(Severity severity)
{
    return severity == Severity::error ? DiagnosticSeverity::error : DiagnosticSeverity::warning;
}

bool has_places(const std::vector<deadpoint::Diagnostic>& found)
{
    return std::ranges::any_of(found, [](const deadpoint::Diagnostic& d) { return !d.place.file.empty(); });
}

/// @return nothing if the texts can no longer be read as before
std::optional<Diagnostics> found_in(const CaseSource& source, const std::vector<deadpoint::Diagnostic>& found)
{
    Diagnostics result;
    Document document;
    try {
        document = load_document(source.path, source.overrides, result, source.files);
    } catch (const Error&) {
        return std::nullopt;
    }
    if (result.size() > 0 || result.sources.hash() != source.hash)
        return std::nullopt;
    for (const auto& d : found)
        result.add({Severity::error, d.code, place_of(document.root, d.path), d.path, d.message, d.help, {}, {}});
    return result;
}

template <class Kind>
Kind with_its_places(const Kind& error, const Case& input)
{
    if (!input.source || has_places(error.diagnostics()))
        return error;
    const auto found = found_in(*input.source, error.diagnostics());
    return found ? Kind(found->render_errors("the case"), as_data(*found)) : error;
}

}  // namespace

std::vector<deadpoint::Diagnostic> as_data(const Diagnostics& found)
{
    std::vector<deadpoint::Diagnostic> result;
    for (const auto& item : found.items())
        result.push_back({item.path, place_in(found.sources, item.place), severity_of(item.severity), item.code,
                          item.message, item.help});
    return result;
}

CaseError placed(const CaseError& error, const Case& input) { return with_its_places(error, input); }

CaseDomainError placed(const CaseDomainError& error, const Case& input) { return with_its_places(error, input); }

}  // namespace deadpoint::casefile
