#include "deadpoint/twin/map/sweep_plan.hpp"

#include "deadpoint/casefile/files/case_base.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/casefile/syntax/case_bytes.hpp"
#include "deadpoint/core/hash.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <memory>
#include <set>

namespace deadpoint::twin {
namespace {

using Settings = std::map<std::string, std::string>;  ///< value by key
using IsBase = std::function<bool(const std::string&, const std::string&)>;

constexpr std::size_t longest_name = 100;  ///< of a folder; file systems take 255 bytes

void check_axis(const SweepSet& set, const SweepAxis& axis, std::set<std::string>& keys, std::set<std::string>& names)
{
    const std::string where = fmt::format("set '{}', axis '{}'", set.name, axis.name);
    if (axis.values.empty()) {
        throw InputError(fmt::format("{}: it has no step\n  help: give it values", where));
    }
    if (!names.insert(axis.name).second) {
        throw InputError(
            fmt::format("{}: another axis of the set has this name\n  help: give each its own name", where));
    }
    for (const auto& key : axis.keys) {
        if (!keys.insert(key).second) {
            throw InputError(
                fmt::format("{}: the set varies '{}' twice\n  help: name each key in one axis only", where, key));
        }
    }
    const bool fits = axis.labels.size() == axis.values.size() &&
                      std::ranges::all_of(axis.values, [&](const auto& v) { return v.size() == axis.keys.size(); });
    if (!fits) {
        throw InputError(fmt::format("{}: not one label and one value per key for each step", where));
    }
}

void check_sets(const SweepStudy& study)
{
    std::set<std::string> set_names;
    for (const auto& set : study.sets) {
        if (!set_names.insert(set.name).second) {
            throw InputError(fmt::format("two sets are called '{}'\n  help: give each its own name", set.name));
        }
        std::set<std::string> keys, names;
        for (const auto& axis : set.axes) {
            check_axis(set, axis, keys, names);
        }
    }
}

std::string lower(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Goes through all places of a set, the last axis changing fastest.
bool next(const SweepSet& set, std::vector<std::size_t>& steps)
{
    for (std::size_t a = set.axes.size(); a-- > 0;) {
        if (++steps[a] < set.axes[a].values.size()) {
            return true;
        }
        steps[a] = 0;
    }
    return false;
}

/// Collects runs, each once.
class RunCollector {
public:
    RunCollector(const SweepStudy& study, const IsBase& is_base) : study_(study), is_base_(is_base) {}

    void add(std::size_t set, const std::vector<std::size_t>& steps)
    {
        Settings changed;
        std::string name;
        std::vector<std::string> overrides = study_.overrides;
        for (std::size_t a = 0; a < steps.size(); ++a) {
            const auto& axis = study_.sets[set].axes[a];
            bool differs = false;
            for (std::size_t k = 0; k < axis.keys.size(); ++k) {
                const auto& value = axis.values[steps[a]][k];
                if (!is_base_(axis.keys[k], value)) {
                    changed[axis.keys[k]] = casefile::plain_setting(value);
                    overrides.push_back(fmt::format("{}={}", axis.keys[k], value));
                    differs = true;
                }
            }
            if (differs) {
                name += fmt::format("{}{}={}", name.empty() ? "" : ",", folder_safe(axis.name),
                                    folder_safe(axis.labels[steps[a]]));
            }
        }
        const auto [found, is_new] = index_.emplace(changed, points_.size());
        if (is_new) {
            points_.push_back({unused(name.empty() ? "base" : name, changed), std::move(overrides), {}});
        }
        points_[found->second].places.push_back({set, steps});
    }

    [[nodiscard]] std::vector<SweepPoint> take() { return std::move(points_); }

private:
    /// The name. If another run already has it or it is too long, a mark made from the settings is added. The mark does
    /// not depend on the order, so an extended study finds its finished points again.
    std::string unused(std::string name, const Settings& changed)
    {
        std::string all;
        for (const auto& [key, value] : changed) {
            all += fmt::format("{}={}\n", key, value);
        }
        const std::string mark = fmt::format("-{}", stable_hash(all).substr(0, 8));
        if (name.size() > longest_name) {
            name.resize(longest_name);
            name += mark;
        }
        // Some file systems do not distinguish upper and lower case.
        if (!names_.insert(lower(name)).second) {
            name += mark;
            if (!names_.insert(lower(name)).second) {
                throw InputError(fmt::format("two points of the study would be called '{}'\n"
                                             "  help: give the axes or their labels names that differ",
                                             name));
            }
        }
        return name;
    }

    const SweepStudy& study_;
    const IsBase& is_base_;
    std::vector<SweepPoint> points_;
    std::map<Settings, std::size_t> index_;
    std::set<std::string> names_;
};

/// Dimensions in the order in which a unit is taken for one: a bare kelvin counts as a difference.
std::vector<Dimension> dimensions_to_try()
{
    std::vector<Dimension> order{Dimension::none, Dimension::temperature_difference};
    for (const auto& info : all_dimensions()) {
        if (std::ranges::find(order, info.dimension) == order.end()) {
            order.push_back(info.dimension);
        }
    }
    return order;
}

/// Numbers of an axis whose steps are all of one dimension, the same value for all keys of a step.
void add_numbers(SweepAxis& axis)
{
    const auto same_for_all_keys = [](const std::vector<std::string>& step) {
        return std::ranges::all_of(step, [&](const auto& text) {
            return casefile::plain_setting(text) == casefile::plain_setting(step.front());
        });
    };
    if (!std::ranges::all_of(axis.values, same_for_all_keys)) {
        return;
    }
    for (const Dimension dimension : dimensions_to_try()) {
        std::vector<double> numbers;
        for (const auto& step : axis.values) {
            const auto value = try_parse_quantity(step.front(), dimension);
            if (!std::holds_alternative<double>(value)) {
                break;
            }
            numbers.push_back(std::get<double>(value));
        }
        if (numbers.size() == axis.values.size()) {
            axis.numbers = std::move(numbers);
            axis.dimension = dimension;
            return;
        }
    }
}

}  // namespace

std::string folder_safe(const std::string& text)
{
    std::string safe;
    for (const char c : text) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' || c == '+';
        if (plain || !safe.ends_with('_')) {
            safe += plain ? c : '_';
        }
    }
    return safe;
}

std::vector<SweepPoint> sweep_points(const SweepStudy& study, const IsBase& is_base)
{
    check_sets(study);
    RunCollector collector(study, is_base);
    for (std::size_t s = 0; s < study.sets.size(); ++s) {
        std::vector<std::size_t> steps(study.sets[s].axes.size(), 0);
        do {
            collector.add(s, steps);
        } while (next(study.sets[s], steps));
    }
    return collector.take();
}

SweepStudy translate_study(const casefile::StudyFile& file)
{
    SweepStudy study;
    study.name = file.name;
    study.base = file.base;
    study.note = file.note;
    study.overrides = file.set;
    for (const auto& set : file.sets) {
        auto& target = study.sets.emplace_back();
        target.name = set.name;
        for (const auto& axis : set.axes) {
            target.axes.push_back({axis.name, axis.keys, axis.values, axis.labels, {}, Dimension::none});
            add_numbers(target.axes.back());
        }
    }
    if (file.limits) {
        study.limits = {file.limits->largest, file.limits->final};
    }
    study.files = file.files;
    return study;
}

std::function<bool(const std::string&, const std::string&)> base_values(const SweepStudy& study)
{
    const auto base = std::make_shared<casefile::CaseBase>(study.base, study.files);
    const auto bytes_with = [base, overrides = study.overrides](const std::string& more) {
        auto all = overrides;
        if (!more.empty()) {
            all.push_back(more);
        }
        return casefile::case_bytes(base->with(all));
    };
    const auto base_bytes = bytes_with("");
    auto known = std::make_shared<std::map<std::string, bool>>();
    return [bytes_with, base_bytes, known](const std::string& key, const std::string& value) {
        const std::string setting = fmt::format("{}={}", key, value);
        if (const auto found = known->find(setting); found != known->end()) {
            return found->second;
        }
        bool same = false;
        try {
            same = bytes_with(setting) == base_bytes;
        } catch (const InputError&) {
            // A key that is refused alone can be valid together with other keys of its axis.
        }
        return known->emplace(setting, same).first->second;
    };
}

}  // namespace deadpoint::twin
