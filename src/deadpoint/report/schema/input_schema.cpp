#include "deadpoint/report/schema/input_schema.hpp"

#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/error.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace deadpoint::report::schema {
namespace {

using namespace casefile;
using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> kinds{"case", "study", "calibration", "reference"};

Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }
Json list_of(Json items, std::size_t count)
{
    auto list = list_of(std::move(items));
    list["minItems"] = list["maxItems"] = count;
    return list;
}
Json any_of(std::initializer_list<Json> forms) { return {{"anyOf", Json(std::vector<Json>(forms))}}; }

Json plain_number(const casefile::Range& range)
{
    Json form{{"type", "number"}};
    if (std::isfinite(range.min)) {
        form[range.open ? "exclusiveMinimum" : "minimum"] = range.min;
    }
    if (std::isfinite(range.max)) {
        form[range.open ? "exclusiveMaximum" : "maximum"] = range.max;
    }
    return form;
}

/// A text with a unit, "200 mm"; a number where there is none.
Json quantity_of(deadpoint::Dimension dimension)
{
    if (dimension == deadpoint::Dimension::none) {
        return {{"type", "number"}};
    }
    return {{"type", "string"},
            {"pattern", "^\\s*[-+]?([0-9]|\\.[0-9])"},
            {"examples", {dimension_info(dimension).example}}};
}

Json object_of(Json properties)
{
    return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json curve_of(std::string_view x_name, deadpoint::Dimension x, deadpoint::Dimension y)
{
    return object_of({{std::string(x_name), list_of(quantity_of(x))}, {"value", list_of(quantity_of(y))}});
}

/// Makes the description of a kind of file into a schema.
class SchemaWriter final : public Visitor {
public:
    template <class File>
    Json run(std::string_view what)
    {
        File defaults;
        stack_.push_back(object_of(Json::object()));
        describe(*this, defaults);
        Json head{{"$schema", "http://json-schema.org/draft-07/schema#"},
                  {"title", fmt::format("deadpoint {} file", what)}};
        head.update(stack_.back());
        return head;
    }

    void about(std::string_view sentences) override { stack_.back()["description"] = sentences; }
    void number(const casefile::Key& key, double& value, const casefile::Range& range) override
    {
        add(key, plain_number(range), Json(value));
    }
    void integer(const casefile::Key& key, int& value, const casefile::Range& range) override
    {
        auto form = plain_number(range);
        form["type"] = "integer";
        add(key, std::move(form), value < range.min ? Json() : Json(value));
    }
    void flag(const casefile::Key& key, bool& value) override { add(key, {{"type", "boolean"}}, Json(value)); }
    void text(const casefile::Key& key, std::string& value) override { add(key, {{"type", "string"}}, shown(value)); }
    void path(const casefile::Key& key, std::string& value) override { add(key, {{"type", "string"}}, shown(value)); }
    void choice(const casefile::Key& key, std::string& value, std::span<const std::string_view> options) override
    {
        add(key, {{"type", "string"}, {"enum", options}}, shown(value));
    }
    void quantity(const casefile::Key& key, double& value, deadpoint::Dimension dimension,
                  const casefile::Range&) override
    {
        add(key, quantity_of(dimension),
            std::isfinite(value) && value != 0 ? Json(format_quantity(value, dimension)) : Json(), dimension);
    }
    void quantity(const casefile::Key& key, std::optional<double>&, deadpoint::Dimension dimension,
                  const casefile::Range&) override
    {
        add(key, quantity_of(dimension), {}, dimension);
    }
    void vector(const casefile::Key& key, std::span<double> value, deadpoint::Dimension dimension) override
    {
        add(key, list_of(quantity_of(dimension), value.size()), {}, dimension);
    }
    void vector(const casefile::Key& key, std::optional<Vec2>&, deadpoint::Dimension dimension) override
    {
        add(key, list_of(quantity_of(dimension), 2), {}, dimension);
    }
    void matrix(const casefile::Key& key, Matrix2&, deadpoint::Dimension dimension) override
    {
        add(key, matrix_of(dimension), {}, dimension);
    }
    void matrix(const casefile::Key& key, std::optional<Matrix2>&, deadpoint::Dimension dimension) override
    {
        add(key, matrix_of(dimension), {}, dimension);
    }
    void extent(const casefile::Key& key, double&, double&) override
    {
        add(key, list_of(quantity_of(deadpoint::Dimension::length), 2));
    }
    void quantities(const casefile::Key& key, std::vector<double>&, deadpoint::Dimension dimension,
                    const casefile::Range&) override
    {
        add(key, list_of(quantity_of(dimension)), {}, dimension);
    }
    void quantities(const casefile::Key& key, std::map<std::string, double>&, deadpoint::Dimension dimension) override
    {
        add(key, {{"type", "object"}, {"additionalProperties", quantity_of(dimension)}}, {}, dimension);
    }
    void texts(const casefile::Key& key, std::vector<std::string>&) override
    {
        add(key, list_of({{"type", "string"}}));
    }
    void setting(const casefile::Key& key, std::string&) override { add(key, Json::object()); }
    void settings(const casefile::Key& key, std::vector<std::vector<std::string>>&) override
    {
        add(key, list_of(Json::object()));
    }
    void points(const casefile::Key& key, std::vector<Vec2>&) override
    {
        add(key, list_of(list_of(quantity_of(deadpoint::Dimension::length), 2)));
    }
    void loops(const casefile::Key& key, std::vector<std::vector<Vec2>>&) override
    {
        add(key, list_of(list_of(list_of(quantity_of(deadpoint::Dimension::length), 2))));
    }
    void curve(const casefile::Key& key, Table&, const CurveKeys& keys) override
    {
        add(key, curve_of(keys.x_name, keys.x, keys.y));
    }
    void property(const casefile::Key& key, double&, Table&, deadpoint::Dimension dimension,
                  const casefile::Range&) override
    {
        add(key,
            any_of({quantity_of(dimension), curve_of("temperature", deadpoint::Dimension::temperature, dimension)}), {},
            dimension);
    }
    void course(const casefile::Key& key, std::optional<Course>&, deadpoint::Dimension dimension,
                const casefile::Range&) override
    {
        const auto daily = object_of({{"mean", quantity_of(dimension)},
                                      {"amplitude", quantity_of(deadpoint::Dimension::temperature_difference)},
                                      {"time_of_maximum", quantity_of(deadpoint::Dimension::time)}});
        const auto over_time = curve_of("time", deadpoint::Dimension::time, dimension);
        add(key,
            dimension == deadpoint::Dimension::temperature ? any_of({quantity_of(dimension), over_time, daily})
                                                           : any_of({quantity_of(dimension), over_time}),
            {}, dimension);
    }
    std::vector<std::size_t> tagged(std::span<const std::string_view> keys, std::size_t&,
                                    std::span<const std::string_view> values, std::size_t,
                                    std::string_view meaning) override
    {
        for (const auto key : keys) {
            add({key, meaning}, {{"type", "string"}, {"enum", values}});
        }
        std::vector<std::size_t> all(values.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = i;
        }
        return all;
    }
    void laws(std::string_view, std::string_view, std::span<const Law> laws) override
    {
        for (const auto& law : laws) {
            law.describe_fresh({this});
        }
    }

protected:
    bool begin_table(const casefile::Key& key, bool) override
    {
        open(key);
        return true;
    }
    void end_table() override
    {
        const auto [key, table] = close();
        add(key, table);
    }
    bool begin_group(const casefile::Key& key, std::vector<std::string>& names, std::string_view) override
    {
        open(key);
        names = {"*"};
        return true;
    }
    bool begin_member(const std::string&) override { return true; }
    void end_member() override {}
    void end_group() override
    {
        const auto [key, table] = close();
        add(key, {{"type", "object"}, {"additionalProperties", table}});
    }
    bool begin_list(const casefile::Key& key, std::size_t& count) override
    {
        open(key);
        count = 1;
        return true;
    }
    bool begin_item(std::size_t) override { return true; }
    void end_item() override {}
    void end_list() override
    {
        const auto [key, table] = close();
        add(key, list_of(table));
    }

private:
    static Json shown(const std::string& text) { return text.empty() ? Json() : Json(text); }
    static Json matrix_of(deadpoint::Dimension dimension)
    {
        return any_of({quantity_of(dimension), list_of(list_of(quantity_of(dimension), 2), 2)});
    }

    void open(const casefile::Key& key)
    {
        keys_.push_back(key);
        stack_.push_back(object_of(Json::object()));
    }
    std::pair<casefile::Key, Json> close()
    {
        std::pair<casefile::Key, Json> closed{keys_.back(), std::move(stack_.back())};
        keys_.pop_back();
        stack_.pop_back();
        return closed;
    }

    /// Adds a key to the current table. A key of several laws or forms of a table may hold the values of each.
    void add(const casefile::Key& key, Json form, Json standard = {},
             deadpoint::Dimension dimension = deadpoint::Dimension::none)
    {
        auto& properties = stack_.back()["properties"];
        const std::string name(key.name);
        std::string meaning(key.meaning);
        if (dimension != deadpoint::Dimension::none) {
            meaning += fmt::format(" ({}, \"{}\")", dimension_info(dimension).name, dimension_info(dimension).example);
        }
        if (!meaning.empty()) {
            const auto below = form.value("description", "");
            form["description"] = below.empty() ? meaning : meaning + ". " + below;
        }
        if (!standard.is_null() && key.need == Need::optional) {
            form["default"] = std::move(standard);
        }
        if (!properties.contains(name)) {
            properties[name] = std::move(form);
        } else if (properties[name] != form) {
            add_form(properties[name], std::move(form));
        }
    }
    static void add_form(Json& known, Json form)
    {
        if (!known.contains("anyOf") || known.size() > 1) {
            known = Json{{"anyOf", Json::array({known})}};
        }
        known["anyOf"].push_back(std::move(form));
    }

    std::vector<Json> stack_;          ///< tables that are being described
    std::vector<casefile::Key> keys_;  ///< of those below the root
};

Json schema_of(std::string_view kind)
{
    if (kind == "case") {
        return SchemaWriter().run<Case>(kind);
    }
    if (kind == "study") {
        return SchemaWriter().run<StudyFile>(kind);
    }
    if (kind == "calibration") {
        return SchemaWriter().run<CalibrationFile>(kind);
    }
    if (kind == "reference") {
        return SchemaWriter().run<ReferenceFile>(kind);
    }
    throw InputError(
        fmt::format("there is no schema of '{}' files\n  help: give one of {}", kind, fmt::join(kinds, ", ")));
}

}  // namespace

std::span<const std::string_view> input_kinds() { return kinds; }

std::string input_schema(std::string_view kind)
{
    auto schema = schema_of(kind);
    if (kind == "case") {
        schema["properties"]["include"] = {{"description", "files whose values this file completes or replaces"},
                                           {"anyOf", {{{"type", "string"}}, list_of({{"type", "string"}})}}};
        schema["properties"]["replace"] = list_of({{"type", "string"}});
        schema["properties"]["replace"]["description"] =
            "values that replace those of included files, written as for --set";
    }
    return schema.dump(2) + "\n";
}

}  // namespace deadpoint::report::schema
