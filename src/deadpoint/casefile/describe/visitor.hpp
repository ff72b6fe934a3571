#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/quantity.hpp"

#include <functional>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace deadpoint::casefile {

enum class Need {
    optional,
    required,
    of_law  ///< required if the law of the key is chosen
};
inline constexpr Need required = Need::required;
inline constexpr Need of_law = Need::of_law;

/// One key of a table in the case file.
struct Key {
    std::string_view name;
    std::string_view meaning;  ///< one phrase for the reference page, without a full stop
    Need need = Need::optional;
};

/// Values allowed for a number, in SI units.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool open = false;  ///< the limits themselves are excluded
};
inline constexpr Range any_value{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range non_negative{0, std::numeric_limits<double>::infinity(), false};
inline constexpr Range fraction{0, 1, false};

/// A curve written as a table of two lists, { time = [...], value = [...] }.
struct CurveKeys {
    std::string_view x_name;
    Dimension x = Dimension::time;
    Dimension y = Dimension::none;
    Range range = any_value;
    bool may_jump = false;  ///< two points may have the same place
};

class Visitor;

/// One of the laws that a key of a table chooses; the keys of the law are in the same table.
struct Law {
    std::string_view name;  ///< value of the key
    /// Describes the case's law, which becomes this one.
    std::function<void(Visitor&)> describe;
    /// Describes an empty law, the same object to all visitors in turn.
    std::function<void(std::initializer_list<Visitor*>)> describe_fresh;
};

/// One description per struct: names every key with its unit, range and meaning, and the rules between keys.
/// Reading, checking, writing and the reference page are visitors of these functions (describe.cpp).
void describe(Visitor& v, Case& c);
void describe(Visitor& v, MachineSection& m);
void describe(Visitor& v, Material& m);
void describe(Visitor& v, Lubricant& l);
void describe(Visitor& v, Body& b);
void describe(Visitor& v, Part& p);
void describe(Visitor& v, Shape& s);
void describe(Visitor& v, ShaftSection& s);
void describe(Visitor& v, Friction& f);
void describe(Visitor& v, CalibratedFriction& f);
void describe(Visitor& v, PalmgrenFriction& f);
void describe(Visitor& v, SkfFriction& f);
void describe(Visitor& v, PinFriction& f);
void describe(Visitor& v, GuideFriction& f);
void describe(Visitor& v, Joint& j);
void describe(Visitor& v, JointElement& e);
void describe(Visitor& v, Interface& i);
void describe(Visitor& v, BallSeat& s);
void describe(Visitor& v, Bond& b);
void describe(Visitor& v, Conductance& c);
void describe(Visitor& v, FractalContact& c);
void describe(Visitor& v, RoughContact& c);
void describe(Visitor& v, OilFilm& f);
void describe(Visitor& v, RollingElements& e);
void describe(Visitor& v, Surface& s);
void describe(Visitor& v, BoxShape& b);  ///< of the key `within`
void describe(Visitor& v, Film& f);
void describe(Visitor& v, SpeedGrowth& g);
void describe(Visitor& v, PlateFilm& f);
void describe(Visitor& v, RoundFilm& f);
void describe(Visitor& v, MovingFilm& f);
void describe(Visitor& v, EnclosedFilm& f);
void describe(Visitor& v, PaperFilm& f);
void describe(Visitor& v, HeatInput& h);
void describe(Visitor& v, OilCircuit& c);
void describe(Visitor& v, Enclosure& e);
void describe(Visitor& v, Mechanism& m);
void describe(Visitor& v, Crankshaft& c);
void describe(Visitor& v, Crankshaft::Section& s);
void describe(Visitor& v, Crankshaft::Disk& d);
void describe(Visitor& v, Crankshaft::Bearing& b);
void describe(Visitor& v, Crankshaft::Belt& b);
void describe(Visitor& v, ProcessForce& p);
void describe(Visitor& v, Segment& s);
void describe(Visitor& v, Probe& p);
void describe(Visitor& v, Chain& c);
void describe(Visitor& v, Foundation& f);
void describe(Visitor& v, Preload& p);
void describe(Visitor& v, Numerics& n);
void describe(Visitor& v, Output& o);
void describe(Visitor& v, Reduce& r);
void describe(Visitor& v, Reference& r);

/// Walks through a struct of the case, key by key. Values are changed by the reader only.
class Visitor {
public:
    virtual ~Visitor() = default;

    /// Purpose of the table that is being described.
    virtual void about(std::string_view sentences) { (void)sentences; }
    /// One of several forms of the table follows (after tagged()).
    virtual void alternative(std::string_view name) { (void)name; }
    /// A rule between keys of the table: if it fails, `key` is wrong.
    virtual void expect(bool holds, std::string_view key, std::string_view message, std::string_view help)
    {
        (void)holds, (void)key, (void)message, (void)help;
    }
    /// Fills `m` from the shipped library under the name it states.
    virtual void from_library(Material& m) { (void)m; }
    virtual void from_library(Lubricant& l) { (void)l; }

    virtual void number(const Key& key, double& value, const Range& range) = 0;
    virtual void integer(const Key& key, int& value, const Range& range) = 0;
    virtual void flag(const Key& key, bool& value) = 0;
    virtual void text(const Key& key, std::string& value) = 0;
    virtual void path(const Key& key, std::string& value) = 0;
    virtual void choice(const Key& key, std::string& value, std::span<const std::string_view> options) = 0;
    virtual void quantity(const Key& key, double& value, Dimension dimension, const Range& range) = 0;
    virtual void quantity(const Key& key, std::optional<double>& value, Dimension dimension, const Range& range) = 0;
    /// A list of known length; Dimension::none takes bare numbers.
    virtual void vector(const Key& key, std::span<double> value, Dimension dimension) = 0;
    virtual void vector(const Key& key, std::optional<Vec2>& value, Dimension dimension) = 0;
    /// One quantity for both directions, or [[xx, xy], [yx, yy]].
    virtual void matrix(const Key& key, Matrix2& value, Dimension dimension) = 0;
    virtual void matrix(const Key& key, std::optional<Matrix2>& value, Dimension dimension) = 0;
    /// [from, to] with from < to.
    virtual void extent(const Key& key, double& from, double& to) = 0;
    virtual void quantities(const Key& key, std::vector<double>& value, Dimension dimension, const Range& range) = 0;
    virtual void quantities(const Key& key, std::map<std::string, double>& value, Dimension dimension) = 0;
    virtual void texts(const Key& key, std::vector<std::string>& value) = 0;
    virtual void points(const Key& key, std::vector<Vec2>& value) = 0;
    virtual void loops(const Key& key, std::vector<std::vector<Vec2>>& value) = 0;
    virtual void curve(const Key& key, Table& value, const CurveKeys& keys) = 0;
    /// A constant quantity, or a table over temperature, whose first value then is the constant.
    virtual void property(const Key& key, double& constant, Table& table, Dimension dimension, const Range& range) = 0;
    /// A value for any key of a case, as for --set. Study files only.
    virtual void setting(const Key& key, std::string& value) { (void)key, (void)value; }
    /// A list of them; an item may be a list of its own.
    virtual void settings(const Key& key, std::vector<std::vector<std::string>>& value) { (void)key, (void)value; }
    /// A constant quantity, or a curve over time.
    virtual void course(const Key& key, std::optional<Course>& value, Dimension dimension, const Range& range) = 0;

    /// A pair like add = "cylinder", whose key and value are both chosen from a list.
    /// @param key    index of the key, in and out
    /// @param value  index of the value
    /// @return the values to describe: the one read or written, or all for the reference page
    virtual std::vector<std::size_t> tagged(std::span<const std::string_view> keys, std::size_t& key,
                                            std::span<const std::string_view> values, std::size_t value,
                                            std::string_view meaning) = 0;

    /// The keys of the law that the key `tag` chose, which was described before. @param chosen its
    /// name; empty if the case names none
    virtual void laws(std::string_view tag, std::string_view chosen, std::span<const Law> laws) = 0;

    /// A table below this one.
    template <class T>
    void table(const Key& key, T& value)
    {
        if (!begin_table(key, true)) {
            return;
        }
        renew(value);
        describe(*this, value);
        end_table();
    }
    template <class T>
    void table(const Key& key, std::optional<T>& value)
    {
        if (!begin_table(key, value.has_value())) {
            return;
        }
        if (!value) {
            value = T{};
        }
        renew(*value);
        describe(*this, *value);
        end_table();
    }
    /// Tables of one kind by name: [parts.link_3].
    template <class T>
    void named(const Key& key, std::map<std::string, T>& values, std::string_view placeholder)
    {
        std::vector<std::string> names;
        for (const auto& [name, value] : values) {
            names.push_back(name);
        }
        if (!begin_group(key, names, placeholder)) {
            return;
        }
        for (const auto& name : names) {
            if (!begin_member(name)) {
                continue;
            }
            renew(values[name]);
            describe(*this, values[name]);
            end_member();
        }
        end_group();
    }
    /// A list of tables.
    template <class T>
    void list(const Key& key, std::vector<T>& values)
    {
        std::size_t count = values.size();
        if (!begin_list(key, count)) {
            return;
        }
        values.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            if (!begin_item(i)) {
                continue;
            }
            renew(values[i]);
            describe(*this, values[i]);
            end_item();
        }
        end_list();
    }

protected:
    /// Whether a table takes the place of the value that was there before.
    [[nodiscard]] virtual bool replaces() const { return false; }
    /// @return whether to describe the table; if so, end_table follows
    virtual bool begin_table(const Key& key, bool present) = 0;
    virtual void end_table() = 0;
    virtual bool begin_group(const Key& key, std::vector<std::string>& names, std::string_view placeholder) = 0;
    virtual bool begin_member(const std::string& name) = 0;
    virtual void end_member() = 0;
    virtual void end_group() = 0;
    virtual bool begin_list(const Key& key, std::size_t& count) = 0;
    virtual bool begin_item(std::size_t index) = 0;
    virtual void end_item() = 0;
    virtual void end_list() = 0;

private:
    template <class T>
    void renew(T& value)
    {
        if (replaces()) {
            value = T{};
        }
    }
};

}  // namespace deadpoint::casefile
