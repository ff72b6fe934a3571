#include "deadpoint/casefile/files/numbers.hpp"

#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/casefile/syntax/value_texts.hpp"
#include "deadpoint/core/names/pattern.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <set>

namespace deadpoint::casefile {
namespace {

/// A number where it stands.
struct Found {
    CaseNumber number;
    std::vector<double*> values;  ///< which a factor and a shift change
    std::vector<double*> scaled;  ///< which a factor changes only
};

std::string joined(const std::string& path, std::string_view step)
{
    return path.empty() ? std::string(step) : fmt::format("{}.{}", path, step);
}

/// Walks through a case and hands over its numbers.
class NumberWalk final : public Visitor {
public:
    explicit NumberWalk(std::function<void(Found)> take) : take_(std::move(take)) {}

    void run(Case& c)
    {
        frames_.push_back({});
        describe(*this, c);
    }

    void number(const Key& key, double& value, const Range& range) override
    {
        give(key.name, value, Dimension::none, range, {&value}, {});
    }
    void quantity(const Key& key, double& value, Dimension dimension, const Range& range) override
    {
        give(key.name, value, dimension, range, {&value}, {});
    }
    void quantity(const Key& key, std::optional<double>& value, Dimension dimension, const Range& range) override
    {
        if (value) {
            give(key.name, *value, dimension, range, {&*value}, {});
        }
    }
    void property(const Key& key, double& constant, Table& table, Dimension dimension, const Range& range) override
    {
        std::vector<double*> values{&constant};
        for (double& value : table.y) {
            values.push_back(&value);
        }
        give(key.name, constant, dimension, range, std::move(values), {});
    }
    void course(const Key& key, std::optional<Course>& value, Dimension dimension, const Range& range) override
    {
        if (!value) {
            return;
        }
        if (value->daily) {
            auto& daily = *value->daily;
            return give(key.name, daily.mean, dimension, range, {&daily.mean}, {&daily.amplitude});
        }
        if (!value->table) {
            return give(key.name, value->constant, dimension, range, {&value->constant}, {});
        }
        std::vector<double*> values;
        for (double& one : value->table->y) {
            values.push_back(&one);
        }
        if (!values.empty()) {
            give(key.name, *values.front(), dimension, range, values, {});
        }
    }
    void curve(const Key& key, Table& value, const CurveKeys& keys) override
    {
        std::vector<double*> values;
        for (double& one : value.y) {
            values.push_back(&one);
        }
        if (!values.empty()) {
            give(key.name, *values.front(), keys.y, keys.range, values, {});
        }
    }
    void quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension) override
    {
        push(key.name, key.name);
        for (auto& [name, one] : value) {
            give(name, one, dimension, any_value, {&one}, {});
        }
        frames_.pop_back();
    }
    void text(const Key& key, std::string& value) override
    {
        if (key.name == "name" && !value.empty() && frames_.back().is_item) {
            auto& frame = frames_.back();
            frame.by_name = joined(frames_[frames_.size() - 2].by_name, value);
        }
    }
    std::vector<std::size_t> tagged(std::span<const std::string_view>, std::size_t&, std::span<const std::string_view>,
                                    std::size_t value, std::string_view) override
    {
        return {value};
    }
    void laws(std::string_view, std::string_view chosen, std::span<const Law> laws) override
    {
        for (const auto& law : laws) {
            if (law.name == chosen) {
                law.describe(*this);
            }
        }
    }

    void integer(const Key&, int&, const Range&) override {}
    void flag(const Key&, bool&) override {}
    void path(const Key&, std::string&) override {}
    void choice(const Key&, std::string&, std::span<const std::string_view>) override {}
    void vector(const Key&, std::span<double>, Dimension) override {}
    void vector(const Key&, std::optional<Vec2>&, Dimension) override {}
    void matrix(const Key&, Matrix2&, Dimension) override {}
    void matrix(const Key&, std::optional<Matrix2>&, Dimension) override {}
    void extent(const Key&, double&, double&) override {}
    void quantities(const Key&, std::vector<double>&, Dimension, const Range&) override {}
    void texts(const Key&, std::vector<std::string>&) override {}
    void points(const Key&, std::vector<Vec2>&) override {}
    void loops(const Key&, std::vector<std::vector<Vec2>>&) override {}

protected:
    bool begin_table(const Key& key, bool present) override
    {
        if (present) {
            push(key.name, key.name);
        }
        return present;
    }
    void end_table() override { frames_.pop_back(); }
    bool begin_group(const Key& key, std::vector<std::string>& names, std::string_view) override
    {
        if (!names.empty()) {
            push(key.name, key.name);
        }
        return !names.empty();
    }
    bool begin_member(const std::string& name) override
    {
        push(name, name);
        return true;
    }
    void end_member() override { frames_.pop_back(); }
    void end_group() override { frames_.pop_back(); }
    bool begin_list(const Key& key, std::size_t& count) override
    {
        if (count > 0) {
            push(key.name, key.name);
        }
        return count > 0;
    }
    bool begin_item(std::size_t index) override
    {
        const auto number = fmt::format("{}", index);
        push(number, number);
        frames_.back().is_item = true;
        return true;
    }
    void end_item() override { frames_.pop_back(); }
    void end_list() override { frames_.pop_back(); }

private:
    struct Frame {
        std::string path;
        std::string by_name;
        bool is_item = false;
    };

    void push(std::string_view step, std::string_view name)
    {
        Frame frame{joined(frames_.back().path, step), joined(frames_.back().by_name, name), false};
        frames_.push_back(std::move(frame));
    }
    void give(std::string_view key, double value, Dimension dimension, const Range& range, std::vector<double*> values,
              std::vector<double*> scaled)
    {
        const auto& frame = frames_.back();
        take_({{joined(frame.path, key), joined(frame.by_name, key), value, dimension, range.min, range.max},
               std::move(values),
               std::move(scaled)});
    }

    std::function<void(Found)> take_;
    std::vector<Frame> frames_;
};

/// Collects the texts of values by their paths.
class PathTexts final : public ValueTexts {
public:
    explicit PathTexts(const std::vector<std::string>& paths) : wanted_(paths.begin(), paths.end()) {}

    std::map<std::string, std::string> run(Case& c)
    {
        paths_.emplace_back();
        describe(*this, c);
        return std::move(found_);
    }

    using ValueTexts::quantities;
    void quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension) override
    {
        for (const auto& [name, number] : value) {
            take(joined(joined(paths_.back(), key.name), name), value_text(number, dimension));
        }
    }

protected:
    void put(const Key& key, std::optional<std::string> text) override
    {
        if (text) {
            take(joined(paths_.back(), key.name), *text);
        }
    }
    bool begin_table(const Key& key, bool present) override
    {
        if (present) {
            push(key.name);
        }
        return present;
    }
    void end_table() override { paths_.pop_back(); }
    bool begin_group(const Key& key, std::vector<std::string>&, std::string_view) override
    {
        push(key.name);
        return true;
    }
    bool begin_member(const std::string& name) override
    {
        push(name);
        return true;
    }
    void end_member() override { paths_.pop_back(); }
    void end_group() override { paths_.pop_back(); }
    bool begin_list(const Key& key, std::size_t&) override
    {
        push(key.name);
        return true;
    }
    bool begin_item(std::size_t index) override
    {
        push(fmt::format("{}", index));
        return true;
    }
    void end_item() override { paths_.pop_back(); }
    void end_list() override { paths_.pop_back(); }

private:
    void push(std::string_view step)
    {
        auto path = joined(paths_.back(), step);
        paths_.push_back(std::move(path));
    }
    void take(const std::string& path, const std::string& text)
    {
        if (wanted_.contains(path)) {
            found_[path] = text;
        }
    }

    std::set<std::string> wanted_;
    std::vector<std::string> paths_;
    std::map<std::string, std::string> found_;
};

}  // namespace

std::vector<CaseNumber> numbers_of(const Case& input)
{
    std::vector<CaseNumber> result;
    Case copy = input;
    NumberWalk([&](const Found& found) { result.push_back(found.number); }).run(copy);
    return result;
}

std::vector<const CaseNumber*> numbers_matching(const std::vector<CaseNumber>& numbers, const std::string& pattern)
{
    std::vector<const CaseNumber*> result;
    for (const auto& number : numbers) {
        if (matches(pattern, number.path) || matches(pattern, number.by_name)) {
            result.push_back(&number);
        }
    }
    return result;
}

std::string nearest_key(const std::vector<CaseNumber>& numbers, const std::string& pattern)
{
    std::vector<std::string> names;
    for (const auto& number : numbers) {
        names.push_back(number.by_name);
    }
    if (const auto close = closest_name(pattern, names); !close.empty()) {
        return close;
    }
    const auto shared = [&](const std::string& name) {
        return std::ranges::mismatch(name, pattern).in1 - name.begin();
    };
    const auto best = std::ranges::max_element(names, {}, shared);
    return best == names.end() ? "" : *best;
}

void change_numbers(Case& input, const std::map<std::string, NumberChange>& changes)
{
    NumberWalk([&](const Found& found) {
        const auto change = changes.find(found.number.path);
        if (change == changes.end()) {
            return;
        }
        const auto [factor, shift] = change->second;
        for (double* value : found.values) {
            *value = factor * *value + shift;
            if (!(*value >= found.number.least && *value <= found.number.most)) {
                throw InputError(fmt::format(
                    "{}: {} lies outside the allowed range\n  help: limit the parameter that drives this key",
                    found.number.path, format_quantity(*value, found.number.dimension)));
            }
        }
        for (double* value : found.scaled) {
            *value *= factor;
        }
    }).run(input);
}

std::map<std::string, std::string> texts_of(const Case& input, const std::vector<std::string>& paths)
{
    Case copy = input;
    return PathTexts(paths).run(copy);
}

}  // namespace deadpoint::casefile
