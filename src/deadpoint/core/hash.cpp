#include "deadpoint/core/hash.hpp"

#include <fmt/format.h>

namespace deadpoint {

void StableHash::add(std::string_view bytes)
{
    for (const char c : bytes) {
        hash_ ^= static_cast<unsigned char>(c);
        hash_ *= 0x100000001b3ULL;
    }
}

std::string StableHash::text() const { return fmt::format("{:016x}", hash_); }

std::string stable_hash(std::string_view text)
{
    StableHash hash;
    hash.add(text);
    return hash.text();
}

}  // namespace deadpoint
