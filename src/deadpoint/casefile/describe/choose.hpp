#pragma once

#include "deadpoint/casefile/describe/visitor.hpp"

#include <initializer_list>
#include <string>
#include <string_view>

/// Internal to casefile/: for describe().
namespace deadpoint::casefile {

/// A text out of a list.
inline void choose(Visitor& v, const Key& key, std::string& value, std::initializer_list<std::string_view> options)
{
    v.choice(key, value, std::span(options.begin(), options.size()));
}

}  // namespace deadpoint::casefile
