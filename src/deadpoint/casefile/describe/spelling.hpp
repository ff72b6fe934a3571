#pragma once

#include <cstddef>
#include <string_view>

/// Names of the values of an enumeration in a case file.
namespace deadpoint::casefile {

/// Names of the values of E in their order: a std::array of texts, stated beside each enumeration.
template <class E>
inline constexpr auto spelling = nullptr;

template <class E>
constexpr std::string_view name_of(E value)
{
    return spelling<E>.at(static_cast<std::size_t>(value));
}

}  // namespace deadpoint::casefile
