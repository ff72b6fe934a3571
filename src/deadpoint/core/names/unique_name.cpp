#include "deadpoint/core/names/unique_name.hpp"

#include <algorithm>
#include <random>

namespace deadpoint {
namespace {

constexpr std::string_view letters = "0123456789abcdefghijklmnopqrstuvwxyz";
constexpr std::size_t ending = 8;

}  // namespace

std::string unique_name(std::string prefix)
{
    std::random_device random;
    std::uniform_int_distribution<std::size_t> which(0, letters.size() - 1);
    for (std::size_t i = 0; i < ending; ++i) {
        prefix += letters[which(random)];
    }
    return prefix;
}

bool is_unique_name(std::string_view name, std::string_view prefix)
{
    return name.size() == prefix.size() + ending && name.starts_with(prefix) &&
           std::ranges::all_of(name.substr(prefix.size()),
                               [](char c) { return letters.find(c) != std::string_view::npos; });
}

}  // namespace deadpoint
