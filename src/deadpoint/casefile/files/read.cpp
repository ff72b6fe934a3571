#include "deadpoint/casefile/files/read.hpp"

#include "deadpoint/casefile/check/check.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/casefile/describe/library.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/kind_of_file.hpp"
#include "deadpoint/casefile/files/shipped.hpp"
#include "deadpoint/casefile/syntax/reader.hpp"
#include "deadpoint/error.hpp"

namespace deadpoint::casefile {
namespace {

void load_shipped(std::string_view text, const std::string& name, Library& library)
{
    Diagnostics diagnostics;
    const int file = diagnostics.sources.add(name, std::string(text));
    Document document;
    document.root = parse_toml(std::string(text), file, diagnostics);
    Reader(document, diagnostics, nullptr).read(library);
    if (diagnostics.error_count() > 0) {
        throw InputError(diagnostics.render_errors());
    }
}

}  // namespace

const Library& shipped_library()
{
    static const Library library = [] {
        Library result;
        load_shipped(shipped_materials(), "data/materials.toml", result);
        load_shipped(shipped_lubricants(), "data/lubricants.toml", result);
        return result;
    }();
    return library;
}

Document read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides, Case& value,
                   Diagnostics& diagnostics, FileAccess files)
{
    Document document = load_document(path, overrides, diagnostics, files);
    if (diagnostics.error_count() > 0 || !require_kind(document, KindOfFile::case_file, diagnostics)) {
        return document;
    }
    Reader(document, diagnostics, &shipped_library()).read(value);
    for (auto& finding : check_references(value)) {
        diagnostics.add({finding.warning ? Severity::warning : Severity::error, finding.code,
                         place_of(document.root, finding.path), finding.path, finding.message, finding.help,
                         std::nullopt, ""});
    }
    value.source = std::make_shared<CaseSource>(CaseSource{path, overrides, files, diagnostics.sources.hash().text()});
    return document;
}

ReadResult read_case(const std::filesystem::path& path, const std::vector<std::string>& overrides, FileAccess files)
{
    Diagnostics diagnostics;
    ReadResult result;
    const Document document = read_case(path, overrides, result.value, diagnostics, files);
    if (diagnostics.error_count() > 0) {
        throw CaseError(diagnostics.render_errors(), as_data(diagnostics));
    }
    result.warnings = diagnostics.render_warnings();
    for (std::size_t i = 0; i + overrides.size() < document.paths.size(); ++i) {
        result.files.push_back(document.paths[i]);
    }
    return result;
}

}  // namespace deadpoint::casefile
