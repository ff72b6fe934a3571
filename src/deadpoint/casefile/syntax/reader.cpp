#include "deadpoint/casefile/syntax/reader.hpp"

#include "deadpoint/casefile/syntax/value_texts.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/names/suggest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>

namespace deadpoint::casefile {
namespace {

template <class Names>
std::string joined(const Names& names, std::string_view quote)
{
    std::string text;
    for (const auto& name : names) {
        text += fmt::format("{}{}{}{}", text.empty() ? "" : ", ", quote, name, quote);
    }
    return text;
}

std::string range_text(const Range& range, Dimension dimension)
{
    const auto show = [&](double v) {
        if (v == 0 && dimension != Dimension::temperature) {
            return std::string("0");
        }
        return dimension == Dimension::none ? fmt::format("{}", v) : format_quantity(v, dimension);
    };
    const bool above = std::isfinite(range.min);
    const bool below = std::isfinite(range.max);
    if (above && below && range.min == range.max) {
        return fmt::format("must be {}", show(range.min));
    }
    if (above && below) {
        return fmt::format("must lie between {} and {}{}", show(range.min), show(range.max),
                           range.open ? ", both excluded" : "");
    }
    if (dimension == Dimension::temperature && above) {
        return "must lie above absolute zero";
    }
    if (above && range.min == 0) {
        return range.open ? "must be positive" : "must not be negative";
    }
    return above ? fmt::format("must be at least {}", show(range.min))
                 : fmt::format("must be at most {}", show(range.max));
}

std::string_view type_help(Node::Kind wanted)
{
    switch (wanted) {
    case Node::Kind::string:
        return "put it in quotes: \"...\"";
    case Node::Kind::boolean:
        return "write true or false, without quotes";
    case Node::Kind::array:
        return "put it in square brackets: [..., ...]";
    case Node::Kind::table:
        return "put its keys in braces, { key = value }, or below a [section]";
    default:
        return "write a bare number";
    }
}

/// A word of engineers for something that the case file calls otherwise, or does not have.
struct OtherWord {
    std::string_view word;
    std::string_view option;  ///< that stands for it
    std::string_view help;
};

constexpr std::array other_words{
    OtherWord{"spherical", "ball", "a spherical joint is a \"ball\""},
    OtherWord{"pin", "revolute", "a pin is \"revolute\""},
    OtherWord{"hinge", "revolute", "a hinge is \"revolute\""},
    OtherWord{"bearing", "revolute", "a bearing is \"revolute\""},
    OtherWord{"guide", "slide", "a guide is a \"slide\""},
    OtherWord{"prismatic", "slide", "a prismatic joint is a \"slide\""},
    OtherWord{"fixed", "revolute",
              "parts that are fixed to each other belong to one body and are bonded where they "
              "touch: remove the joint"},
};

/// Empty for a word that is not known, or where the option it stands for is not allowed.
std::string_view help_of_word(std::string_view word, std::span<const std::string_view> options)
{
    const auto found = std::ranges::find_if(other_words, [&](const OtherWord& other) {
        return other.word == word && std::ranges::find(options, other.option) != options.end();
    });
    return found == other_words.end() ? std::string_view{} : found->help;
}

bool is_plain_name(const std::string& name)
{
    const auto begins = [](unsigned char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    };
    return !name.empty() && begins(static_cast<unsigned char>(name.front())) &&
           std::ranges::all_of(name, [&](unsigned char c) { return begins(c) || c == '-' || c == '+'; });
}

}  // namespace

Reader::Reader(const Document& document, Diagnostics& diagnostics, const Library* library)
    : document_(document), diagnostics_(diagnostics), library_(library)
{}

// ---------------------------------------------------------------- frames and messages

void Reader::push(const Node& node, std::string path)
{
    frames_.push_back({&node, std::move(path), {}, diagnostics_.size(), false, {}});
}

/// Leaves a table and reports its unread keys as errors.
void Reader::pop()
{
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    if (frame.open_ended || frame.node->kind != Node::Kind::table) {
        return;
    }
    for (const auto& child : frame.node->children) {
        if (std::ranges::find(frame.known, child.key) != frame.known.end()) {
            continue;
        }
        const std::string near = closest_name(child.key, frame.known);
        const bool is_root = frame.path.empty();
        const bool is_section = is_root && child.kind == Node::Kind::table;
        report_key(child, is_section ? "unknown-section" : "unknown-key",
                   is_root ? child.key : frame.path + "." + child.key,
                   fmt::format("there is no {} '{}' here", is_section ? "section" : "key", child.key),
                   near.empty() ? fmt::format("known here: {}", joined(frame.known, ""))
                                : fmt::format("did you mean '{}'?", near));
    }
}

std::string Reader::path_of(std::string_view key) const
{
    const auto& path = frames_.back().path;
    if (key.empty()) {
        return path;
    }
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

void Reader::report(const Node& at, std::string code, std::string path, std::string message, std::string help)
{
    diagnostics_.add({Severity::error, std::move(code), at.place, std::move(path), std::move(message), std::move(help),
                      std::nullopt, ""});
}

void Reader::report_key(const Node& at, std::string code, std::string path, std::string message, std::string help)
{
    diagnostics_.add({Severity::error, std::move(code), at.key_place.file >= 0 ? at.key_place : at.place,
                      std::move(path), std::move(message), std::move(help), std::nullopt, ""});
}

const Node* Reader::take(const Key& key)
{
    auto& frame = top();
    if (std::ranges::find(frame.known, key.name) == frame.known.end()) {
        frame.known.emplace_back(key.name);
    }
    const Node* node = frame.node->find(key.name);
    if (node == nullptr && key.need != Need::optional) {
        report_missing(key);
    }
    return node;
}

void Reader::report_missing(const Key& key)
{
    const auto& frame = top();
    const Node* law = key.need == Need::of_law ? frame.node->find(frame.law) : nullptr;
    if (law != nullptr) {
        report(*law, "inconsistent", path_of(frame.law),
               fmt::format("'{}' is missing for {} = \"{}\"", key.name, frame.law, law->text),
               fmt::format("add `{}`", key.name));
    } else {
        report_key(*frame.node, "missing-key", path_of(key.name), fmt::format("'{}' is missing", key.name),
                   frame.node->near.empty() ? fmt::format("add it: {}", key.meaning)
                                            : fmt::format("did you mean '{}' instead of '{}'? Else add it: {}",
                                                          frame.node->near, frame.node->key, key.meaning));
    }
}

const Node* Reader::take(const Key& key, Node::Kind kind, std::string_view help)
{
    const Node* node = take(key);
    return node != nullptr && is_a(*node, kind, path_of(key.name), help) ? node : nullptr;
}

bool Reader::is_a(const Node& node, Node::Kind kind, const std::string& path, std::string_view help)
{
    if (node.kind == kind) {
        return true;
    }
    // A section with the wrong number of brackets.
    const bool single = kind == Node::Kind::array && node.kind == Node::Kind::table;
    const bool twice = kind == Node::Kind::table && node.kind == Node::Kind::array && !node.children.empty() &&
                       node.children.front().kind == Node::Kind::table;
    const std::string brackets = single  ? fmt::format("; as a section, [[{}]]", path)
                                 : twice ? fmt::format("; as a section, [{}] in single brackets", path)
                                         : "";
    report(node, "wrong-type", path, fmt::format("{} where {} is needed", kind_name(node.kind), kind_name(kind)),
           std::string(help.empty() ? type_help(kind) : help) + brackets);
    return false;
}

void Reader::expect(bool holds, std::string_view key, std::string_view message, std::string_view help)
{
    auto& frame = top();
    if (holds || diagnostics_.size() > frame.errors) {
        return;
    }
    const Node* node = key.empty() ? nullptr : frame.node->find(key);
    if (node != nullptr) {
        report(*node, "inconsistent", path_of(key), std::string(message), std::string(help));
    } else {
        report_key(*frame.node, "inconsistent", path_of(""), std::string(message), std::string(help));
    }
}

// ---------------------------------------------------------------- library

void Reader::report_library(std::string_view kind, const std::string& name, const std::vector<std::string>& names)
{
    const Node* node = top().node->find("library");
    if (node == nullptr) {
        return;
    }
    const std::string near = closest_name(name, names);
    report(*node, "unknown-name", path_of("library"), fmt::format("the library has no {} '{}'", kind, name),
           near.empty() ? "it has: " + joined(names, "") : fmt::format("did you mean '{}'?", near));
}

void Reader::from_library(Material& m)
{
    if (m.library.empty() || library_ == nullptr) {
        return;
    }
    const auto found = library_->materials.find(m.library);
    if (found == library_->materials.end()) {
        return report_library("material", m.library, names_of(library_->materials));
    }
    const std::string name = m.library;
    m = found->second;
    m.library = name;
}

void Reader::from_library(Lubricant& l)
{
    if (l.library.empty() || library_ == nullptr) {
        return;
    }
    const auto found = library_->lubricants.find(l.library);
    if (found == library_->lubricants.end()) {
        return report_library("lubricant", l.library, names_of(library_->lubricants));
    }
    const std::string name = l.library;
    l = found->second;
    l.library = name;
}

// ---------------------------------------------------------------- single values

bool Reader::in_range(const Node& node, const std::string& path, double value, Dimension dimension, const Range& range)
{
    const bool inside = range.open ? value > range.min && value < range.max : value >= range.min && value <= range.max;
    if (inside) {
        return true;
    }
    const std::string shown = node.kind == Node::Kind::string ? node.text : fmt::format("{}", value);
    report(node, "out-of-range", path, fmt::format("'{}' is out of range", shown),
           "it " + range_text(range, dimension));
    return false;
}

bool Reader::read_number(const Node& node, const std::string& path, const Range& range, double& value)
{
    if (node.kind == Node::Kind::string) {
        report(node, "not-a-number", path, fmt::format("\"{}\" is text, but this key is a plain number", node.text),
               "it has no unit: write the bare number, without quotes");
        return false;
    }
    if (node.kind != Node::Kind::integer && node.kind != Node::Kind::real) {
        return is_a(node, Node::Kind::real, path, "");
    }
    if (!std::isfinite(node.number)) {
        report(node, "not-finite", path, "the number is not finite", "write a finite number");
        return false;
    }
    if (!in_range(node, path, node.number, Dimension::none, range)) {
        return false;
    }
    value = node.number;
    return true;
}

bool Reader::read_quantity(const Node& node, const std::string& path, Dimension dimension, const Range& range,
                           double& value)
{
    if (dimension == Dimension::none) {
        return read_number(node, path, range, value);
    }
    const auto& info = dimension_info(dimension);
    if (node.kind == Node::Kind::integer || node.kind == Node::Kind::real) {
        report(node, "missing-unit", path, fmt::format("a bare number, but this key needs {} with its unit", info.name),
               fmt::format("write it like \"{}\"", info.example));
        return false;
    }
    if (!is_a(node, Node::Kind::string, path, fmt::format("write it like \"{}\"", info.example))) {
        return false;
    }
    const auto result = try_parse_quantity(node.text, dimension);
    if (const auto* problem = std::get_if<QuantityProblem>(&result)) {
        report(node, problem->code, path, problem->message, problem->help);
        return false;
    }
    if (!in_range(node, path, std::get<double>(result), dimension, range)) {
        return false;
    }
    value = std::get<double>(result);
    return true;
}

void Reader::number(const Key& key, double& value, const Range& range)
{
    if (const Node* node = take(key)) {
        read_number(*node, path_of(key.name), range, value);
    }
}

void Reader::integer(const Key& key, int& value, const Range& range)
{
    const Node* node = take(key, Node::Kind::integer, "write a whole number, without quotes");
    if (node != nullptr && in_range(*node, path_of(key.name), node->number, Dimension::none, range)) {
        value = static_cast<int>(node->integer);
    }
}

void Reader::flag(const Key& key, bool& value)
{
    if (const Node* node = take(key, Node::Kind::boolean, "")) {
        value = node->flag;
    }
}

void Reader::text(const Key& key, std::string& value)
{
    const Node* node = take(key, Node::Kind::string, "");
    if (node == nullptr) {
        return;
    }
    if (node->text.empty()) {
        report(
            *node, "empty", path_of(key.name), "the text is empty",
            fmt::format("{}write here: {}", key.need == Need::required ? "" : "leave the key out, or ", key.meaning));
    }
    if (key.name == "name" && character_count(node->text) > longest_name) {
        report(*node, "too-long", path_of(key.name), fmt::format("the name is longer than {} characters", longest_name),
               "write a shorter one");
        return;
    }
    value = node->text;
}

void Reader::path(const Key& key, std::string& value)
{
    const Node* node = take(key, Node::Kind::string, "");
    if (node == nullptr || node->text.empty()) {
        return;
    }
    const auto file = static_cast<std::size_t>(std::max(node->place.file, 0));
    std::filesystem::path folder;
    if (file < document_.paths.size()) {
        folder = document_.paths[file].parent_path();
    }
    const auto full = (folder / node->text).lexically_normal();
    const bool restricted = !document_.folder.empty() && node->place.file < document_.first_override;
    if (restricted && !lies_below(full, document_.folder)) {
        report(*node, "file-outside", path_of(key.name),
               fmt::format("'{}' lies outside the folder of the case file", node->text),
               "keep all files of a case in its folder, or allow others with --allow-outside");
        return;
    }
    std::error_code error;
    if (!std::filesystem::is_regular_file(full, error)) {
        report(*node, "missing-file", path_of(key.name), fmt::format("there is no file '{}'", full.string()),
               "the path is relative to the file that names it");
    }
    value = full.string();
}

void Reader::choice(const Key& key, std::string& value, std::span<const std::string_view> options)
{
    const Node* node = take(key, Node::Kind::string, fmt::format("write one of {}", joined(options, "\"")));
    if (node == nullptr) {
        return;
    }
    if (std::ranges::find(options, node->text) == options.end()) {
        const std::string near = closest_name(node->text, {options.begin(), options.end()});
        const auto other = help_of_word(node->text, options);
        report(*node, "unknown-choice", path_of(key.name), fmt::format("'{}' is not an allowed value", node->text),
               !other.empty() ? fmt::format("{}; write one of {}", other, joined(options, "\""))
               : near.empty() ? fmt::format("write one of {}", joined(options, "\""))
                              : fmt::format("did you mean \"{}\"? Known: {}", near, joined(options, "\"")));
        return;
    }
    value = node->text;
}

void Reader::quantity(const Key& key, double& value, Dimension dimension, const Range& range)
{
    if (const Node* node = take(key)) {
        read_quantity(*node, path_of(key.name), dimension, range, value);
    }
}

void Reader::quantity(const Key& key, std::optional<double>& value, Dimension dimension, const Range& range)
{
    const Node* node = take(key);
    double number = 0;
    if (node != nullptr && read_quantity(*node, path_of(key.name), dimension, range, number)) {
        value = number;
    }
}

// ---------------------------------------------------------------- structure

std::vector<std::size_t> Reader::tagged(std::span<const std::string_view> keys, std::size_t& key,
                                        std::span<const std::string_view> values, std::size_t value,
                                        std::string_view meaning)
{
    (void)value;
    (void)meaning;
    auto& frame = top();
    const Node* found = nullptr;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        frame.known.emplace_back(keys[i]);
        const Node* node = frame.node->find(keys[i]);
        if (node == nullptr) {
            continue;
        }
        if (found != nullptr) {
            report_key(*node, "inconsistent", path_of(keys[i]), "the shape states two operations",
                       fmt::format("keep one of {}", joined(keys, "`")));
        }
        found = node;
        key = i;
    }
    const std::string options = joined(values, "\"");
    if (found == nullptr) {
        report(*frame.node, "missing-key", path_of(""), "the shape states no operation",
               fmt::format("begin it with one of {}, like add = \"box\"", joined(keys, "`")));
    } else if (is_a(*found, Node::Kind::string, path_of(keys[key]), fmt::format("write one of {}", options))) {
        const auto form = std::ranges::find(values, found->text);
        if (form != values.end()) {
            return {static_cast<std::size_t>(form - values.begin())};
        }
        const std::string near = closest_name(found->text, {values.begin(), values.end()});
        report(*found, "unknown-choice", path_of(keys[key]), fmt::format("'{}' is not a form of a shape", found->text),
               near.empty() ? fmt::format("write one of {}", options) : fmt::format("did you mean \"{}\"?", near));
    }
    frame.open_ended = true;  // its other keys cannot be checked
    return {};
}

/// Whether the table states a law's key as a law with nothing stated has it, as the resolved case does.
bool Reader::is_default(const Law& law, const std::string& key) const
{
    const auto keys = fresh_keys(law);
    const auto standard = std::ranges::find(keys, key, &LawKey::name);
    if (standard == keys.end() || !standard->text) {
        return false;
    }
    const Node& table = *frames_.back().node;
    if (const Node& value = *table.find(key);
        value.kind == Node::Kind::string && in_quotes(value.text) == *standard->text) {
        return true;
    }
    Diagnostics trial;
    Reader reader(document_, trial, library_);
    reader.push(table, frames_.back().path);
    const auto read = fresh_keys(law, &reader);
    const bool wrong = std::ranges::any_of(trial.items(), [&](const auto& item) { return item.path == path_of(key); });
    return !wrong && std::ranges::find(read, key, &LawKey::name)->text == standard->text;
}

void Reader::report_foreign(std::string_view tag, std::string_view chosen, const Node& node)
{
    if (chosen.empty()) {
        report(node, "inconsistent", path_of(node.key),
               fmt::format("'{}' belongs to a {}, and none is named", node.key, tag),
               fmt::format("add `{}`, or remove the key", tag));
    } else {
        report(node, "inconsistent", path_of(node.key),
               fmt::format("{} = \"{}\" does not use '{}'", tag, chosen, node.key),
               fmt::format("remove it, or take another {}", tag));
    }
}

void Reader::laws(std::string_view tag, std::string_view chosen, std::span<const Law> laws)
{
    const auto keys = merged_keys(laws, "");
    for (const auto& key : keys) {
        top().known.push_back(key.name);
    }
    const Node* named = top().node->find(tag);
    const std::string_view stated = named != nullptr ? std::string_view(named->text) : std::string_view();
    if (stated != chosen) {
        return;  // the program does not know which keys belong here
    }
    std::vector<LawKey> own;
    if (const auto law = std::ranges::find(laws, chosen, &Law::name); law != laws.end()) {
        top().law = tag;
        law->describe(*this);
        own = fresh_keys(*law);
    }
    for (const auto& key : keys) {
        const Node* node = top().node->find(key.name);
        const bool foreign = node != nullptr && std::ranges::find(own, key.name, &LawKey::name) == own.end();
        if (foreign && std::ranges::none_of(laws, [&](const Law& law) { return is_default(law, key.name); })) {
            report_foreign(tag, chosen, *node);
        }
    }
}

bool Reader::begin_table(const Key& key, bool present)
{
    (void)present;
    const Node* node = take(key, Node::Kind::table, "");
    if (node == nullptr) {
        return false;
    }
    push(*node, path_of(key.name));
    return true;
}

bool Reader::begin_group(const Key& key, std::vector<std::string>& names, std::string_view placeholder)
{
    (void)placeholder;
    const Node* node = take(key, Node::Kind::table, "");
    if (node == nullptr) {
        return false;
    }
    push(*node, path_of(key.name));
    top().open_ended = true;
    for (const auto& child : node->children) {
        names.push_back(child.key);
    }
    return true;
}

bool Reader::begin_member(const std::string& name)
{
    const Node* node = top().node->find(name);
    const std::string path = path_of(name);
    if (node == nullptr || !is_a(*node, Node::Kind::table, path, "")) {
        return false;
    }
    if (!is_plain_name(name)) {
        report_key(*node, "bad-name", path, fmt::format("'{}' cannot be a name", name),
                   "use letters, digits, '_', '-' and '+' only, and do not begin with '-' or '+'");
    }
    push(*node, path);
    return true;
}

bool Reader::begin_list(const Key& key, std::size_t& count)
{
    const Node* node = take(key, Node::Kind::array, "write it as a list of tables, [{ ... }, { ... }]");
    if (node == nullptr) {
        return false;
    }
    if (node->children.empty() && key.need == Need::required) {
        report(*node, "empty", path_of(key.name), "the list is empty", fmt::format("write here: {}", key.meaning));
    }
    count = node->children.size();
    push(*node, path_of(key.name));
    return true;
}

bool Reader::begin_item(std::size_t index)
{
    const Node& node = top().node->children[index];
    const std::string path = path_of(std::to_string(index));
    if (!is_a(node, Node::Kind::table, path, "")) {
        return false;
    }
    push(node, path);
    return true;
}

}  // namespace deadpoint::casefile
