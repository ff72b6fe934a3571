#pragma once

#include "deadpoint/casefile/describe/visitor.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Values of a case as text of a case file.
namespace deadpoint::casefile {

std::string in_quotes(std::string_view text);

/// A name as a key of TOML, in quotes where it needs them.
std::string key_text(std::string_view key);

/// A quantity with its unit, in quotes, or a bare number.
std::string value_text(double value, Dimension dimension);

/// Visits the keys of a table one by one and passes each to put(). It does not visit nested tables.
class ValueTexts : public Visitor {
public:
    void number(const Key& key, double& value, const Range& range) override;
    void integer(const Key& key, int& value, const Range& range) override;
    void flag(const Key& key, bool& value) override;
    void text(const Key& key, std::string& value) override;
    void path(const Key& key, std::string& value) override;
    void choice(const Key& key, std::string& value, std::span<const std::string_view> options) override;
    void quantity(const Key& key, double& value, Dimension dimension, const Range& range) override;
    void quantity(const Key& key, std::optional<double>& value, Dimension dimension, const Range& range) override;
    void vector(const Key& key, std::span<double> value, Dimension dimension) override;
    void vector(const Key& key, std::optional<Vec2>& value, Dimension dimension) override;
    void matrix(const Key& key, Matrix2& value, Dimension dimension) override;
    void matrix(const Key& key, std::optional<Matrix2>& value, Dimension dimension) override;
    void extent(const Key& key, double& from, double& to) override;
    void quantities(const Key& key, std::vector<double>& value, Dimension dimension, const Range& range) override;
    void quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension) override;
    void texts(const Key& key, std::vector<std::string>& value) override;
    void points(const Key& key, std::vector<Vec2>& value) override;
    void loops(const Key& key, std::vector<std::vector<Vec2>>& value) override;
    void curve(const Key& key, Table& value, const CurveKeys& keys) override;
    void property(const Key& key, double& constant, Table& table, Dimension dimension, const Range& range) override;
    void course(const Key& key, std::optional<Course>& value, Dimension dimension, const Range& range) override;
    std::vector<std::size_t> tagged(std::span<const std::string_view> keys, std::size_t& key,
                                    std::span<const std::string_view> values, std::size_t value,
                                    std::string_view meaning) override;
    void laws(std::string_view tag, std::string_view chosen, std::span<const Law> laws) override;

protected:
    /// @param text none if a case need not state the key
    virtual void put(const Key& key, std::optional<std::string> text) = 0;

    bool begin_table(const Key& key, bool present) override;
    void end_table() override {}
    bool begin_group(const Key& key, std::vector<std::string>& names, std::string_view placeholder) override;
    bool begin_member(const std::string& name) override;
    void end_member() override {}
    void end_group() override {}
    bool begin_list(const Key& key, std::size_t& count) override;
    bool begin_item(std::size_t index) override;
    void end_item() override {}
    void end_list() override {}
};

/// A key of a law, and its value if it has one.
struct LawKey {
    std::string name;
    std::optional<std::string> text;
};

/// The keys of an empty law; those without a default have no text.
/// @param reader  fills the law before, may be null
std::vector<LawKey> fresh_keys(const Law& law, Visitor* reader = nullptr);

/// The keys of all laws, each once, in an order that keeps that of each law. The text is that of
/// the chosen law if it has one, else of an empty law.
/// @param chosen  name of a law, or empty
std::vector<LawKey> merged_keys(std::span<const Law> laws, std::string_view chosen);

/// Merges items into a list: existing items keep their positions, and a new item is inserted before
/// its next existing successor.
template <class Item>
void merge(std::vector<Item>& list, const std::vector<Item>& items, std::string Item::*name)
{
    std::size_t place = list.size();
    for (std::size_t i = items.size(); i-- > 0;) {
        std::size_t found = 0;
        while (found < list.size() && list[found].*name != items[i].*name) {
            ++found;
        }
        if (found < list.size()) {
            place = found;
        } else {
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(place), items[i]);
        }
    }
}

}  // namespace deadpoint::casefile
