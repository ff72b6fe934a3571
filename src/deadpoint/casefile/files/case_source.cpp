#include "deadpoint/casefile/files/case_source.hpp"

#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/casefile/syntax/document.hpp"

#include <algorithm>
#include <fmt/format.h>
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

/// The texts of a case, read again into `sources`.
/// @return nothing if they can no longer be read as before
std::optional<Document> read_again(const CaseSource& source, Diagnostics& sources)
{
    try {
        Document document = load_document(source.path, source.overrides, sources, source.files);
        if (sources.size() == 0 && sources.sources.hash().text() == source.hash)
            return document;
    } catch (const Error&) {
        return std::nullopt;
    }
    return std::nullopt;
}

/// @return nothing if the texts can no longer be read as before
template <class Found>
std::optional<Diagnostics> found_in(const CaseSource& source, Severity severity, const std::vector<Found>& found)
{
    Diagnostics result;
    const auto document = read_again(source, result);
    if (!document)
        return std::nullopt;
    for (const auto& d : found)
        result.add({severity, d.code, place_of(document->root, d.path), d.path, d.message, d.help, {}, {}});
    return result;
}

template <class Kind>
Kind with_its_places(const Kind& error, const Case& input)
{
    if (!input.source || has_places(error.diagnostics()))
        return error;
    const auto found = found_in(*input.source, Severity::error, error.diagnostics());
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

void stop_at_errors(const Diagnostics& found, std::string_view outcome)
{
    if (found.error_count() > 0)
        throw CaseError(found.render_errors(outcome), as_data(found));
}

std::vector<std::string> placed_warnings(const Case& input, const std::vector<Finding>& found)
{
    if (found.empty())
        return {};
    if (input.source)
        if (const auto placed = found_in(*input.source, Severity::warning, found))
            return placed->render_warnings();
    std::vector<std::string> texts;
    for (const auto& item : found)
        texts.push_back(fmt::format("{}: {}; {}", item.path, item.message, item.help));
    return texts;
}

CaseError placed(const CaseError& error, const Case& input) { return with_its_places(error, input); }

CaseDomainError placed(const CaseDomainError& error, const Case& input) { return with_its_places(error, input); }

}  // namespace deadpoint::casefile
