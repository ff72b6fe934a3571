#pragma once

#include "deadpoint/casefile/describe/spelling.hpp"
#include "deadpoint/casefile/describe/visitor.hpp"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

/// Internal to casefile/: for describe().
namespace deadpoint::casefile {

/// A text out of a list.
inline void choose(Visitor& v, const Key& key, std::string& value, std::initializer_list<std::string_view> options)
{
    v.choice(key, value, std::span(options.begin(), options.size()));
}

/// A value of an enumeration, or none.
template <class E>
void choose(Visitor& v, const Key& key, std::optional<E>& value)
{
    std::string name(value ? name_of(*value) : std::string_view());
    v.choice(key, name, spelling<E>);
    const auto found = std::ranges::find(spelling<E>, name);
    if (found != spelling<E>.end()) {
        value = static_cast<E>(found - spelling<E>.begin());
    }
}

/// A value of an enumeration.
template <class E>
requires std::is_enum_v<E>
void choose(Visitor& v, const Key& key, E& value)
{
    std::optional<E> chosen = value;
    choose(v, key, chosen);
    value = *chosen;
}

}  // namespace deadpoint::casefile
