#include "deadpoint/core/hash.hpp"

#include <cstdint>
#include <fmt/format.h>

namespace deadpoint {

std::string stable_hash(std::string_view text)
{
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char c : text) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3ULL;
    }
    return fmt::format("{:016x}", hash);
}

}  // namespace deadpoint
