#pragma once

#include <string>
#include <string_view>

namespace deadpoint {

/// 64-bit FNV-1a hash of the bytes, as 16 hexadecimal digits; the same on every machine. Not for secrets.
std::string stable_hash(std::string_view text);

}  // namespace deadpoint
