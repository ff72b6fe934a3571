#include "deadpoint/report/probe/field_files.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/result_files.hpp"

#include <fmt/format.h>

namespace deadpoint::report {
namespace {

std::string text_of(const ResultFiles& results, const std::string& name)
{
    auto text = results.read(name);
    if (!text) {
        throw InputError(
            fmt::format("'{}' is missing\n  help: compute the case again", (results.folder() / name).string()));
    }
    return *std::move(text);
}

}  // namespace

std::vector<VtuContents> field_pieces(const ResultFiles& results, const std::string& name)
{
    const auto text = text_of(results, name);
    if (!name.ends_with(".pvtu")) {
        return {parse_vtu(text, name)};
    }
    std::vector<VtuContents> pieces;
    for (const auto& piece : parse_pvtu(text, name)) {
        pieces.push_back(parse_vtu(text_of(results, piece), piece));
    }
    return pieces;
}

const std::vector<std::int32_t>& parts_of(const VtuContents& piece)
{
    const auto* array = piece.find("part");
    const auto* values = array ? std::get_if<std::vector<std::int32_t>>(&array->values) : nullptr;
    if (values == nullptr) {
        throw InputError("a field file has no numbers of parts\n  help: compute the case again");
    }
    return *values;
}

std::vector<PvdEntry> field_times(const ResultFiles& results)
{
    const auto list = results.read("fields.pvd");
    auto entries = list ? parse_pvd(*list, "fields.pvd") : std::vector<PvdEntry>{};
    if (entries.empty()) {
        throw InputError(
            fmt::format("'{}' holds no fields\n  help: run the case with output.fields = true, or a reduced press that "
                        "'deadpoint reduce --fields' built; output.field_times adds times to the end",
                        results.folder().string()));
    }
    return entries;
}

}  // namespace deadpoint::report
