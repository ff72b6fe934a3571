#include "deadpoint/casefile/syntax/value_texts.hpp"

#include "deadpoint/core/quantity.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace deadpoint::casefile {

std::string in_quotes(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            result += fmt::format("\\{}", c);
        } else if (c == '\n') {
            result += "\\n";
        } else if (c == '\t') {
            result += "\\t";
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            result += fmt::format("\\u{:04x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
        } else {
            result += c;
        }
    }
    return result + "\"";
}

std::string key_text(std::string_view key)
{
    const bool bare = !key.empty() && std::ranges::all_of(key, [](unsigned char c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '-';
    });
    return bare ? std::string(key) : in_quotes(key);
}

std::string value_text(double value, Dimension dimension)
{
    return dimension == Dimension::none ? format_number(value) : in_quotes(format_quantity(value, dimension));
}

namespace {

template <class Values, class Show>
std::string list_text(const Values& values, Show show)
{
    std::string text;
    for (const auto& value : values) {
        text += (text.empty() ? "" : ", ") + show(value);
    }
    return "[" + text + "]";
}

std::string values_text(std::span<const double> values, Dimension dimension)
{
    return list_text(values, [&](double v) { return value_text(v, dimension); });
}

/// One value where both directions are alike and apart.
std::string matrix_text(const Matrix2& m, Dimension dimension)
{
    if (m[0][0] == m[1][1] && m[0][1] == 0 && m[1][0] == 0) {
        return value_text(m[0][0], dimension);
    }
    return list_text(m, [&](const auto& row) { return values_text(row, dimension); });
}

std::string points_text(const std::vector<Vec2>& points)
{
    return list_text(points, [](const Vec2& p) { return values_text(p, Dimension::length); });
}

std::string curve_text(const Table& table, std::string_view x_name, Dimension x, Dimension y)
{
    return fmt::format("{{ {} = {}, value = {} }}", x_name, values_text(table.x, x), values_text(table.y, y));
}

std::string daily_text(const DailyCourse& daily)
{
    return fmt::format("{{ mean = {}, amplitude = {}, time_of_maximum = {}, period = {} }}",
                       value_text(daily.mean, Dimension::temperature),
                       value_text(daily.amplitude, Dimension::temperature_difference),
                       value_text(daily.time_of_maximum, Dimension::time), value_text(daily.period, Dimension::time));
}

/// Collects the keys of a law.
class KeyTexts final : public ValueTexts {
public:
    /// @param defaults  leave out the keys that a law requires; their default only marks a missing value
    explicit KeyTexts(bool defaults) : defaults_(defaults) {}

    std::vector<LawKey> take() { return std::move(keys_); }
    void choice(const Key& key, std::string& value, std::span<const std::string_view> options) override
    {
        if (defaults_ && key.need == Need::required) {
            return put({key.name, key.meaning, Need::of_law}, {});
        }
        ValueTexts::choice(key, value, options);
    }

protected:
    void put(const Key& key, std::optional<std::string> text) override
    {
        if (defaults_ && key.need == Need::of_law) {
            text.reset();
        }
        keys_.push_back({std::string(key.name), std::move(text)});
    }

private:
    bool defaults_;
    std::vector<LawKey> keys_;
};

}  // namespace

void ValueTexts::number(const Key& key, double& value, const Range&) { put(key, format_number(value)); }

void ValueTexts::integer(const Key& key, int& value, const Range&) { put(key, fmt::format("{}", value)); }

void ValueTexts::flag(const Key& key, bool& value) { put(key, value ? "true" : "false"); }

void ValueTexts::text(const Key& key, std::string& value)
{
    const bool stated = !value.empty() || key.need == Need::required;
    put(key, stated ? std::optional(in_quotes(value)) : std::nullopt);
}

void ValueTexts::path(const Key& key, std::string& value) { text(key, value); }

void ValueTexts::choice(const Key& key, std::string& value, std::span<const std::string_view>) { text(key, value); }

void ValueTexts::quantity(const Key& key, double& value, Dimension dimension, const Range&)
{
    put(key, value_text(value, dimension));
}

void ValueTexts::quantity(const Key& key, std::optional<double>& value, Dimension dimension, const Range&)
{
    put(key, value ? std::optional(value_text(*value, dimension)) : std::nullopt);
}

void ValueTexts::vector(const Key& key, std::span<double> value, Dimension dimension)
{
    put(key, values_text(value, dimension));
}

void ValueTexts::vector(const Key& key, std::optional<Vec2>& value, Dimension dimension)
{
    put(key, value ? std::optional(values_text(*value, dimension)) : std::nullopt);
}

void ValueTexts::matrix(const Key& key, Matrix2& value, Dimension dimension)
{
    put(key, matrix_text(value, dimension));
}

void ValueTexts::matrix(const Key& key, std::optional<Matrix2>& value, Dimension dimension)
{
    put(key, value ? std::optional(matrix_text(*value, dimension)) : std::nullopt);
}

void ValueTexts::extent(const Key& key, double& from, double& to)
{
    put(key, values_text(std::array{from, to}, Dimension::length));
}

void ValueTexts::quantities(const Key& key, std::vector<double>& value, Dimension dimension, const Range&)
{
    put(key, value.empty() ? std::nullopt : std::optional(values_text(value, dimension)));
}

void ValueTexts::quantities(const Key&, std::map<std::string, double>&, Dimension) {}

void ValueTexts::texts(const Key& key, std::vector<std::string>& value)
{
    put(key, value.empty() ? std::nullopt
                           : std::optional(list_text(value, [](const std::string& text) { return in_quotes(text); })));
}

void ValueTexts::points(const Key& key, std::vector<Vec2>& value) { put(key, points_text(value)); }

void ValueTexts::loops(const Key& key, std::vector<std::vector<Vec2>>& value)
{
    put(key, value.empty() ? std::nullopt : std::optional(list_text(value, points_text)));
}

void ValueTexts::curve(const Key& key, Table& value, const CurveKeys& keys)
{
    put(key, value.x.empty() ? std::nullopt : std::optional(curve_text(value, keys.x_name, keys.x, keys.y)));
}

void ValueTexts::property(const Key& key, double& constant, Table& table, Dimension dimension, const Range&)
{
    put(key, table.x.empty() ? value_text(constant, dimension)
                             : curve_text(table, "temperature", Dimension::temperature, dimension));
}

void ValueTexts::course(const Key& key, std::optional<Course>& value, Dimension dimension, const Range&)
{
    if (!value) {
        return put(key, {});
    }
    if (value->daily) {
        return put(key, daily_text(*value->daily));
    }
    put(key, value->table ? curve_text(*value->table, "time", Dimension::time, dimension)
                          : value_text(value->constant, dimension));
}

std::vector<std::size_t> ValueTexts::tagged(std::span<const std::string_view> keys, std::size_t& key,
                                            std::span<const std::string_view> values, std::size_t value,
                                            std::string_view)
{
    put({keys[key], ""}, in_quotes(values[value]));
    return {value};
}

void ValueTexts::laws(std::string_view, std::string_view chosen, std::span<const Law> laws)
{
    for (const auto& key : merged_keys(laws, chosen)) {
        put({key.name, ""}, key.text);
    }
}

bool ValueTexts::begin_table(const Key&, bool) { return false; }

bool ValueTexts::begin_group(const Key&, std::vector<std::string>&, std::string_view) { return false; }

bool ValueTexts::begin_member(const std::string&) { return false; }

bool ValueTexts::begin_list(const Key&, std::size_t&) { return false; }

bool ValueTexts::begin_item(std::size_t) { return false; }

std::vector<LawKey> fresh_keys(const Law& law, Visitor* reader)
{
    KeyTexts texts(true);
    if (reader != nullptr) {
        law.describe_fresh({reader, &texts});
    } else {
        law.describe_fresh({&texts});
    }
    return texts.take();
}

std::vector<LawKey> merged_keys(std::span<const Law> laws, std::string_view chosen)
{
    std::vector<LawKey> merged, own;
    for (const auto& law : laws) {
        merge(merged, fresh_keys(law), &LawKey::name);
        if (law.name == chosen) {
            KeyTexts texts(false);
            law.describe(texts);
            own = texts.take();
        }
    }
    for (auto& key : merged) {
        const auto stated = std::ranges::find(own, key.name, &LawKey::name);
        if (stated != own.end()) {
            key.text = stated->text;
        }
    }
    return merged;
}

}  // namespace deadpoint::casefile
