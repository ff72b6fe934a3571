#include "deadpoint/casefile/syntax/case_bytes.hpp"

#include "deadpoint/casefile/describe/visitor.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace deadpoint::casefile {
namespace {

/// Appends each value, with its length where it has one. A mark tells what a table has not, so that no two tables look
/// alike.
class Bytes final : public Visitor {
public:
    std::vector<CasePart> run(Case& c)
    {
        describe(*this, c);
        return std::move(parts_);
    }

    void number(const Key&, double& value, const Range&) override { add(value); }
    void integer(const Key& key, int& value, const Range&) override
    {
        begin(key);
        add(value);
    }
    void flag(const Key&, bool& value) override { add(value); }
    void text(const Key&, std::string& value) override { add(value); }
    void path(const Key&, std::string& value) override { add(value); }
    void choice(const Key&, std::string& value, std::span<const std::string_view>) override { add(value); }
    void quantity(const Key&, double& value, Dimension, const Range&) override { add(value); }
    void quantity(const Key&, std::optional<double>& value, Dimension, const Range&) override { add(value); }
    void vector(const Key&, std::span<double> value, Dimension) override
    {
        std::ranges::for_each(value, [&](double v) { add(v); });
    }
    void vector(const Key&, std::optional<Vec2>& value, Dimension) override { add(value); }
    void matrix(const Key&, Matrix2& value, Dimension) override { add(value); }
    void matrix(const Key&, std::optional<Matrix2>& value, Dimension) override { add(value); }
    void extent(const Key&, double& from, double& to) override
    {
        add(from);
        add(to);
    }
    void quantities(const Key&, std::vector<double>& value, Dimension, const Range&) override { add(value); }
    void quantities(const Key& key, std::map<std::string, double>& value, Dimension) override
    {
        begin(key);
        add(value.size());
        for (const auto& [name, number] : value) {
            add(name);
            add(number);
        }
    }
    void texts(const Key&, std::vector<std::string>& value) override { add(value); }
    void points(const Key&, std::vector<Vec2>& value) override { add(value); }
    void loops(const Key&, std::vector<std::vector<Vec2>>& value) override { add(value); }
    void curve(const Key&, Table& value, const CurveKeys&) override { add(value); }
    void property(const Key&, double& constant, Table& table, Dimension, const Range&) override
    {
        add(constant);
        add(table);
    }
    void course(const Key&, std::optional<Course>& value, Dimension, const Range&) override
    {
        add(value.has_value());
        if (!value) {
            return;
        }
        add(value->constant);
        add(value->table);
        add(value->daily);
    }
    std::vector<std::size_t> tagged(std::span<const std::string_view>, std::size_t& key,
                                    std::span<const std::string_view>, std::size_t value, std::string_view) override
    {
        add(key);
        add(value);
        return {value};
    }
    void laws(std::string_view, std::string_view chosen, std::span<const Law> laws) override
    {
        const auto law = std::ranges::find(laws, chosen, &Law::name);
        if (law != laws.end()) {
            law->describe(*this);
        }
    }

protected:
    bool begin_table(const Key& key, bool present) override
    {
        begin(key);
        add(present);
        depth_ += present ? 1 : 0;
        return present;
    }
    void end_table() override { --depth_; }
    bool begin_group(const Key& key, std::vector<std::string>&, std::string_view) override
    {
        group_ = key.name;
        return true;
    }
    bool begin_member(const std::string& name) override
    {
        parts_.push_back({fmt::format("{}.{}", group_, name), {}});
        ++depth_;
        return true;
    }
    void end_member() override { --depth_; }
    void end_group() override {}
    bool begin_list(const Key& key, std::size_t& count) override
    {
        begin(key);
        add(count);
        ++depth_;
        return true;
    }
    bool begin_item(std::size_t) override { return true; }
    void end_item() override {}
    void end_list() override { --depth_; }

private:
    /// A key of the case itself begins a part.
    void begin(const Key& key)
    {
        if (depth_ == 0) {
            parts_.push_back({std::string(key.name), {}});
        }
    }
    template <class Value>
    requires std::is_arithmetic_v<Value>
    void add(Value value) { parts_.back().bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }
    void add(const std::string& text)
    {
        add(text.size());
        parts_.back().bytes += text;
    }
    template <class Value, std::size_t count>
    void add(const std::array<Value, count>& values)
    {
        for (const auto& value : values) {
            add(value);
        }
    }
    template <class Value>
    void add(const std::vector<Value>& values)
    {
        add(values.size());
        for (const auto& value : values) {
            add(value);
        }
    }
    template <class Value>
    void add(const std::optional<Value>& value)
    {
        add(value.has_value());
        if (value) {
            add(*value);
        }
    }
    void add(const Table& table)
    {
        add(table.x);
        add(table.y);
    }
    void add(const DailyCourse& daily)
    {
        add(daily.mean);
        add(daily.amplitude);
        add(daily.time_of_maximum);
        add(daily.period);
    }

    std::vector<CasePart> parts_;
    std::string group_;
    int depth_ = 0;
};

}  // namespace

std::vector<CasePart> case_parts(Case c) { return Bytes().run(c); }

std::string case_bytes(Case c)
{
    std::string result;
    for (const auto& [path, bytes] : case_parts(std::move(c))) {
        result += fmt::format("{} {}\n", path, bytes.size());
        result += bytes;
    }
    return result;
}

}  // namespace deadpoint::casefile
