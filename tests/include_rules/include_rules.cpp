#include "include_rules.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_reached_headers = 19;
constexpr std::size_t most_files_of_folder = 25;

struct Include {
    int line = 0;
    bool own = false;  // "..." instead of <...>
    std::string target;
};
using Files = std::map<std::string, std::vector<Include>>;  // by path relative to the root

/// The folders that each folder may include besides itself.
const std::map<std::string, std::set<std::string>>& allowed_folders()
{
    static const std::set<std::string> values{"core", "io", "exchange"};
    static const std::set<std::string> stages{"core",       "io",        "exchange",     "casefile",    "mechanism",
                                              "crankshaft", "tribology", "surroundings", "machine",     "heat",
                                              "fem",        "reduce",    "drift",        "calibration", "design"};
    static const auto rules = [] {
        std::map<std::string, std::set<std::string>> result{
            {"include", {}}, {"core", {}}, {"io", {"core"}}, {"exchange", {"core", "io"}}};
        for (const auto& stage : stages) {
            result.try_emplace(stage, values);
        }
        for (const auto* on_heat : {"fem", "reduce"}) {
            result[on_heat].insert("heat");
        }
        result["fem"].insert("reduce");
        // Runs on states see neither meshes nor fields.
        result["press"] = stages;
        for (const auto* of_mesh : {"machine", "fem"}) {
            result["press"].erase(of_mesh);
        }
        result["twin"] = result["press"];
        result["twin"].insert("press");
        result["report"] = result["twin"];
        result["report"].insert("twin");
        result["full"] = stages;
        result["full"].insert({"press", "twin"});
        result["api"] = result["full"];
        result["api"].insert({"full", "report", "include"});
        result["app"] = result["api"];
        result["app"].insert("api");
        return result;
    }();
    return rules;
}

/// Libraries that only one folder may include: pattern of the header's name, folder.
const std::vector<std::pair<std::regex, std::string>>& wrapped_libraries()
{
    static const std::vector<std::pair<std::regex, std::string>> rules{
        {std::regex("petsc.*|slepc.*|mpi\\.h|mpi/.*|.*openmpi.*"), "fem"},
        {std::regex("gmsh.*"), "machine"},
        {std::regex("toml.*"), "casefile"},
        {std::regex("nlopt.*"), "design"},
        {std::regex("CLI/.*|spdlog/.*"), "app"},
    };
    return rules;
}

/// Public headers that every folder may include; the others are for those to its right.
bool is_basic(const std::string& file)
{
    static const std::set<std::string> basic{"diagnostic.hpp", "error.hpp", "observer.hpp", "version.hpp"};
    return basic.contains(fs::path(file).filename().string());
}

std::string folder_of(const std::string& file)
{
    static const std::string source = "src/deadpoint/";
    if (file.starts_with("include/")) {
        return "include";
    }
    if (!file.starts_with(source)) {
        return "app";
    }
    return file.substr(source.size(), file.find('/', source.size()) - source.size());
}

bool is_standard(const Include& include)
{
    return !include.own && include.target.find_first_of("./") == std::string::npos;
}

/// Path of an own header relative to the root: "deadpoint/<folder>/..." below src, "deadpoint/<file>" below include,
/// anything else beside the including file.
std::string resolved(const std::string& from, const std::string& target)
{
    if (target.starts_with("deadpoint/")) {
        const bool is_public = std::ranges::count(target, '/') == 1;
        return (is_public ? "include/" : "src/") + target;
    }
    return (fs::path(from).parent_path() / target).lexically_normal().generic_string();
}

Files read_files(const fs::path& root)
{
    static const std::regex line_pattern("\\s*#\\s*include\\s*([<\"])([^>\"]+)[>\"].*");
    Files files;
    for (const char* top : {"include/deadpoint", "src/deadpoint", "app"}) {
        if (!fs::exists(root / top)) {
            continue;
        }
        for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
            const auto extension = entry.path().extension();
            if (extension != ".hpp" && extension != ".cpp") {
                continue;
            }
            auto& includes = files[entry.path().lexically_relative(root).generic_string()];
            std::ifstream in(entry.path());
            std::string text;
            for (int line = 1; std::getline(in, text); ++line) {
                std::smatch match;
                if (std::regex_match(text, match, line_pattern)) {
                    includes.push_back({line, match[1] == "\"", match[2]});
                }
            }
        }
    }
    return files;
}

bool is_matrix_library(const Include& include) { return include.target.starts_with("Eigen/"); }

/// Headers through which a library's header is seen, directly or through other headers; by path.
struct InternalHeaders {
    std::set<std::string> all;
    std::set<std::string> beside_matrices;  ///< of a library other than Eigen
};

std::set<std::string> headers_that_show(const Files& files, const std::function<bool(const Include&)>& is_library)
{
    std::set<std::string> result;
    const auto shows_library = [&](const std::string& file, const Include& include) {
        return include.own ? result.contains(resolved(file, include.target)) : is_library(include);
    };
    for (bool grown = true; grown;) {
        const auto before = result.size();
        for (const auto& [file, includes] : files) {
            const bool header = file.starts_with("src/") && file.ends_with(".hpp");
            if (header && std::ranges::any_of(includes, [&](const auto& i) { return shows_library(file, i); })) {
                result.insert(file);
            }
        }
        grown = result.size() > before;
    }
    return result;
}

InternalHeaders internal_headers(const Files& files)
{
    return {headers_that_show(files, [](const Include& include) { return !is_standard(include); }),
            headers_that_show(
                files, [](const Include& include) { return !is_standard(include) && !is_matrix_library(include); })};
}

/// The terms of a reduced model are matrices. Whoever builds it from a full model or keeps it may see them.
bool may_see_matrices(const std::string& folder, const std::string& other)
{
    static const std::set<std::pair<std::string, std::string>> rule{
        {"fem", "reduce"}, {"full", "reduce"}, {"full", "fem"}, {"twin", "reduce"}, {"twin", "calibration"}};
    return rule.contains({folder, other});
}

/// What is wrong with one include, or nothing.
std::string fault(const std::string& file, const Include& include, const InternalHeaders& internal)
{
    const std::string folder = folder_of(file);
    if (folder == "include" && !include.own && !is_standard(include)) {
        return "public headers include the standard library only, not <" + include.target + ">";
    }
    if (include.own) {
        if (!file.starts_with("app/") && !include.target.starts_with("deadpoint/")) {
            return "write own headers as \"deadpoint/<folder>/<file>\", not \"" + include.target + "\"";
        }
        const std::string target = resolved(file, include.target);
        const std::string other = folder_of(target);
        const auto rule = allowed_folders().find(folder);
        if (rule == allowed_folders().end()) {
            return "the folder '" + folder + "' has no rule; add it to tests/include_rules and docs/design.md";
        }
        if (other == "include" && is_basic(target)) {
            return {};
        }
        if (other != folder && !rule->second.contains(other)) {
            return "'" + folder + "' may not include '" + other + "' (" + include.target + ")";
        }
        const bool shown =
            may_see_matrices(folder, other) ? internal.beside_matrices.contains(target) : internal.all.contains(target);
        if (other != folder && shown) {
            return "'" + include.target + "' shows a library's header and is therefore internal to '" + other + "'";
        }
        return {};
    }
    for (const auto& [pattern, wrapper] : wrapped_libraries()) {
        if (folder != wrapper && std::regex_match(include.target, pattern)) {
            return "<" + include.target + "> may be included only in '" + wrapper + "'";
        }
    }
    return {};
}

/// Path without its extension: a header and its source are one unit.
std::string unit_of(const std::string& file) { return file.substr(0, file.rfind('.')); }

/// An include of another unit, and where it stands.
struct Use {
    std::string place;  // "file:line"
    std::string unit;
};
using Units = std::map<std::string, std::vector<Use>>;

Units units_of(const Files& files)
{
    Units units;
    for (const auto& [file, includes] : files) {
        auto& uses = units[unit_of(file)];
        for (const auto& include : includes) {
            const std::string unit = unit_of(resolved(file, include.target));
            const bool other = unit != unit_of(file) || file.ends_with(".hpp");
            if (include.own && other) {
                uses.push_back({file + ":" + std::to_string(include.line), unit});
            }
        }
    }
    return units;
}

/// Depth-first search for cycles; each is reported once, at the file where it closes.
class CycleSearch {
public:
    explicit CycleSearch(const Units& units) : units_(units) {}

    std::vector<std::string> run()
    {
        for (const auto& [unit, uses] : units_) {
            visit(unit);
        }
        return found_;
    }

private:
    void visit(const std::string& unit)
    {
        if (done_.contains(unit) || !units_.contains(unit)) {
            return;
        }
        path_.push_back(unit);
        for (const auto& use : units_.at(unit)) {
            const auto start = std::find(path_.begin(), path_.end(), use.unit);
            if (start == path_.end()) {
                visit(use.unit);
                continue;
            }
            std::string text = use.place + ": cycle of includes:";
            for (auto at = start; at != path_.end(); ++at) {
                text += " " + *at + " ->";
            }
            found_.push_back(text + " " + use.unit);
        }
        path_.pop_back();
        done_.insert(unit);
    }

    const Units& units_;
    std::vector<std::string> path_;
    std::set<std::string> done_;
    std::vector<std::string> found_;
};

/// The folders as units: a room of a folder may not include what includes it again.
Units rooms_of(const Files& files)
{
    Units rooms;
    for (const auto& [file, includes] : files) {
        const auto room = fs::path(file).parent_path().generic_string();
        auto& uses = rooms[room];
        for (const auto& include : includes) {
            const auto other = fs::path(resolved(file, include.target)).parent_path().generic_string();
            if (include.own && other != room) {
                uses.push_back({file + ":" + std::to_string(include.line), other});
            }
        }
    }
    return rooms;
}

/// Own headers that a file reaches, directly or through others.
std::set<std::string> reached(const Files& files, const std::string& file)
{
    std::set<std::string> found;
    std::vector<std::string> open{file};
    while (!open.empty()) {
        const std::string next = open.back();
        open.pop_back();
        const auto known = files.find(next);
        if (known == files.end()) {
            continue;
        }
        for (const auto& include : known->second) {
            const std::string target = resolved(next, include.target);
            if (include.own && found.insert(target).second) {
                open.push_back(target);
            }
        }
    }
    return found;
}

void find_wide_headers(const Files& files, std::vector<std::string>& result)
{
    for (const auto& [file, includes] : files) {
        const auto count = file.ends_with(".hpp") ? reached(files, file).size() : 0;
        if (count > most_reached_headers) {
            result.push_back(file + ":1: reaches " + std::to_string(count) +
                             " own headers; declare what the header only mentions");
        }
    }
}

void find_full_folders(const Files& files, std::vector<std::string>& result)
{
    std::map<std::string, std::size_t> counts;
    for (const auto& [file, includes] : files) {
        ++counts[fs::path(file).parent_path().generic_string()];
    }
    for (const auto& [folder, count] : counts) {
        if (count > most_files_of_folder) {
            result.push_back(folder + ":1: holds " + std::to_string(count) + " files; divide it into rooms");
        }
    }
}

/// Calls `at` with "file:line: " and the text of each line of the C++ files below a folder of the root.
void for_each_line(const fs::path& root, const std::string& folder,
                   const std::function<void(const std::string&, const std::string&)>& at)
{
    if (!fs::exists(root / folder)) {
        return;
    }
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const auto ending = entry.path().extension();
        if (ending != ".cpp" && ending != ".hpp") {
            continue;
        }
        const auto file = fs::relative(entry.path(), root).generic_string();
        std::ifstream stream(entry.path());
        std::string line;
        for (int number = 1; std::getline(stream, line); ++number) {
            at(file + ":" + std::to_string(number) + ": ", line);
        }
    }
}

/// doctest's Approx accepts |a - b| < eps (1 + max(|a|, |b|)), so it holds nothing for micrometres in metres.
void find_loose_comparisons(const fs::path& root, std::vector<std::string>& result)
{
    const std::regex loose("(^|[^A-Za-z_])Approx\\(");
    for_each_line(root, "tests", [&](const std::string& place, const std::string& line) {
        if (std::regex_search(line.substr(0, line.find("//")), loose)) {
            result.push_back(place + "Approx adds 1 to its scale; compare with near() of tests/near.hpp");
        }
    });
}

/// A comment that begins with "Of" leaves out its subject. A further line of a comment may begin so.
void find_comments_without_subject(const fs::path& root, std::vector<std::string>& result)
{
    const std::regex subjectless("(//[/!]?<?|/\\*[*!]?<?)\\s*Of\\s"), only_comment("\\s*//[/!]?\\s*\\S.*");
    for (const char* folder : {"include", "src", "app", "python/bindings", "tests"}) {
        std::string before;
        for_each_line(root, folder, [&](const std::string& place, const std::string& line) {
            const bool goes_on = !place.ends_with(":1: ") && std::regex_match(before, only_comment) &&
                                 std::regex_match(line, only_comment);
            if (!goes_on && std::regex_search(line, subjectless)) {
                result.push_back(place + "a comment begins with \"Of\"; begin with the noun or verb that it is about");
            }
            before = line;
        });
    }
}

}  // namespace

std::vector<std::string> include_violations(const fs::path& root)
{
    const Files files = read_files(root);
    const auto internal = internal_headers(files);
    std::vector<std::string> result;
    for (const auto& [file, includes] : files) {
        for (const auto& include : includes) {
            if (const auto text = fault(file, include, internal); !text.empty()) {
                result.push_back(file + ":" + std::to_string(include.line) + ": " + text);
            }
        }
    }
    for (const auto& units : {units_of(files), rooms_of(files)}) {
        const auto cycles = CycleSearch(units).run();
        result.insert(result.end(), cycles.begin(), cycles.end());
    }
    find_wide_headers(files, result);
    find_full_folders(files, result);
    find_loose_comparisons(root, result);
    find_comments_without_subject(root, result);
    return result;
}
