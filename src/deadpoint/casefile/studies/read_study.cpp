#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/kind_of_file.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/casefile/syntax/reader.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <set>
#include <tuple>

namespace deadpoint::casefile {
namespace {

std::string trimmed(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string()
                                           : std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

bool is_index(std::string_view word)
{
    return !word.empty() && std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

/// End of a key, from its last word that is not a list index: "speed", "centre.0".
std::string last_word(const std::string& key)
{
    std::size_t end = key.size();
    while (true) {
        const auto dot = end == 0 ? std::string::npos : key.rfind('.', end - 1);
        if (dot == std::string::npos) {
            return key;
        }
        if (!is_index(std::string_view(key).substr(dot + 1, end - dot - 1))) {
            return key.substr(dot + 1);
        }
        end = dot;
    }
}

bool overlap(const std::string& a, const std::string& b)
{
    return a == b || a.starts_with(b + ".") || b.starts_with(a + ".");
}

bool about_the_key(const Diagnostic& d)
{
    constexpr std::array<std::string_view, 3> codes{"unknown-key", "unknown-section", "override"};
    return std::ranges::find(codes, d.code) != codes.end();
}

/// Checks what spans several values of the file, fills in what it leaves open, and has the base case read every value.
class StudyChecker {
public:
    StudyChecker(StudyFile& file, const Document& document, Diagnostics& diagnostics)
        : file_(file), document_(document), diagnostics_(diagnostics)
    {}

    void run()
    {
        check_names();
        check_size();
        for (std::size_t s = 0; s < file_.sets.size(); ++s) {
            for (std::size_t a = 0; a < file_.sets[s].axes.size(); ++a) {
                complete(s, a);
            }
            check_axes(s);
        }
        if (!too_large_ && base_reads_settings()) {
            for (std::size_t s = 0; s < file_.sets.size(); ++s) {
                for (std::size_t a = 0; a < file_.sets[s].axes.size(); ++a) {
                    read_steps(s, a);
                }
            }
        }
    }

private:
    void report(std::string code, std::string path, std::string message, std::string help)
    {
        const Place place = place_of(document_.root, path);
        diagnostics_.add({Severity::error, std::move(code), place, std::move(path), std::move(message), std::move(help),
                          std::nullopt, ""});
    }

    static std::string path_of(std::size_t s, std::size_t a) { return fmt::format("sets.{}.axes.{}", s, a); }

    void check_names()
    {
        std::set<std::string> names;
        for (std::size_t s = 0; s < file_.sets.size(); ++s) {
            if (!names.insert(file_.sets[s].name).second) {
                report("duplicate-name", fmt::format("sets.{}.name", s),
                       fmt::format("two sets are called '{}'", file_.sets[s].name), "give each its own name");
            }
        }
    }

    void check_size()
    {
        double points = 0;
        for (const auto& set : file_.sets) {
            double of_set = 1;
            for (const auto& axis : set.axes) {
                of_set *=
                    static_cast<double>(axis.count > 0 ? static_cast<std::size_t>(axis.count) : axis.values.size());
            }
            points += of_set;
        }
        if (points > static_cast<double>(most_study_points)) {
            report("too-many", "sets",
                   fmt::format("the sets have {:.0f} points, more than {} in all", points, most_study_points),
                   "take fewer steps, or cross fewer axes");
            too_large_ = true;
        }
    }

    /// Reads keys, steps, labels and name of one axis.
    void complete(std::size_t s, std::size_t a)
    {
        auto& axis = file_.sets[s].axes[a];
        const std::string at = path_of(s, a);
        if (!axis.key.empty()) {
            axis.keys = {axis.key};
        }
        for (std::size_t k = 0; k < axis.keys.size(); ++k) {
            axis.keys[k] = trimmed(axis.keys[k]);
            if (axis.keys[k].empty() || axis.keys[k].find('=') != std::string::npos) {
                report("bad-key", key_path(axis, at, k), fmt::format("'{}' is not a key of a case", axis.keys[k]),
                       "write it like \"operation.0.speed\"");
            }
        }
        if (axis.name.empty()) {
            axis.name = last_word(axis.keys.front());
        }
        if (axis.count > 0 && !too_large_) {
            expand(axis, at);
        }
        complete_steps(axis, at);
        complete_labels(axis, at);
    }

    void expand(StudyAxis& axis, const std::string& at)
    {
        const auto from = number_and_unit(axis.from);
        const auto to = number_and_unit(axis.to);
        for (const auto& [key, text, value] : {std::tuple{"from", axis.from, from}, std::tuple{"to", axis.to, to}}) {
            if (!value) {
                report("not-a-quantity", at + "." + key, fmt::format("'{}' does not begin with a number", text),
                       "write it like \"200 rpm\"; steps that are not numbers are listed in `values`");
            }
        }
        if (!from || !to) {
            return;
        }
        if (from->unit != to->unit) {
            return report("unit-mismatch", at + ".to",
                          fmt::format("'{}' and '{}' have different units", axis.from, axis.to),
                          "write both ends of the range in one unit");
        }
        if (from->number == to->number) {
            return report("inconsistent", at + ".to", "the range has no extent", "give two different ends");
        }
        for (int i = 0; i < axis.count; ++i) {
            const double share = static_cast<double>(i) / (axis.count - 1);
            // Twelve digits hide the rounding of the division: 0.3, not 0.30000000000000004.
            const double number = from->number + share * (to->number - from->number);
            axis.values.push_back({trimmed(fmt::format("{:.12g} {}", number, from->unit))});
        }
    }

    void complete_steps(StudyAxis& axis, const std::string& at)
    {
        std::set<std::vector<std::string>> seen;
        for (std::size_t i = 0; i < axis.values.size(); ++i) {
            auto& step = axis.values[i];
            if (step.size() == 1) {
                step.resize(axis.keys.size(), step.front());
            }
            const std::string place = fmt::format("{}.values.{}", at, i);
            if (step.size() != axis.keys.size()) {
                report("wrong-length", place, fmt::format("{} values for {} keys", step.size(), axis.keys.size()),
                       "give one value for each key, or a single one for all");
                continue;
            }
            std::vector<std::string> plain;
            for (auto& text : step) {
                text = trimmed(text);
                plain.push_back(plain_setting(text));
            }
            if (!seen.insert(plain).second) {
                report("duplicate-step", place, "this step is listed twice", "remove one of the two");
            }
        }
    }

    void complete_labels(StudyAxis& axis, const std::string& at)
    {
        if (axis.labels.empty()) {
            for (const auto& step : axis.values) {
                const bool same = std::ranges::adjacent_find(step, std::not_equal_to<>()) == step.end();
                std::string label;
                for (std::size_t k = 0; k < (same ? std::min<std::size_t>(1, step.size()) : step.size()); ++k) {
                    label += (k == 0 ? "" : " / ") + step[k];
                }
                axis.labels.push_back(label);
            }
            return;
        }
        if (axis.labels.size() != axis.values.size()) {
            report("wrong-length", at + ".labels",
                   fmt::format("{} labels for {} steps", axis.labels.size(), axis.values.size()),
                   "give one label for each step, or none");
        }
        std::set<std::string> seen;
        for (std::size_t i = 0; i < axis.labels.size(); ++i) {
            if (axis.labels[i].empty() || !seen.insert(axis.labels[i]).second) {
                report("duplicate-name", fmt::format("{}.labels.{}", at, i),
                       axis.labels[i].empty() ? "the label is empty"
                                              : fmt::format("two steps are called '{}'", axis.labels[i]),
                       "give each step its own label");
            }
            if (character_count(axis.labels[i]) > longest_name) {
                report("too-long", fmt::format("{}.labels.{}", at, i),
                       fmt::format("the label is longer than {} characters", longest_name), "write a shorter one");
            }
        }
    }

    static std::string key_path(const StudyAxis& axis, const std::string& at, std::size_t k)
    {
        return axis.key.empty() ? fmt::format("{}.keys.{}", at, k) : at + ".key";
    }

    /// Checks that no key and no name occurs twice in a set.
    void check_axes(std::size_t s)
    {
        std::vector<std::string> keys;
        std::set<std::string> names;
        for (std::size_t a = 0; a < file_.sets[s].axes.size(); ++a) {
            const auto& axis = file_.sets[s].axes[a];
            for (std::size_t k = 0; k < axis.keys.size(); ++k) {
                const auto other =
                    std::ranges::find_if(keys, [&](const auto& key) { return overlap(key, axis.keys[k]); });
                if (other != keys.end()) {
                    report("duplicate-key", key_path(axis, path_of(s, a), k),
                           *other == axis.keys[k]
                               ? fmt::format("the set varies '{}' twice", *other)
                               : fmt::format("the set varies '{}' and, within it, '{}'", std::min(*other, axis.keys[k]),
                                             std::max(*other, axis.keys[k])),
                           "name each key in one axis only");
                }
                keys.push_back(axis.keys[k]);
            }
            if (!names.insert(axis.name).second) {
                report("duplicate-name", path_of(s, a), fmt::format("two axes of the set are called '{}'", axis.name),
                       "give each its own `name`");
            }
        }
    }

    /// Reads the base case, first as it is, then with the settings that the study makes in all points.
    bool base_reads_settings()
    {
        Diagnostics of_base;
        Case value;
        (void)read_case(file_.base, {}, value, of_base, file_.files);
        if (of_base.error_count() > 0) {
            if (diagnostics_.error_count() == 0) {
                throw CaseError(of_base.render_errors("the base case of the study; nothing was computed"),
                                as_data(of_base));
            }
            return false;
        }
        return read_with(
            {}, [](std::size_t i, const Diagnostic&) { return fmt::format("set.{}", i); }, "set");
    }

    /// Reads the base case with the study's settings and further ones; reports all errors.
    /// @param place  path in the study file of an override
    /// @param whole  path for errors that belong to no single override
    template <class PlaceOf>
    bool read_with(const std::vector<std::string>& more, PlaceOf&& place, const std::string& whole)
    {
        auto overrides = file_.set;
        overrides.insert(overrides.end(), more.begin(), more.end());
        Diagnostics found;
        Case value;
        const auto document = read_case(file_.base, overrides, value, found, file_.files);
        const auto first = static_cast<int>(document.paths.size() - overrides.size());
        const bool any_own = std::ranges::any_of(
            found.items(), [&](const Diagnostic& d) { return d.severity == Severity::error && d.place.file >= first; });
        for (const auto& d : found.items()) {
            const bool own = d.place.file >= first;
            if (d.severity != Severity::error || own != any_own) {
                continue;
            }
            const auto index = static_cast<std::size_t>(d.place.file - first);
            const std::string message = fmt::format("the base case refuses '{}': {}{}",
                                                    own ? overrides[index] : fmt::format("{}", fmt::join(more, ", ")),
                                                    own || d.path.empty() ? "" : d.path + ": ", d.message);
            const std::string at = own ? place(index, d) : whole;
            if (said_.insert(at).second) {
                report(d.code, at, message, d.help);
            }
        }
        return found.error_count() == 0;
    }

    void read_steps(std::size_t s, std::size_t a)
    {
        const auto& axis = file_.sets[s].axes[a];
        const std::string at = path_of(s, a);
        for (std::size_t i = 0; i < axis.values.size(); ++i) {
            const auto& step = axis.values[i];
            if (step.size() != axis.keys.size()) {
                continue;
            }
            std::vector<std::string> overrides;
            for (std::size_t k = 0; k < step.size(); ++k) {
                overrides.push_back(fmt::format("{}={}", axis.keys[k], step[k]));
            }
            std::string whole = axis.count > 0 ? at + ".from" : fmt::format("{}.values.{}", at, i);
            if (!known_good_.contains(overrides) && read_with(
                                                        overrides,
                                                        [&](std::size_t index, const Diagnostic& d) {
                                                            if (index < file_.set.size()) {
                                                                return whole;
                                                            }
                                                            const std::size_t k = index - file_.set.size();
                                                            return about_the_key(d) ? key_path(axis, at, k)
                                                                   : axis.keys.size() > 1 && axis.count == 0
                                                                       ? fmt::format("{}.{}", whole, k)
                                                                       : whole;
                                                        },
                                                        whole)) {
                known_good_.insert(overrides);
            }
        }
    }

    StudyFile& file_;
    const Document& document_;
    Diagnostics& diagnostics_;
    bool too_large_ = false;
    std::set<std::string> said_;                     ///< places with a message already
    std::set<std::vector<std::string>> known_good_;  ///< overrides with which the base case could be read
};

}  // namespace

std::optional<NumberAndUnit> number_and_unit(std::string_view text)
{
    std::string clean = trimmed(text);
    if (clean.starts_with('+')) {
        clean.erase(0, 1);
    }
    if (clean.find_first_of("0123456789.") > (clean.starts_with('-') ? 1U : 0U)) {
        return std::nullopt;
    }
    NumberAndUnit result;
    const auto [end, error] = std::from_chars(clean.data(), clean.data() + clean.size(), result.number);
    if (error != std::errc() || !std::isfinite(result.number)) {
        return std::nullopt;
    }
    result.unit = trimmed(std::string_view(clean).substr(static_cast<std::size_t>(end - clean.data())));
    return result;
}

std::string plain_setting(std::string_view text)
{
    const auto value = number_and_unit(text);
    return value ? trimmed(fmt::format("{} {}", format_number(value->number), value->unit)) : trimmed(text);
}

StudyFile read_study(const std::filesystem::path& path, FileAccess files)
{
    Diagnostics diagnostics;
    const Document document = load_document(path, {}, diagnostics, FileAccess::anywhere);
    if (diagnostics.error_count() == 0) {
        require_kind(document, KindOfFile::study, diagnostics);
    }
    stop_at_errors(diagnostics, "the study file; nothing was computed");
    StudyFile file;
    file.files = files;
    Reader(document, diagnostics, nullptr).read(file);
    stop_at_errors(diagnostics, "the study file; nothing was computed");
    StudyChecker(file, document, diagnostics).run();
    stop_at_errors(diagnostics, "the study file; nothing was computed");
    if (file.sensitivity || file.optimise) {
        const auto base = read_case(file.base, file.set, file.files).value;
        if (file.sensitivity) {
            check_sensitivity(*file.sensitivity, base, document, diagnostics);
        }
        if (file.optimise) {
            check_optimise(*file.optimise, base, document, diagnostics);
        }
    }
    stop_at_errors(diagnostics, "the study file; nothing was computed");
    return file;
}

}  // namespace deadpoint::casefile
