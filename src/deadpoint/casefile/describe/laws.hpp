#pragma once

#include "deadpoint/casefile/describe/visitor.hpp"

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

/// Internal to casefile/: laws that are chosen by a key and have further keys of their own.
namespace deadpoint::casefile {

/// The laws of one kind: the name that chooses each, and its struct with nothing stated yet.
template <class Variant>
using LawTable = std::vector<std::pair<std::string_view, Variant>>;

/// True if two values are the same law with any parameters. Structs that serve several laws define
/// this themselves.
template <class Variant>
bool is_same_law(const Variant& one, const Variant& other)
{
    return one.index() == other.index() && std::visit(
                                               [&]<class T>(const T& value) {
                                                   if constexpr (requires { value.is_same_law(value); }) {
                                                       return value.is_same_law(std::get<T>(other));
                                                   }
                                                   return true;
                                               },
                                               one);
}

/// @return empty for an alternative that no name chooses
template <class Variant>
std::string_view name_in(const LawTable<Variant>& table, const Variant& value)
{
    const auto found = std::ranges::find_if(table, [&](const auto& row) { return is_same_law(row.second, value); });
    return found == table.end() ? std::string_view() : found->first;
}

template <class Variant>
std::vector<std::string_view> names_in(const LawTable<Variant>& table)
{
    std::vector<std::string_view> names;
    for (const auto& [name, fresh] : table) {
        names.push_back(name);
    }
    return names;
}

/// Describes the struct of the law that `value` is.
template <class Variant>
void describe_law(Visitor& v, Variant& value)
{
    std::visit(
        [&]<class T>(T& law) {
            if constexpr (requires { describe(v, law); }) {
                describe(v, law);
            }
        },
        value);
}

/// Data of each law for a visitor; `value` must outlive it.
template <class Variant>
std::vector<Law> laws_of(const LawTable<Variant>& table, Variant& value)
{
    std::vector<Law> laws;
    for (const auto& [name, fresh] : table) {
        laws.push_back({name,
                        [&value, fresh = fresh](Visitor& v) {
                            if (!is_same_law(value, fresh)) {
                                value = fresh;
                            }
                            describe_law(v, value);
                        },
                        [fresh = fresh](std::initializer_list<Visitor*> visitors) {
                            auto copy = fresh;
                            for (auto* visitor : visitors) {
                                describe_law(*visitor, copy);
                            }
                        }});
    }
    return laws;
}

}  // namespace deadpoint::casefile
