#include "deadpoint/core/names/plain_text.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

namespace deadpoint {
namespace {

struct Character {
    std::string_view bytes;
    char32_t code = 0;
    bool valid = false;
};

/// Bytes of the character that a first byte announces; 0 if it announces none.
std::size_t announced(unsigned char first)
{
    if (first < 0x80) {
        return 1;
    }
    if (first < 0xc2 || first > 0xf4) {
        return 0;
    }
    return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

/// The first character of a text that is not empty; a single byte where that is not UTF-8.
Character first_character(std::string_view text)
{
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const Character broken{text.substr(0, 1), byte(0), false};
    const std::size_t size = announced(byte(0));
    if (size == 0 || size > text.size()) {
        return broken;
    }
    constexpr std::array<unsigned, 5> own_bits{0, 0x7f, 0x1f, 0x0f, 0x07};
    char32_t code = byte(0) & own_bits.at(size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0U) != 0x80U) {
            return broken;
        }
        code = (code << 6U) | (byte(i) & 0x3fU);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool is_one = code >= least.at(size) && code <= 0x10ffff && (code < 0xd800 || code > 0xdfff);
    return is_one ? Character{text.substr(0, size), code, true} : broken;
}

bool is_printable(const Character& c)
{
    // Controls; joiners and marks of direction; separators and embeddings; further ones; byte order mark; annotations
    // and noncharacters; tags.
    constexpr std::array<std::pair<char32_t, char32_t>, 8> refused{{{0x00, 0x1f},
                                                                    {0x7f, 0x9f},
                                                                    {0x200b, 0x200f},
                                                                    {0x2028, 0x202e},
                                                                    {0x2060, 0x206f},
                                                                    {0xfeff, 0xfeff},
                                                                    {0xfff9, 0xfffb},
                                                                    {0xe0000, 0xe007f}}};
    return c.valid && (c.code & 0xfffeU) != 0xfffeU &&
           std::ranges::none_of(refused, [&](const auto& r) { return c.code >= r.first && c.code <= r.second; });
}

template <class Take>
void for_each_character(std::string_view text, Take take)
{
    while (!text.empty()) {
        const auto character = first_character(text);
        take(character);
        text.remove_prefix(character.bytes.size());
    }
}

std::string visible(const Character& c)
{
    return c.valid ? fmt::format("\\u{:04x}", static_cast<unsigned>(c.code))
                   : fmt::format("\\x{:02x}", static_cast<unsigned>(c.code));
}

/// @param kept  characters that stay although they are not printable
template <class Show>
std::string replaced(std::string_view text, std::string_view kept, Show show)
{
    std::string result;
    result.reserve(text.size());
    for_each_character(text, [&](const Character& c) {
        const bool stays = is_printable(c) || (c.bytes.size() == 1 && kept.find(c.bytes[0]) != std::string_view::npos);
        result += stays ? std::string(c.bytes) : show(c);
    });
    return result;
}

}  // namespace

std::size_t character_count(std::string_view text)
{
    std::size_t count = 0;
    for_each_character(text, [&](const Character&) { ++count; });
    return count;
}

std::string first_unprintable(std::string_view text)
{
    std::string name;
    for_each_character(text, [&](const Character& c) {
        if (name.empty() && !is_printable(c)) {
            name = c.valid ? fmt::format("U+{:04X}", static_cast<unsigned>(c.code))
                           : fmt::format("byte 0x{:02x}", static_cast<unsigned>(c.code));
        }
    });
    return name;
}

std::string one_line(std::string_view text)
{
    return replaced(text, "", [](const Character& c) {
        const bool blank = c.code == '\n' || c.code == '\r' || c.code == '\t';
        return blank ? std::string(" ") : visible(c);
    });
}

std::string printable(std::string_view text) { return replaced(text, "\n\t", visible); }

std::string masked(std::string_view text)
{
    return replaced(text, "\t", [](const Character&) { return std::string("\xef\xbf\xbd"); });
}

std::string xml_text(std::string_view text)
{
    std::string result;
    for (const char c : one_line(text)) {
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : std::string(1, c);
    }
    return result;
}

std::string xml_comment(std::string_view text)
{
    std::string line = one_line(text);
    for (auto at = line.find("--"); at != std::string::npos; at = line.find("--", at)) {
        line.replace(at, 2, "- -");
    }
    return fmt::format("<!-- {} -->\n", line);
}

}  // namespace deadpoint
