#include "deadpoint/casefile/files/kind_of_file.hpp"

#include "deadpoint/casefile/syntax/diagnostics.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string_view>
#include <vector>

namespace deadpoint::casefile {
namespace {

struct Kind {
    KindOfFile kind;
    std::string_view name;
    std::vector<std::string_view> marks;  ///< keys that no other kind has
    std::string_view use;                 ///< commands that take it
};

const std::array<Kind, 4>& kinds()
{
    static const std::array<Kind, 4> all{
        {{KindOfFile::case_file,
          "a case",
          {"machine", "bodies", "parts", "joints", "operation"},
          "'deadpoint check', 'deadpoint run' and the other commands of one case take it; a study names it as `base`"},
         {KindOfFile::study,
          "a study",
          {"base", "sets", "sensitivity", "optimise"},
          "'deadpoint sweep', 'deadpoint sensitivity' and 'deadpoint optimise' take it; the case is its `base`"},
         {KindOfFile::calibration,
          "a calibration",
          {"parameters", "runs", "sensors"},
          "'deadpoint calibrate CASE FILE' takes it, after the case"},
         {KindOfFile::reference,
          "a reference",
          {"rises", "curves", "times", "loads", "claims"},
          "'deadpoint compare RESULTS FILE' takes it, after the results"}}};
    return all;
}

bool is_of(const Kind& kind, const Node& root)
{
    return std::ranges::any_of(kind.marks, [&](auto mark) { return root.find(mark) != nullptr; });
}

}  // namespace

bool require_kind(const Document& document, KindOfFile wanted, Diagnostics& diagnostics)
{
    const Node& root = document.root;
    const auto own = std::ranges::find(kinds(), wanted, &Kind::kind);
    if (is_of(*own, root)) {
        return true;
    }
    for (const Kind& other : kinds()) {
        if (is_of(other, root)) {
            diagnostics.add({Severity::error, "wrong-file", root.place, "",
                             fmt::format("this is {} file, and {} file is needed here", other.name, own->name),
                             std::string(other.use), std::nullopt, ""});
            return false;
        }
    }
    return true;
}

}  // namespace deadpoint::casefile
