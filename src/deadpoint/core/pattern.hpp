#pragma once

#include <string_view>

namespace deadpoint {

/// True if `name` is what `pattern` says; `*` stands for any characters, also none.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace deadpoint
