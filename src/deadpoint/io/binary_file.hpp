#pragma once

#include "deadpoint/core/hash.hpp"

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

/// Values as bytes in a binary file of deadpoint, for this kind of machine: a number as in memory,
/// a text or list after its count, an array as its values, an optional value after whether there is one, a variant
/// after the index of its alternative, a struct as its members. A struct lists its members once for writing and
/// reading:
///
///     constexpr auto members(const Series*) { return std::tuple{&Series::value, &Series::rate}; }
///
/// An enumeration states its last value, for reading:
///
///     constexpr Kind last_value(const Kind*) { return Kind::ambient; }
///
/// The file begins with its kind and ends with its length and a checksum of all before, so that a
/// truncated or changed file is detected before any of its contents is used. A right checksum proves nothing of the
/// contents: the reader refuses numbers that are not finite, bools other than 0 and 1, and values that an enumeration
/// does not have.
namespace deadpoint {

template <class Value>
inline constexpr bool is_number = std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>;

class BinaryWriter {
public:
    /// @param out the stream; its owner checks for failures
    BinaryWriter(std::ostream& out, std::string_view kind);
    /// Numbers, enumerations, bools, texts, lists, arrays, optional values, variants, and structs with members().
    template <class... Values>
    void operator()(const Values&... values)
    {
        (put(values), ...);
    }
    /// Ends the file.
    void finish();

private:
    void put_bytes(const void* data, std::size_t size);

    template <class Value>
    void put(const Value& value)
    {
        if constexpr (is_number<Value>)
            put_bytes(&value, sizeof(Value));
        else if constexpr (std::is_same_v<Value, bool>)
            put(static_cast<std::uint8_t>(value));
        else if constexpr (std::is_enum_v<Value>)
            put(static_cast<std::underlying_type_t<Value>>(value));
        else
            std::apply([&](auto... member) { (put(value.*member), ...); }, members(&value));
    }
    template <class Value, std::size_t size>
    void put(const std::array<Value, size>& values)
    {
        for (const Value& value : values)
            put(value);
    }
    template <class Value>
    void put(const std::optional<Value>& value)
    {
        put(value.has_value());
        if (value)
            put(*value);
    }
    template <class... Values>
    void put(const std::variant<Values...>& value)
    {
        put(static_cast<std::uint8_t>(value.index()));
        std::visit([&](const auto& held) { put(held); }, value);
    }
    void put(const std::string& text) { put_numbers(text.data(), text.size()); }
    template <class Value>
    void put(const std::vector<Value>& values)
    {
        if constexpr (is_number<Value>)
            put_numbers(values.data(), values.size());
        else {
            put(std::uint64_t{values.size()});
            for (const Value& value : values)
                put(value);
        }
    }
    template <class Value>
    void put_numbers(const Value* values, std::size_t count)
    {
        put(std::uint64_t{count});
        put_bytes(values, count * sizeof(Value));
    }

    std::ostream& out_;
    StableHash checksum_;
    std::uint64_t length_ = 0;
};

class BinaryReader {
public:
    /// Opens a file and checks all of it.
    /// @param help remedy if the file cannot be used, for the messages
    /// @throws IoError if it cannot be read, is of another kind, was cut short or changed
    BinaryReader(std::filesystem::path file, std::string_view kind, std::string help);
    /// Reads values in the order in which they were written.
    /// @throws IoError with the place in the file if it is at its end, a count exceeds the rest of the file, a number
    /// is
    ///         not finite, or a bool or an enumeration has no such value
    template <class... Values>
    void operator()(Values&... values)
    {
        (get(values), ...);
    }
    /// @throws IoError that names the file and says that it is broken
    [[noreturn]] void refuse(const std::string& reason) const;

private:
    void get_bytes(void* data, std::size_t size);
    [[nodiscard]] std::size_t get_count(std::size_t size_of_one);
    /// Refuses the value of which the last byte was read.
    [[noreturn]] void refuse_value(std::size_t bytes_ago, const char* reason) const;

    template <class Number>
    void get_numbers(Number* values, std::size_t count)
    {
        get_bytes(values, count * sizeof(Number));
        if constexpr (std::is_floating_point_v<Number>)
            for (std::size_t k = 0; k < count; ++k)
                if (!std::isfinite(values[k]))
                    refuse_value((count - k) * sizeof(Number), "is not a finite number");
    }
    template <class Value>
    void get(Value& value)
    {
        if constexpr (is_number<Value>)
            get_numbers(&value, 1);
        else if constexpr (std::is_same_v<Value, bool>) {
            std::uint8_t byte = 0;
            get(byte);
            if (byte > 1)
                refuse_value(sizeof byte, "is neither 0 nor 1");
            value = byte != 0;
        } else if constexpr (std::is_enum_v<Value>) {
            std::underlying_type_t<Value> number{};
            get(number);
            if (std::cmp_less(number, 0) || number > static_cast<decltype(number)>(last_value(&value)))
                refuse_value(sizeof number, "names a kind that does not exist");
            value = static_cast<Value>(number);
        } else
            std::apply([&](auto... member) { (get(value.*member), ...); }, members(&value));
    }
    template <class Value, std::size_t size>
    void get(std::array<Value, size>& values)
    {
        for (Value& value : values)
            get(value);
    }
    template <class Value>
    void get(std::optional<Value>& value)
    {
        bool there = false;
        get(there);
        value.reset();
        if (there)
            get(value.emplace());
    }
    template <class... Values>
    void get(std::variant<Values...>& value)
    {
        std::uint8_t index = 0;
        get(index);
        if (index >= sizeof...(Values))
            refuse("it names a form that does not exist");
        [&]<std::size_t... i>(std::index_sequence<i...>)
        {
            (void)((i == index && (get(value.template emplace<i>()), true)) || ...);
        }
        (std::index_sequence_for<Values...>());
    }
    void get(std::string& text)
    {
        text.resize(get_count(1));
        get_bytes(text.data(), text.size());
    }
    template <class Value>
    void get(std::vector<Value>& values)
    {
        if constexpr (is_number<Value>) {
            values.resize(get_count(sizeof(Value)));
            get_numbers(values.data(), values.size());
        } else {
            values.clear();
            for (std::size_t left = get_count(1); left > 0; --left) {
                Value value{};
                get(value);
                values.push_back(std::move(value));
            }
        }
    }

    std::filesystem::path file_;
    std::string help_;
    std::ifstream in_;
    std::uint64_t end_ = 0;   ///< of the contents [byte]
    std::uint64_t left_ = 0;  ///< of the contents, not read yet [byte]
};

}  // namespace deadpoint
