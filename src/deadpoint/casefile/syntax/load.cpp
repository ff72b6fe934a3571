#include "deadpoint/casefile/syntax/document.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <sstream>

namespace deadpoint::casefile {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_text = 32U << 20U;  // [byte]; enough for thousands of parts

/// With links followed as far as the path exists; a path that cannot be one is left as it is.
fs::path real_path(const fs::path& path)
{
    std::error_code error;
    const auto real = fs::weakly_canonical(fs::absolute(path, error), error);
    return real.empty() ? path : real;
}

class Loader {
public:
    Loader(const fs::path& path, FileAccess files, Diagnostics& diagnostics) : main_(path), diagnostics_(diagnostics)
    {
        if (files == FileAccess::below) {
            document_.folder = real_path(path).parent_path();
        }
    }

    /// Values that replace those of all files, with their places.
    [[nodiscard]] const std::vector<Node>& replacements() const { return replacements_; }

    Document run()
    {
        auto text = read_file(main_, largest_text);
        if (!text) {
            throw IoError(fmt::format("there is no file '{}'\n  help: check its path and its ending", main_.string()));
        }
        std::vector<fs::path> chain{real_path(main_)};
        document_.root = load(*text, main_, chain);
        return std::move(document_);
    }

private:
    static constexpr std::size_t max_depth = 8;
    static constexpr std::size_t most_files = 1000;

    Node load(const std::string& text, const fs::path& shown, std::vector<fs::path>& chain)
    {
        size_ += text.size();
        if (size_ > largest_text) {
            throw InputError(
                fmt::format("{}: the case and what it includes are larger than {} MiB\n  help: include each file once",
                            main_.string(), largest_text >> 20U));
        }
        const int file = diagnostics_.sources.add(shown.string(), text);
        document_.paths.push_back(chain.back());
        Node root = parse_toml(text, file, diagnostics_);
        take_replacements(root);
        const auto found = std::ranges::find_if(root.children, [](const Node& n) { return n.key == "include"; });
        if (found == root.children.end()) {
            return root;
        }
        const Node include = std::move(*found);
        root.children.erase(found);
        if (include.kind != Node::Kind::array) {
            report("wrong-type", include.place, "include", "needs a list of file names",
                   "write it like include = [\"parts.toml\"]");
            return root;
        }
        for (const auto& item : include.children) {
            load_include(item, shown, chain, root);
        }
        return root;
    }

    void take_replacements(Node& root)
    {
        const auto found = std::ranges::find_if(root.children, [](const Node& n) { return n.key == "replace"; });
        if (found == root.children.end()) {
            return;
        }
        const Node replace = std::move(*found);
        root.children.erase(found);
        const bool texts =
            replace.kind == Node::Kind::array &&
            std::ranges::all_of(replace.children, [](const Node& n) { return n.kind == Node::Kind::string; });
        if (!texts) {
            report("wrong-type", replace.place, "replace", "needs a list of texts path=value",
                   "write it like replace = [\"oil.pins=300 W/m^2/K\"]");
            return;
        }
        replacements_.insert(replacements_.end(), replace.children.begin(), replace.children.end());
    }

    void load_include(const Node& item, const fs::path& shown, std::vector<fs::path>& chain, Node& root)
    {
        if (item.kind != Node::Kind::string) {
            report("wrong-type", item.place, "include", fmt::format("{} is not a file name", kind_name(item.kind)),
                   "write it like include = [\"parts.toml\"]");
            return;
        }
        const fs::path path = real_path(chain.back().parent_path() / item.text);
        if (!document_.folder.empty() && !lies_below(path, document_.folder)) {
            report("include-outside", item.place, "include",
                   fmt::format("'{}' lies outside the folder of the case file", item.text),
                   "keep all files of a case in its folder, or allow others with --allow-outside");
            return;
        }
        if (std::ranges::find(chain, path) != chain.end() || chain.size() > max_depth) {
            report("include-cycle", item.place, "include",
                   chain.size() > max_depth
                       ? "includes are nested too deep"
                       : fmt::format("'{}' is being read already: the files include each other in a circle", item.text),
                   "remove this include");
            return;
        }
        if (document_.paths.size() >= most_files) {
            report("include-many", item.place, "include", fmt::format("more than {} files are included", most_files),
                   "include each file once");
            return;
        }
        std::error_code error;
        const auto text = fs::is_regular_file(path, error) ? read_file(path, largest_text) : std::nullopt;
        if (!text) {
            report("include-missing", item.place, "include", fmt::format("the file '{}' cannot be read", item.text),
                   "its path is relative to the file that includes it");
            return;
        }
        chain.push_back(path);
        Node included = load(*text, (shown.parent_path() / item.text).lexically_normal(), chain);
        chain.pop_back();
        merge(root, std::move(included), "");
    }

    void merge(Node& into, Node&& from, const std::string& path)
    {
        for (auto& child : from.children) {
            const std::string name = path.empty() ? child.key : path + "." + child.key;
            Node* present = into.find(child.key);
            if (present == nullptr && into.children.size() >= most_names) {
                throw InputError(fmt::format("{}: the included files have more than {} names in one table\n  help: "
                                             "divide the table",
                                             main_.string(), most_names));
            }
            if (present == nullptr) {
                into.children.push_back(std::move(child));
            } else if (present->kind == Node::Kind::table && child.kind == Node::Kind::table) {
                merge(*present, std::move(child), name);
            } else {
                Diagnostic diagnostic;
                diagnostic.code = "duplicate-key";
                diagnostic.place = child.key_place;
                diagnostic.path = name;
                diagnostic.message = fmt::format("'{}' is stated twice", name);
                diagnostic.help = "keep one of the two";
                diagnostic.other = present->key_place;
                diagnostic.other_note = "also stated here";
                diagnostics_.add(std::move(diagnostic));
            }
        }
    }

    void report(std::string code, const Place& place, std::string path, std::string message, std::string help)
    {
        diagnostics_.add({Severity::error, std::move(code), place, std::move(path), std::move(message), std::move(help),
                          std::nullopt, ""});
    }

    fs::path main_;
    Diagnostics& diagnostics_;
    Document document_;
    std::vector<Node> replacements_;
    std::uintmax_t size_ = 0;  ///< size of all texts so far [byte]
};

std::string trim(const std::string& text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string> split_path(const std::string& path)
{
    std::vector<std::string> steps;
    std::istringstream stream(path);
    for (std::string step; std::getline(stream, step, '.');) {
        steps.push_back(trim(step));
    }
    return steps;
}

/// Lists and numbers of an override are TOML, everything else is text. So "400 rpm" needs no quotes on a command line.
Node override_value(const std::string& text, int file)
{
    Diagnostics ignored;
    ignored.sources.add("", text);
    Node root = parse_toml("value = " + text + "\n", 0, ignored);
    Node node;
    if (ignored.size() == 0 && root.children.size() == 1) {
        node = std::move(root.children.front());
    } else {
        node.kind = Node::Kind::string;
        node.text = text;
    }
    (void)file;
    return node;
}

void set_places(Node& node, const Place& value, const Place& key)
{
    node.place = value;
    node.key_place = key;
    for (auto& child : node.children) {
        set_places(child, value, value);
    }
}

class Override {
public:
    /// @param whole  place of the text where it stands in a file; else the parts of a text of its own are told apart
    Override(std::string text, int file, Diagnostics& diagnostics, std::optional<Place> whole = {})
        : text_(std::move(text)), file_(file), whole_(whole), diagnostics_(diagnostics)
    {}

    void apply(Node& root)
    {
        const auto steps = override_steps(text_);
        if (steps.empty()) {
            return report("an override is written path=value", "write it like operation.0.speed=\"400 rpm\"");
        }
        const auto equals = text_.find('=');
        key_ = whole_.value_or(Place{file_, 1, 1, static_cast<int>(equals)});
        value_ = whole_.value_or(Place{file_, 1, static_cast<int>(equals) + 2, 1 << 16});
        if (steps.size() == 1 && !root.find(steps[0])) {
            if (const auto paths = paths_to(root, steps[0], ""); !paths.empty()) {
                return report(fmt::format("there is no key '{}' at the top of the case", steps[0]),
                              fmt::format("give its whole path; did you mean {}?", fmt::join(paths, " or ")));
            }
        }
        Node* node = &root;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            node = descend(*node, steps, i);
            if (node == nullptr) {
                return;
            }
        }
        const std::string name = node->key;
        *node = override_value(trim(text_.substr(equals + 1)), file_);
        set_places(*node, value_, key_);
        node->key = name;
    }

private:
    /// Paths of up to three keys of a name below a node.
    static std::vector<std::string> paths_to(const Node& node, const std::string& name, const std::string& above)
    {
        std::vector<std::string> found;
        for (std::size_t i = 0; i < node.children.size(); ++i) {
            const Node& child = node.children[i];
            const auto path = above + (node.kind == Node::Kind::array ? std::to_string(i) : child.key);
            if (child.key == name) {
                found.push_back(path);
            }
            std::ranges::copy(paths_to(child, name, path + "."), std::back_inserter(found));
        }
        found.resize(std::min<std::size_t>(found.size(), 3));
        return found;
    }

    /// An item of a list; the one after the last is added if the path ends there.
    Node* item(Node& list, const std::vector<std::string>& steps, std::size_t at)
    {
        const auto& step = steps[at];
        const auto count = list.children.size();
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
        const bool is_index = error == std::errc() && end == step.data() + step.size();
        if (is_index && index == count && at + 1 == steps.size()) {
            list.children.emplace_back();
            return &list.children.back();
        }
        if (!is_index || index >= count) {
            const std::string path =
                fmt::format("{}", fmt::join(steps.begin(), steps.begin() + static_cast<long>(at), "."));
            report(fmt::format("'{}' is not one of the {} items of this list", step, count),
                   is_index || count == 0
                       ? items_help(list, path)
                       : fmt::format("name the item by its number, counted from 0: {}.0.{}", path,
                                     fmt::join(steps.begin() + static_cast<long>(at), steps.end(), ".")));
            return nullptr;
        }
        return &list.children[index];
    }

    Node* descend(Node& node, const std::vector<std::string>& steps, std::size_t at)
    {
        const auto& step = steps[at];
        if (step.empty()) {
            report("an empty name in the path", "write it like operation.0.speed");
            return nullptr;
        }
        if (node.kind == Node::Kind::array) {
            return item(node, steps, at);
        }
        if (node.kind != Node::Kind::table) {
            report(fmt::format("'{}' lies inside a single value", step), "shorten the path");
            return nullptr;
        }
        if (Node* child = node.find(step)) {
            return child;
        }
        Node child;
        child.key = step;
        child.place = value_;
        child.key_place = key_;
        if (at + 1 < steps.size()) {
            std::vector<std::string> others;
            for (const Node& other : node.children) {
                others.push_back(other.key);
            }
            child.near = closest_name(step, others);
        }
        node.children.push_back(std::move(child));
        return &node.children.back();
    }

    /// Which items a list has, and how it gets another.
    static std::string items_help(const Node& list, const std::string& path)
    {
        const auto count = list.children.size();
        const std::string known = count == 0 ? "the list is empty"
                                             : fmt::format("items are counted from 0, so 0{} can be changed",
                                                           count > 1 ? fmt::format(" to {}", count - 1) : "");
        if (count > 0 && list.children.front().kind != Node::Kind::table) {
            return fmt::format("{}; to add one, set {}.{}", known, path, count);
        }
        return fmt::format("{}; to add one, give all of its keys: {}.{}={}", known, path, count,
                           path == "operation" ? "{duration=\"1 h\", speed=\"300 rpm\", force=\"0 N\"}" : "{...}");
    }

    void report(std::string message, std::string help)
    {
        diagnostics_.add({Severity::error, "override", whole_.value_or(Place{file_, 1, 1, 1 << 16}), "",
                          std::move(message), std::move(help), std::nullopt, ""});
    }

    std::string text_;
    int file_;
    std::optional<Place> whole_;
    Diagnostics& diagnostics_;
    Place key_;
    Place value_;
};

/// Checks that texts and names can be shown and written: one line each, printable, of a sensible length.
class TextCheck {
public:
    explicit TextCheck(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

    void run(const Node& node, const std::string& path)
    {
        if (node.kind == Node::Kind::string) {
            check(node.text, longest_text, node.place, path);
        }
        for (std::size_t i = 0; i < node.children.size(); ++i) {
            const Node& child = node.children[i];
            const bool named = node.kind == Node::Kind::table;
            const std::string step = named ? one_line(child.key) : std::to_string(i);
            const std::string below = path.empty() ? step : path + "." + step;
            if (named) {
                check(child.key, longest_name, child.key_place.file >= 0 ? child.key_place : child.place, below);
            }
            run(child, below);
        }
    }

private:
    void check(const std::string& text, std::size_t longest, const Place& place, const std::string& path)
    {
        if (const auto strange = first_unprintable(text); !strange.empty()) {
            report("bad-text", place, path, fmt::format("the text holds {}, which is not printable", strange),
                   "write one line of printable characters; within three quotes, a \\ at the end of a line joins it "
                   "with the next one");
        } else if (character_count(text) > longest) {
            report(
                "too-long", place, path.substr(0, longest_name),
                fmt::format("the {} is longer than {} characters", longest == longest_name ? "name" : "text", longest),
                "write a shorter one");
        }
    }

    void report(std::string code, const Place& place, const std::string& path, std::string message, std::string help)
    {
        diagnostics_.add(
            {Severity::error, std::move(code), place, path, std::move(message), std::move(help), std::nullopt, ""});
    }

    Diagnostics& diagnostics_;
};

/// Finds an item by its number, or by its key "name" if the items are tables.
const Node* item_of(const Node& list, const std::string& step)
{
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), index);
    if (error == std::errc() && end == step.data() + step.size()) {
        return index < list.children.size() ? &list.children[index] : nullptr;
    }
    const auto found = std::ranges::find_if(list.children, [&](const Node& item) {
        const Node* name = item.find("name");
        return name != nullptr && name->text == step;
    });
    return found == list.children.end() ? nullptr : &*found;
}

}  // namespace

Place place_of(const Node& root, const std::string& path)
{
    const Node* node = &root;
    Place place = root.place;
    std::istringstream stream(path);
    for (std::string step; std::getline(stream, step, '.');) {
        node = node->kind == Node::Kind::array ? item_of(*node, step) : node->find(step);
        if (node == nullptr) {
            break;
        }
        place = node->kind == Node::Kind::table && node->key_place.file >= 0 ? node->key_place : node->place;
    }
    return place;
}

bool lies_below(const fs::path& path, const fs::path& folder)
{
    const auto relative = real_path(path).lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

Document load_document(const fs::path& path, const std::vector<std::string>& overrides, Diagnostics& diagnostics,
                       FileAccess files)
{
    Loader loader(path, files, diagnostics);
    Document document = loader.run();
    for (const auto& replacement : loader.replacements()) {
        Override(replacement.text, replacement.place.file, diagnostics, replacement.place).apply(document.root);
    }
    apply_overrides(document, overrides, diagnostics);
    return document;
}

void apply_overrides(Document& document, const std::vector<std::string>& overrides, Diagnostics& diagnostics)
{
    const auto main = document.paths.front();
    document.first_override = static_cast<int>(document.paths.size());
    for (const auto& text : overrides) {
        const auto file = static_cast<int>(document.paths.size());
        diagnostics.sources.add("--set", text);
        document.paths.push_back(main);
        Override(text, file, diagnostics).apply(document.root);
    }
    TextCheck(diagnostics).run(document.root, "");
}

std::vector<std::string> override_steps(const std::string& text)
{
    const auto equals = text.find('=');
    if (equals == std::string::npos || trim(text.substr(0, equals)).empty()) {
        return {};
    }
    return split_path(text.substr(0, equals));
}

}  // namespace deadpoint::casefile
