#include "deadpoint/casefile/reference/reference.hpp"

#include "deadpoint/casefile/describe/library.hpp"
#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/casefile/syntax/value_texts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace deadpoint::casefile {
namespace {

/// Like format_quantity(), without the last digits, which can be rounding of a conversion from SI units.
std::string plain_quantity(double value, Dimension dimension)
{
    const auto text = format_quantity(value, dimension);
    const auto parts = number_and_unit(text);
    return parts ? fmt::format("{:.12g} {}", parts->number, parts->unit) : text;
}

std::string range_suffix(const Range& range, Dimension dimension)
{
    if (dimension == Dimension::temperature) {
        return "";
    }
    const bool above = std::isfinite(range.min);
    const bool below = std::isfinite(range.max);
    const std::string_view relation = range.open ? "<" : "<=";
    if (above && below && range.min == range.max) {
        return fmt::format(", {}", range.min);
    }
    if (above && below) {
        return fmt::format(", {} {} value {} {}", range.min, relation, relation, range.max);
    }
    if (above) {
        return fmt::format(", {} {}", range.open ? ">" : ">=", range.min);
    }
    if (below) {
        return fmt::format(", {} {}", relation, range.max);
    }
    return "";
}

std::string example_of(Dimension dimension)
{
    const auto& info = dimension_info(dimension);
    if (dimension == Dimension::none) {
        return std::string(info.name);
    }
    return fmt::format("{} (`\"{}\"`)", info.name, info.example);
}

class ReferenceWriter final : public Visitor {
public:
    template <class File>
    std::string run(std::string_view what)
    {
        File defaults;
        open(fmt::format("The {}", what), "", 1);
        describe(*this, defaults);
        std::string page =
            fmt::format("<!-- Written by the program from its own description of the {}. Do not edit. -->\n", what);
        for (const auto& section : sections_) {
            page += text_of(section);
        }
        return page;
    }

    void about(std::string_view sentences) override { current().about = sentences; }
    void alternative(std::string_view name) override
    {
        if (in_alternative_) {
            close();
        }
        in_alternative_ = true;
        const auto& parent = current();
        open(fmt::format("{} = \"{}\"", parent.alternatives, name), parent.path, 4);
    }
    void number(const Key& key, double& value, const Range& range) override
    {
        row(key, "a plain number" + range_suffix(range, Dimension::none), fmt::format("`{}`", value));
    }
    void integer(const Key& key, int& value, const Range& range) override
    {
        row(key, "a whole number" + range_suffix(range, Dimension::none),
            value < range.min ? "" : fmt::format("`{}`", value));
    }
    void flag(const Key& key, bool& value) override { row(key, "true or false", value ? "`true`" : "`false`"); }
    void text(const Key& key, std::string& value) override { row(key, "text", shown(value)); }
    void path(const Key& key, std::string& value) override { row(key, "file name", shown(value)); }
    void choice(const Key& key, std::string& value, std::span<const std::string_view> options) override
    {
        row(key, choices(options), key.name == "axis" ? "" : shown(value));
    }
    void quantity(const Key& key, double& value, Dimension dimension, const Range& range) override
    {
        row(key, example_of(dimension) + range_suffix(range, dimension),
            fmt::format("`\"{}\"`", plain_quantity(value, dimension)));
    }
    void quantity(const Key& key, std::optional<double>&, Dimension dimension, const Range& range) override
    {
        row(key, example_of(dimension) + range_suffix(range, dimension), "");
    }
    void vector(const Key& key, std::span<double> value, Dimension dimension) override
    {
        std::string list;
        for (const double v : value) {
            const auto text = dimension == Dimension::none ? fmt::format("{}", v)
                                                           : fmt::format("\"{}\"", plain_quantity(v, dimension));
            list += (list.empty() ? "" : ", ") + text;
        }
        row(key, fmt::format("[{} times {}]", value.size(), dimension_info(dimension).name), "`[" + list + "]`");
    }
    void vector(const Key& key, std::optional<Vec2>&, Dimension dimension) override
    {
        row(key, fmt::format("[2 times {}]", dimension_info(dimension).name), "");
    }
    void matrix(const Key& key, Matrix2&, Dimension dimension) override
    {
        row(key, example_of(dimension) + ", or [[xx, xy], [yx, yy]]", key.need == Need::required ? "" : "`0`");
    }
    void matrix(const Key& key, std::optional<Matrix2>&, Dimension dimension) override
    {
        row(key, example_of(dimension) + ", or [[xx, xy], [yx, yy]]", "");
    }
    void extent(const Key& key, double&, double&) override { row(key, "[from, to], two lengths", ""); }
    void quantities(const Key& key, std::vector<double>&, Dimension dimension, const Range& range) override
    {
        row(key, "a list, each " + example_of(dimension) + range_suffix(range, dimension), "");
    }
    void quantities(const Key& key, std::map<std::string, double>&, Dimension dimension) override
    {
        row(key, fmt::format("`{{ name = \"{}\", ... }}`", dimension_info(dimension).example), "");
    }
    void texts(const Key& key, std::vector<std::string>&) override { row(key, "a list of texts", ""); }
    void setting(const Key& key, std::string&) override { row(key, "text or number", ""); }
    void settings(const Key& key, std::vector<std::vector<std::string>>&) override
    {
        row(key, "a list of texts or numbers, or of such lists", "");
    }
    void points(const Key& key, std::vector<Vec2>&) override { row(key, "a list of points [a, b]", ""); }
    void loops(const Key& key, std::vector<std::vector<Vec2>>&) override { row(key, "a list of lists of points", ""); }
    void curve(const Key& key, Table&, const CurveKeys& keys) override
    {
        row(key,
            fmt::format("`{{ {} = [\"{}\", ...], value = [\"{}\", ...] }}`", keys.x_name,
                        dimension_info(keys.x).example, dimension_info(keys.y).example),
            "");
    }
    void property(const Key& key, double&, Table&, Dimension dimension, const Range& range) override
    {
        row(key,
            example_of(dimension) + range_suffix(range, dimension) +
                ", or a table over temperature `{ temperature = [...], value = [...] }`",
            "");
    }
    void course(const Key& key, std::optional<Course>&, Dimension dimension, const Range& range) override
    {
        row(key,
            example_of(dimension) + range_suffix(range, dimension) +
                ", or a table over time `{ time = [...], value = [...] }`, with the same time twice where it jumps" +
                (dimension == Dimension::temperature ? ", or a daily course `{ mean = \"20 degC\", amplitude = \"3 "
                                                       "K\", time_of_maximum = \"6 h\" }` on "
                                                       "the clock of the run"
                                                     : ""),
            "");
    }
    std::vector<std::size_t> tagged(std::span<const std::string_view> keys, std::size_t& key,
                                    std::span<const std::string_view> values, std::size_t,
                                    std::string_view meaning) override
    {
        std::string names;
        for (const auto name : keys) {
            names += fmt::format("{}`{}`", names.empty() ? "" : ", ", name);
        }
        current().rows.push_back(
            {"", fmt::format("| one of {} | {} | required | {} |\n", names, choices(values), meaning)});
        current().alternatives = keys[key];
        std::vector<std::size_t> all(values.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i] = i;
        }
        return all;
    }
    void laws(std::string_view, std::string_view, std::span<const Law> laws) override
    {
        std::vector<Row> merged;
        const auto before = std::exchange(current().rows, {});
        for (const auto& law : laws) {
            law.describe_fresh({this});
            merge(merged, std::exchange(current().rows, {}), &Row::key);
        }
        current().rows = before;
        current().rows.insert(current().rows.end(), merged.begin(), merged.end());
    }

protected:
    bool begin_table(const Key& key, bool present) override
    {
        const bool is_root = stack_.size() == 1;
        const std::string below = is_root ? "" : current().path + ".";
        if (is_root) {
            row(key, fmt::format("[section](#{})", key.name), present ? "" : "none");
        } else {
            row(key, "a table, see below", "");
        }
        open(is_root ? fmt::format("[{}]", key.name) : below + std::string(key.name), below + std::string(key.name),
             is_root ? 2 : 3);
        return true;
    }
    void end_table() override { close(); }
    bool begin_group(const Key& key, std::vector<std::string>& names, std::string_view placeholder) override
    {
        row(key, "sections by name, see below", "");
        open(fmt::format("[{}.<{}>]", key.name, placeholder), fmt::format("{}.<{}>", key.name, placeholder), 2);
        names = {"*"};
        return true;
    }
    bool begin_member(const std::string&) override { return true; }
    void end_member() override {}
    void end_group() override { close(); }
    bool begin_list(const Key& key, std::size_t& count) override
    {
        const bool is_root = stack_.size() == 1;
        row(key, "a list of tables, see below", "");
        const std::string path = (is_root ? "" : current().path + ".") + std::string(key.name);
        open(is_root ? fmt::format("[[{}]]", key.name) : fmt::format("{} (each item)", path), path, is_root ? 2 : 3);
        count = 1;
        return true;
    }
    bool begin_item(std::size_t) override { return true; }
    void end_item() override
    {
        if (in_alternative_ && current().level == 4) {
            close();
            in_alternative_ = false;
        }
    }
    void end_list() override { close(); }

private:
    struct Row {
        std::string key;
        std::string text;
    };
    struct Section {
        std::string title;
        std::string path;
        int level = 2;
        std::string about;
        std::vector<Row> rows;
        std::string alternatives;
    };

    static std::string text_of(const Section& section)
    {
        std::string text = fmt::format("\n{} {}\n", std::string(static_cast<std::size_t>(section.level), '#'),
                                       section.level == 1 ? section.title : "`" + section.title + "`");
        if (!section.about.empty()) {
            text += "\n" + section.about + "\n";
        }
        if (!section.rows.empty()) {
            text += "\n| key | value | default | meaning |\n|---|---|---|---|\n";
            for (const auto& row : section.rows) {
                text += row.text;
            }
        }
        return text;
    }

    /// Escapes bars, which would end the cell of the table.
    static std::string escaped(std::string_view text)
    {
        std::string result;
        for (const char c : text) {
            result += c == '|' ? std::string("\\|") : std::string(1, c);
        }
        return result;
    }

    static std::string shown(const std::string& text) { return text.empty() ? "" : fmt::format("`\"{}\"`", text); }

    static std::string choices(std::span<const std::string_view> options)
    {
        std::string text;
        for (const auto option : options) {
            text += fmt::format("{}`\"{}\"`", text.empty() ? "" : " or ", option);
        }
        return text;
    }

    Section& current() { return sections_[stack_.back()]; }

    void open(std::string title, std::string path, int level)
    {
        stack_.push_back(sections_.size());
        Section section;
        section.title = std::move(title);
        section.path = std::move(path);
        section.level = level;
        sections_.push_back(std::move(section));
    }
    void close() { stack_.pop_back(); }

    void row(const Key& key, const std::string& value, const std::string& standard)
    {
        const std::string_view shown = key.need == Need::required ? "required"
                                       : key.need == Need::of_law ? std::string_view()
                                                                  : std::string_view(standard);
        current().rows.push_back({std::string(key.name), fmt::format("| `{}` | {} | {} | {} |\n", key.name, value,
                                                                     shown, escaped(key.meaning))});
    }

    std::vector<Section> sections_;
    std::vector<std::size_t> stack_;
    bool in_alternative_ = false;
};

std::string library_text()
{
    const auto& library = shipped_library();
    std::string text = "\n## Shipped library\n\nNames for the key `library` of materials and lubricants.\n";
    text += "\n| material | density kg/m^3 | conductivity W/m/K | specific heat J/kg/K | expansion 1/K | modulus GPa | "
            "ratio | source |\n|---|---|---|---|---|---|---|---|\n";
    for (const auto& [name, m] : library.materials) {
        text +=
            fmt::format("| `{}` | {:g} | {:g} | {:g} | {:g} | {:g} | {:g} | {} |\n", name, m.density, m.conductivity,
                        m.specific_heat, m.expansion, m.youngs_modulus * 1e-9, m.poissons_ratio, m.source);
    }
    text += "\n| lubricant | source |\n|---|---|\n";
    for (const auto& [name, l] : library.lubricants) {
        text += fmt::format("| `{}` | {} |\n", name, l.source);
    }
    return text;
}

constexpr std::string_view preface = R"(
## Rules

- `include = ["parts.toml", ...]` at the top merges other files of the same folder tree; their paths are relative to the
  file that names them. A key stated twice is an error.
- `replace = ["oil.pins=300 W/m^2/K", ...]` at the top of any of these files replaces what the files state; each text is
  written as for `--set`. `deadpoint calibrate` writes such a file. `--set` comes last.
- A quantity is text with a unit: `"300 kN"`, `"1.05e-5 1/K"`. Units are those of UDUNITS-2, with products as a space or
  `*` and quotients as `/`. Angles have the unit `deg` or `rad`, angular velocities `rpm`, `rad/s` or `deg/s`,
  temperatures `degC`, `degF` or `K`, temperature differences `K` only.
- Numbers have a decimal point and no mark between thousands: `"0.5 mm"`, `"1000 mm"`.
- Names of tables hold letters, digits, `_`, `-` and `+`, and do not begin with `-` or `+`. Where parts are listed, `*`
  stands for any letters.
- Every text is one line of printable characters. Names have at most 100 characters, other texts 10 000. Within three quotes, a
  `\` at the end of a line joins it with the next line.
- A `temperature_formula` has one result, in kelvin and above 0 K, and assigns nothing. Below 150 K the program warns.
- On the command line, `--set path=value` replaces a value or adds one: `--set "operation.0.speed=400 rpm"`. Items of
  lists are counted from 0. The item after the last one is added with all of its keys:
  `--set 'operation.1={duration="1 h", speed="300 rpm", force="0 N"}'`.
)";

}  // namespace

std::string reference_page()
{
    return ReferenceWriter().run<Case>("case file") + std::string(preface) + library_text();
}

std::string reference_file_page() { return ReferenceWriter().run<ReferenceFile>("reference file"); }

std::string study_file_page() { return ReferenceWriter().run<StudyFile>("study file"); }

std::string calibration_file_page() { return ReferenceWriter().run<CalibrationFile>("calibration file"); }

}  // namespace deadpoint::casefile
