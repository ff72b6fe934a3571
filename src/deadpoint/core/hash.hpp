#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace deadpoint {

/// 64-bit FNV-1a hash of bytes that come in pieces. It changes with any single byte.
class StableHash {
public:
    void add(std::string_view bytes);
    [[nodiscard]] std::uint64_t value() const { return hash_; }
    /// The value as 16 hexadecimal digits.
    [[nodiscard]] std::string text() const;

private:
    std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

/// The same of one text, as 16 hexadecimal digits; the same on every machine. Not for secrets.
std::string stable_hash(std::string_view text);

}  // namespace deadpoint
