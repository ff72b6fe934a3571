#include "deadpoint/casefile/files/write.hpp"

#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/core/hash.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace deadpoint::casefile {
namespace {

std::string quoted(std::string_view text)
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
    return bare ? std::string(key) : quoted(key);
}

std::string value_text(double value, Dimension dimension)
{
    return dimension == Dimension::none ? format_number(value) : quoted(format_quantity(value, dimension));
}

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

class Writer final : public Visitor {
public:
    std::string run(Case& c)
    {
        frames_.push_back({Layout::block, "", "", true});
        describe(*this, c);
        return frames_.back().body;
    }

    void number(const Key& key, double& value, const Range&) override { emit(key, format_number(value)); }
    void integer(const Key& key, int& value, const Range&) override { emit(key, fmt::format("{}", value)); }
    void flag(const Key& key, bool& value) override { emit(key, value ? "true" : "false"); }
    void text(const Key& key, std::string& value) override
    {
        if (!value.empty() || key.need == Need::required) {
            emit(key, quoted(value));
        }
    }
    void path(const Key& key, std::string& value) override { text(key, value); }
    void choice(const Key& key, std::string& value, std::span<const std::string_view>) override { text(key, value); }
    void quantity(const Key& key, double& value, Dimension dimension, const Range&) override
    {
        emit(key, value_text(value, dimension));
    }
    void quantity(const Key& key, std::optional<double>& value, Dimension dimension, const Range&) override
    {
        if (value) {
            emit(key, value_text(*value, dimension));
        }
    }
    void vector(const Key& key, std::span<double> value, Dimension dimension) override
    {
        emit(key, values_text(value, dimension));
    }
    void vector(const Key& key, std::optional<Vec2>& value, Dimension dimension) override
    {
        if (value) {
            emit(key, values_text(*value, dimension));
        }
    }
    void matrix(const Key& key, Matrix2& value, Dimension dimension) override
    {
        emit(key, matrix_text(value, dimension));
    }
    void matrix(const Key& key, std::optional<Matrix2>& value, Dimension dimension) override
    {
        if (value) {
            emit(key, matrix_text(*value, dimension));
        }
    }
    void extent(const Key& key, double& from, double& to) override
    {
        emit(key, values_text(std::array{from, to}, Dimension::length));
    }
    void quantities(const Key& key, std::vector<double>& value, Dimension dimension, const Range&) override
    {
        if (!value.empty()) {
            emit(key, values_text(value, dimension));
        }
    }
    void quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension) override
    {
        if (value.empty()) {
            return;
        }
        const bool below_root = frames_.size() == 1;
        frames_.push_back({below_root ? Layout::block : Layout::braces, std::string(key.name), "", true});
        for (const auto& [name, number] : value) {
            emit({name, ""}, value_text(number, dimension));
        }
        end_table();
    }
    void texts(const Key& key, std::vector<std::string>& value) override
    {
        if (!value.empty()) {
            emit(key, list_text(value, [](const std::string& text) { return quoted(text); }));
        }
    }
    void points(const Key& key, std::vector<Vec2>& value) override { emit(key, points_text(value)); }
    void loops(const Key& key, std::vector<std::vector<Vec2>>& value) override
    {
        if (!value.empty()) {
            emit(key, list_text(value, points_text));
        }
    }
    void curve(const Key& key, Table& value, const CurveKeys& keys) override
    {
        if (!value.x.empty()) {
            emit(key, curve_text(value, keys.x_name, keys.x, keys.y));
        }
    }
    void property(const Key& key, double& constant, Table& table, Dimension dimension, const Range&) override
    {
        emit(key, table.x.empty() ? value_text(constant, dimension)
                                  : curve_text(table, "temperature", Dimension::temperature, dimension));
    }
    void course(const Key& key, std::optional<Course>& value, Dimension dimension, const Range&) override
    {
        if (!value) {
            return;
        }
        if (value->daily) {
            return emit(key, daily_text(*value->daily));
        }
        emit(key, value->table ? curve_text(*value->table, "time", Dimension::time, dimension)
                               : value_text(value->constant, dimension));
    }
    std::vector<std::size_t> tagged(std::span<const std::string_view> keys, std::size_t& key,
                                    std::span<const std::string_view> values, std::size_t value,
                                    std::string_view) override
    {
        emit({keys[key], ""}, quoted(values[value]));
        return {value};
    }

protected:
    bool begin_table(const Key& key, bool present) override
    {
        if (!present) {
            return false;
        }
        const bool below_root = frames_.size() == 1;
        frames_.push_back({below_root ? Layout::block : Layout::braces, std::string(key.name), "", true});
        return true;
    }
    void end_table() override
    {
        const Frame frame = take();
        if (frame.layout == Layout::braces) {
            emit({frame.name, ""}, braces(frame));
        } else {
            top().body += fmt::format("\n[{}]\n{}", frame.name, frame.body);
        }
    }
    bool begin_group(const Key& key, std::vector<std::string>& names, std::string_view) override
    {
        if (names.empty()) {
            return false;
        }
        frames_.push_back({Layout::block, std::string(key.name), "", true});
        return true;
    }
    bool begin_member(const std::string& name) override
    {
        frames_.push_back({Layout::block, fmt::format("{}.{}", top().name, key_text(name)), "", true});
        return true;
    }
    void end_member() override
    {
        const Frame frame = take();
        top().body += fmt::format("\n[{}]\n{}", frame.name, frame.body);
    }
    void end_group() override
    {
        const Frame frame = take();
        top().body += frame.body;
    }
    bool begin_list(const Key& key, std::size_t& count) override
    {
        if (count == 0) {
            return false;
        }
        const bool below_root = frames_.size() == 1;
        frames_.push_back({below_root ? Layout::block : Layout::list, std::string(key.name), "", true});
        return true;
    }
    bool begin_item(std::size_t) override
    {
        frames_.push_back({top().layout == Layout::block ? Layout::block : Layout::braces, "", "", true});
        return true;
    }
    void end_item() override
    {
        const Frame frame = take();
        if (frame.layout == Layout::braces) {
            add_item(top(), braces(frame));
        } else {
            top().body += fmt::format("\n[[{}]]\n{}", top().name, frame.body);
        }
    }
    void end_list() override
    {
        const Frame frame = take();
        if (frame.layout == Layout::list) {
            emit({frame.name, ""}, list_in(top(), frame));
        } else {
            top().body += frame.body;
        }
    }

private:
    enum class Layout { block, braces, list };
    struct Frame {
        Layout layout;
        std::string name;
        std::string body;
        bool first;
    };

    static std::string braces(const Frame& frame) { return "{ " + frame.body + " }"; }

    /// Items of a list in a section stand on lines of their own, those of a list in braces on one line.
    void add_item(Frame& list, const std::string& item) const
    {
        const bool inside_braces = frames_[frames_.size() - 2].layout == Layout::braces;
        list.body += inside_braces ? fmt::format("{}{}", list.first ? "" : ", ", item) : fmt::format("    {},\n", item);
        list.first = false;
    }
    static std::string list_in(const Frame& parent, const Frame& list)
    {
        return parent.layout == Layout::braces ? "[" + list.body + "]" : "[\n" + list.body + "]";
    }

    Frame& top() { return frames_.back(); }
    Frame take()
    {
        Frame frame = std::move(frames_.back());
        frames_.pop_back();
        return frame;
    }

    void emit(const Key& key, const std::string& value)
    {
        auto& frame = top();
        if (frame.layout == Layout::block) {
            frame.body += fmt::format("{} = {}\n", key_text(key.name), value);
        } else {
            frame.body += fmt::format("{}{} = {}", frame.first ? "" : ", ", key_text(key.name), value);
        }
        frame.first = false;
    }

    std::vector<Frame> frames_;
};

}  // namespace

std::string write_case(const Case& c)
{
    Case copy = c;
    return Writer().run(copy);
}

std::string case_hash(const Case& c) { return stable_hash(write_case(c)); }

}  // namespace deadpoint::casefile
