#include "deadpoint/casefile/syntax/reader.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace deadpoint::casefile {

// ---------------------------------------------------------------- lists

void Reader::read_vector(const Node& node, const std::string& path, Dimension dimension, std::span<double> value)
{
    const std::string item = dimension == Dimension::none ? "0"
                             : dimension == Dimension::length
                                 ? "\"0 mm\""
                                 : fmt::format("\"{}\"", dimension_info(dimension).example);
    const std::string example = value.size() == 2 ? fmt::format("write it like [{0}, {0}]", item)
                                                  : fmt::format("write it like [{0}, {0}, {0}]", item);
    if (!is_a(node, Node::Kind::array, path, example)) {
        return;
    }
    if (node.children.size() != value.size()) {
        report(node, "wrong-length", path,
               fmt::format("a list of {}, but {} values are needed", node.children.size(), value.size()), example);
        return;
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        read_quantity(node.children[i], fmt::format("{}.{}", path, i), dimension, any_value, value[i]);
    }
}

void Reader::vector(const Key& key, std::span<double> value, Dimension dimension)
{
    if (const Node* node = take(key)) {
        read_vector(*node, path_of(key.name), dimension, value);
    }
}

void Reader::vector(const Key& key, std::optional<Vec2>& value, Dimension dimension)
{
    const Node* node = take(key);
    if (node == nullptr) {
        return;
    }
    value = Vec2{};
    read_vector(*node, path_of(key.name), dimension, *value);
}

void Reader::read_matrix(const Node& node, const std::string& path, Dimension dimension, Matrix2& value)
{
    if (node.kind != Node::Kind::array) {
        double both = 0;
        read_quantity(node, path, dimension, any_value, both);
        value = {{{both, 0}, {0, both}}};
        return;
    }
    if (node.children.size() != 2) {
        const auto example = dimension_info(dimension).example;
        report(node, "wrong-length", path, fmt::format("a list of {}, but a matrix has 2 rows", node.children.size()),
               fmt::format("write it like [[\"{0}\", \"{0}\"], [\"{0}\", \"{0}\"]]", example));
        return;
    }
    for (std::size_t i = 0; i < 2; ++i) {
        read_vector(node.children[i], fmt::format("{}.{}", path, i), dimension, value.at(i));
    }
}

void Reader::matrix(const Key& key, Matrix2& value, Dimension dimension)
{
    if (const Node* node = take(key)) {
        read_matrix(*node, path_of(key.name), dimension, value);
    }
}

void Reader::matrix(const Key& key, std::optional<Matrix2>& value, Dimension dimension)
{
    if (const Node* node = take(key)) {
        value = Matrix2{};
        read_matrix(*node, path_of(key.name), dimension, *value);
    }
}

void Reader::extent(const Key& key, double& from, double& to)
{
    const Node* node = take(key);
    if (node == nullptr) {
        return;
    }
    const auto before = diagnostics_.size();
    std::array<double, 2> value{};
    read_vector(*node, path_of(key.name), Dimension::length, value);
    if (diagnostics_.size() == before && !(value[0] < value[1])) {
        report(*node, "wrong-order", path_of(key.name), "the second value is not larger than the first",
               "write [from, to] with from < to");
    }
    from = value[0];
    to = value[1];
}

bool Reader::read_list(const Node& node, const std::string& path, Dimension dimension, const Range& range,
                       std::vector<double>& values)
{
    if (!is_a(node, Node::Kind::array, path, "")) {
        return false;
    }
    bool good = true;
    values.clear();
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        double value = 0;
        good = read_quantity(node.children[i], fmt::format("{}.{}", path, i), dimension, range, value) && good;
        values.push_back(value);
    }
    return good;
}

void Reader::quantities(const Key& key, std::vector<double>& value, Dimension dimension, const Range& range)
{
    if (const Node* node = take(key)) {
        read_list(*node, path_of(key.name), dimension, range, value);
    }
}

void Reader::quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension)
{
    const Node* node = take(key, Node::Kind::table, "");
    if (node == nullptr) {
        return;
    }
    for (const auto& child : node->children) {
        read_quantity(child, fmt::format("{}.{}", path_of(key.name), child.key), dimension, any_value,
                      value[child.key]);
    }
}

void Reader::texts(const Key& key, std::vector<std::string>& value)
{
    const Node* node = take(key, Node::Kind::array, "write it like [\"one\", \"two\"]");
    if (node == nullptr) {
        return;
    }
    value.clear();
    for (std::size_t i = 0; i < node->children.size(); ++i) {
        const auto& child = node->children[i];
        if (is_a(child, Node::Kind::string, fmt::format("{}.{}", path_of(key.name), i), "")) {
            value.push_back(child.text);
        }
    }
}

void Reader::read_points(const Node& node, const std::string& path, std::vector<Vec2>& value)
{
    if (!is_a(node, Node::Kind::array, path, "write it like [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"0 mm\"], ...]")) {
        return;
    }
    value.assign(node.children.size(), Vec2{});
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        read_vector(node.children[i], fmt::format("{}.{}", path, i), Dimension::length, value[i]);
    }
}

bool Reader::read_setting(const Node& node, const std::string& path, std::string& value)
{
    switch (node.kind) {
    case Node::Kind::string:
        value = node.text;
        break;
    case Node::Kind::integer:
        value = std::to_string(node.integer);
        break;
    case Node::Kind::real:
        value = format_number(node.number);
        break;
    case Node::Kind::boolean:
        value = node.flag ? "true" : "false";
        break;
    default:
        return is_a(node, Node::Kind::string, path, "write a value as for --set, like \"300 rpm\"");
    }
    if (value.empty()) {
        report(node, "empty", path, "the text is empty", "write a value as for --set, like \"300 rpm\"");
    }
    return !value.empty();
}

void Reader::setting(const Key& key, std::string& value)
{
    if (const Node* node = take(key)) {
        read_setting(*node, path_of(key.name), value);
    }
}

void Reader::settings(const Key& key, std::vector<std::vector<std::string>>& value)
{
    const Node* node = take(key, Node::Kind::array, "write it like [\"200 rpm\", \"300 rpm\"]");
    for (std::size_t i = 0; node != nullptr && i < node->children.size(); ++i) {
        const Node& item = node->children[i];
        const std::string path = fmt::format("{}.{}", path_of(key.name), i);
        auto& texts = value.emplace_back();
        if (item.kind != Node::Kind::array) {
            read_setting(item, path, texts.emplace_back());
            continue;
        }
        for (std::size_t k = 0; k < item.children.size(); ++k) {
            read_setting(item.children[k], fmt::format("{}.{}", path, k), texts.emplace_back());
        }
    }
}

void Reader::points(const Key& key, std::vector<Vec2>& value)
{
    if (const Node* node = take(key)) {
        read_points(*node, path_of(key.name), value);
    }
}

void Reader::loops(const Key& key, std::vector<std::vector<Vec2>>& value)
{
    const Node* node = take(key, Node::Kind::array, "");
    if (node == nullptr) {
        return;
    }
    value.resize(node->children.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
        read_points(node->children[i], fmt::format("{}.{}", path_of(key.name), i), value[i]);
    }
}

// ---------------------------------------------------------------- curves

namespace {

// Index of the first point where x does not increase. @param may_jump  two points, but not three, may have the same x
std::optional<std::size_t> first_in_wrong_order(const std::vector<double>& x, bool may_jump)
{
    for (std::size_t i = 1; i < x.size(); ++i)
        if (!(x[i - 1] < x[i]) && !(may_jump && x[i - 1] == x[i] && (i < 2 || x[i - 2] < x[i])))
            return i;
    return std::nullopt;
}

}  // namespace

void Reader::read_curve(const Node& node, const std::string& path, const CurveKeys& keys, Table& value)
{
    push(node, path);
    const auto before = diagnostics_.size();
    const std::string x_path = fmt::format("{}.{}", path, keys.x_name);
    const Node* x = take({keys.x_name, "the places of the points", Need::required});
    const Node* y = take({"value", "the value at each of them", Need::required});
    if (x != nullptr) {
        read_list(*x, x_path, keys.x, any_value, value.x);
    }
    if (y != nullptr) {
        read_list(*y, path + ".value", keys.y, keys.range, value.y);
    }
    if (x != nullptr && y != nullptr && diagnostics_.size() == before) {
        if (value.x.empty()) {
            report(*x, "wrong-length", x_path, "the curve has no points", "give one point or more");
        } else if (value.x.size() != value.y.size()) {
            report(*y, "wrong-length", path + ".value",
                   fmt::format("{} values for {} points", value.y.size(), value.x.size()), "give one value per point");
        }
        if (const auto index = first_in_wrong_order(value.x, keys.may_jump)) {
            report(x->children[*index], "wrong-order", x_path, "the points do not increase",
                   keys.may_jump ? "sort them, each once, or twice where the value jumps"
                                 : "sort them, each only once");
        }
    }
    pop();
}

void Reader::curve(const Key& key, Table& value, const CurveKeys& keys)
{
    const std::string help = fmt::format("write it like {{ {} = [\"{}\", ...], value = [\"{}\", ...] }}", keys.x_name,
                                         dimension_info(keys.x).example, dimension_info(keys.y).example);
    if (const Node* node = take(key, Node::Kind::table, help)) {
        read_curve(*node, path_of(key.name), keys, value);
    }
}

void Reader::property(const Key& key, double& constant, Table& table, Dimension dimension, const Range& range)
{
    const Node* node = take(key);
    if (node == nullptr) {
        return;
    }
    table = {};
    if (node->kind != Node::Kind::table) {
        read_quantity(*node, path_of(key.name), dimension, range, constant);
        return;
    }
    read_curve(*node, path_of(key.name), {"temperature", Dimension::temperature, dimension, range}, table);
    if (!table.y.empty()) {
        constant = table.y.front();
    }
}

void Reader::read_daily(const Node& node, const std::string& path, const Range& range, DailyCourse& value)
{
    push(node, path);
    const auto before = diagnostics_.size();
    quantity({"mean", "over the period", Need::required}, value.mean, Dimension::temperature, range);
    quantity({"amplitude", "half the difference of highest and lowest", Need::required}, value.amplitude,
             Dimension::temperature_difference, non_negative);
    quantity({"time_of_maximum", "on the clock of the run"}, value.time_of_maximum, Dimension::time, any_value);
    quantity({"period", "after which it repeats"}, value.period, Dimension::time, positive);
    if (diagnostics_.size() == before && !(value.mean - value.amplitude > 0)) {
        report(node, "out-of-range", path, "the course goes below absolute zero", "make the amplitude smaller");
    }
    pop();
}

void Reader::course(const Key& key, std::optional<Course>& value, Dimension dimension, const Range& range)
{
    const Node* node = take(key);
    if (node == nullptr) {
        return;
    }
    value.emplace();
    if (node->kind == Node::Kind::table && dimension == Dimension::temperature && node->find("mean") != nullptr) {
        read_daily(*node, path_of(key.name), range, value->daily.emplace());
        value->constant = value->daily->mean;
    } else if (node->kind == Node::Kind::table) {
        value->table.emplace();
        read_curve(*node, path_of(key.name), {"time", Dimension::time, dimension, range, true}, *value->table);
        if (!value->table->y.empty()) {
            value->constant = value->table->y.front();
        }
    } else {
        read_quantity(*node, path_of(key.name), dimension, range, value->constant);
    }
}

}  // namespace deadpoint::casefile
