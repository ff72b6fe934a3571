#include "deadpoint/api/twin/diagnostics.hpp"

#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/syntax/diagnostics.hpp"
#include "deadpoint/casefile/syntax/document.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/read_options.hpp"

namespace deadpoint {
namespace {

std::vector<std::filesystem::path> files_of(const casefile::Document& document, std::size_t overrides,
                                            const casefile::Case& value)
{
    std::vector<std::filesystem::path> files;
    for (std::size_t i = 0; i + overrides < document.paths.size(); ++i)
        files.push_back(document.paths[i]);
    for (const auto& [name, part] : value.parts)
        for (const auto& file : {part.step, part.mesh})
            if (!file.empty())
                files.emplace_back(file);
    return files;
}

}  // namespace

void require_scale(double scale)
{
    if (!(scale >= 0.01 && scale <= 100))
        throw InputError(
            "the factor on cell sizes is not between 0.01 and 100\n  help: 1 takes the cell sizes of the case");
}

casefile::FileAccess access_of(const ReadOptions& options)
{
    return options.allow_outside ? casefile::FileAccess::anywhere : casefile::FileAccess::below;
}

CheckedCase read_with_diagnostics(const std::filesystem::path& file, const ReadOptions& options)
{
    casefile::Diagnostics found;
    CheckedCase result;
    const auto document = casefile::read_case(file, options.overrides, result.value, found, access_of(options));
    result.diagnostics = casefile::as_data(found);
    result.warnings = found.render_warnings();
    if (found.error_count() > 0)
        result.errors = found.render_errors();
    result.files = files_of(document, options.overrides.size(), result.value);
    return result;
}

}  // namespace deadpoint
