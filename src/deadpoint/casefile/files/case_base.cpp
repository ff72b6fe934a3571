#include "deadpoint/casefile/files/case_base.hpp"

#include "deadpoint/casefile/check/check.hpp"
#include "deadpoint/casefile/describe/findings.hpp"
#include "deadpoint/casefile/describe/library.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/syntax/reader.hpp"
#include "deadpoint/casefile/syntax/value_texts.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

namespace deadpoint::casefile {
namespace {

/// The sections of a case, by their description.
class Sections final : public ValueTexts {
public:
    std::set<std::string, std::less<>> groups, required;

protected:
    void put(const Key& key, std::optional<std::string>) override { note(key); }
    bool begin_table(const Key& key, bool) override { return note(key); }
    bool begin_list(const Key& key, std::size_t&) override { return note(key); }
    bool begin_group(const Key& key, std::vector<std::string>&, std::string_view) override
    {
        groups.emplace(key.name);
        return note(key);
    }

private:
    bool note(const Key& key)
    {
        if (key.need == Need::required) {
            required.emplace(key.name);
        }
        return false;
    }
};

/// By section, the tables in it that overrides touch.
using Touched = std::map<std::string, std::set<std::string>, std::less<>>;

/// @return nothing if an override sets a whole section
std::optional<Touched> touched_by(const std::vector<std::string>& overrides)
{
    Touched result;
    for (const auto& text : overrides) {
        const auto steps = override_steps(text);
        if (steps.size() < 2) {
            return std::nullopt;
        }
        result[steps[0]].insert(steps[1]);
    }
    return result;
}

Node without_children(const Node& node)
{
    return {node.kind,   node.place,   node.key_place, node.key,  node.text,
            node.number, node.integer, node.flag,      node.near, {}};
}

Node with_members(const Node& group, const std::set<std::string>& names)
{
    auto result = without_children(group);
    for (const auto& child : group.children) {
        if (names.contains(child.key)) {
            result.children.push_back(child);
        }
    }
    return result;
}

}  // namespace

CaseBase::CaseBase(std::filesystem::path path, FileAccess files) : path_(std::move(path)), files_(files)
{
    Diagnostics diagnostics;
    Case value;
    document_ = read_case(path_, {}, value, diagnostics, files_);
    if (diagnostics.error_count() == 0) {
        base_ = std::move(value);
    }
    texts_ = diagnostics.sources.hash();
    Sections sections;
    Case empty;
    describe(sections, empty);
    groups_ = std::move(sections.groups);
    required_ = std::move(sections.required);
}

Case CaseBase::with(const std::vector<std::string>& overrides) const
{
    if (auto found = changed(overrides)) {
        return *std::move(found);
    }
    return read_case(path_, overrides, files_).value;
}

std::optional<Document> CaseBase::touched(const std::vector<std::string>& overrides) const
{
    const auto touched = touched_by(overrides);
    if (!touched) {
        return std::nullopt;
    }
    Document result{without_children(document_.root), document_.folder, 0, document_.paths};
    for (const auto& child : document_.root.children) {
        const auto found = touched->find(child.key);
        const bool is_touched = found != touched->end();
        if (!is_touched && !required_.contains(child.key)) {
            continue;
        }
        result.root.children.push_back(groups_.contains(child.key)
                                           ? with_members(child, is_touched ? found->second : std::set<std::string>{})
                                           : child);
    }
    return result;
}

std::optional<Case> CaseBase::changed(const std::vector<std::string>& overrides) const
{
    auto document = base_ ? touched(overrides) : std::nullopt;
    if (!document) {
        return std::nullopt;
    }
    Diagnostics diagnostics;
    apply_overrides(*document, overrides, diagnostics);
    auto result = *base_;
    Reader(*document, diagnostics, &shipped_library()).read(result);
    const auto is_error = [](const Finding& finding) { return !finding.warning; };
    if (diagnostics.error_count() > 0 || std::ranges::any_of(check_references(result), is_error)) {
        return std::nullopt;
    }
    result.source =
        std::make_shared<CaseSource>(CaseSource{path_, overrides, files_, diagnostics.sources.hash(texts_).text()});
    return result;
}

}  // namespace deadpoint::casefile
