#pragma once

#include <initializer_list>
#include <string>
#include <vector>

namespace deadpoint::report::schema {

/// A value of a JSON file.
struct Key {
    std::string path;  ///< keys from the outside, divided by '/'; "[]" stands for every entry of a list
    std::string unit;  ///< empty: none
    std::string meaning;
};
using Keys = std::vector<Key>;

/// The keys of an object at a path.
Keys below(const std::string& at, const Keys& keys);
Keys joined(std::initializer_list<Keys> groups);

}  // namespace deadpoint::report::schema
