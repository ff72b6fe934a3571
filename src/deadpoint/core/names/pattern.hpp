#pragma once

#include <string_view>

namespace deadpoint {

/// True if `name` matches `pattern`; `*` stands for any characters, also none.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace deadpoint
