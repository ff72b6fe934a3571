#include "deadpoint/full/draft/draft.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace deadpoint::full {
namespace {

struct Word {
    std::string_view text;
    Role role;
};

/// English, German, Chinese and transliterated Russian. Where a name holds several, the longest counts:
/// "connecting_rod" is a rod, "motor_shaft" stands with the motor.
constexpr std::array words{Word{"crankshaft", Role::crank},
                           Word{"crank", Role::crank},
                           Word{"eccentric", Role::crank},
                           Word{"flywheel", Role::crank},
                           Word{"clutch", Role::crank},
                           Word{"shaft", Role::crank},
                           Word{"kurbelwelle", Role::crank},
                           Word{"kurbel", Role::crank},
                           Word{"exzenter", Role::crank},
                           Word{"schwungrad", Role::crank},
                           Word{"welle", Role::crank},
                           Word{"kupplung", Role::crank},
                           Word{"connecting_rod", Role::rod},
                           Word{"conrod", Role::rod},
                           Word{"con_rod", Role::rod},
                           Word{"pitman", Role::rod},
                           Word{"link", Role::rod},
                           Word{"rod", Role::rod},
                           Word{"pleuel", Role::rod},
                           Word{"slide", Role::slide},
                           Word{"slider", Role::slide},
                           Word{"ram", Role::slide},
                           Word{"plunger", Role::slide},
                           Word{"stoessel", Role::slide},
                           Word{"st_ssel", Role::slide},
                           Word{"upper_die", Role::slide},
                           Word{"frame", Role::frame},
                           Word{"bed", Role::frame},
                           Word{"base", Role::frame},
                           Word{"column", Role::frame},
                           Word{"upright", Role::frame},
                           Word{"crown", Role::frame},
                           Word{"table", Role::frame},
                           Word{"bolster", Role::frame},
                           Word{"gib", Role::frame},
                           Word{"guide", Role::frame},
                           Word{"slide_guide", Role::frame},
                           Word{"slideway", Role::frame},
                           Word{"guide_rod", Role::frame},
                           Word{"bracket", Role::frame},
                           Word{"foot", Role::frame},
                           Word{"feet", Role::frame},
                           Word{"motor", Role::frame},
                           Word{"motor_shaft", Role::frame},
                           Word{"housing", Role::frame},
                           Word{"cover", Role::frame},
                           Word{"gestell", Role::frame},
                           Word{"staender", Role::frame},
                           Word{"st_nder", Role::frame},
                           Word{"tisch", Role::frame},
                           Word{"fuehrung", Role::frame},
                           Word{"f_hrung", Role::frame},
                           Word{"tie_rod", Role::frame},
                           Word{"lower_die", Role::frame},
                           Word{"\u66f2\u8f74", Role::crank},        // crankshaft
                           Word{"\u98de\u8f6e", Role::crank},        // flywheel
                           Word{"\u8fde\u6746", Role::rod},          // connecting rod
                           Word{"\u6ed1\u5757", Role::slide},        // slide
                           Word{"\u673a\u67b6", Role::frame},        // frame
                           Word{"\u673a\u8eab", Role::frame},        // frame
                           Word{"\u5de5\u4f5c\u53f0", Role::frame},  // table
                           Word{"kolenval", Role::crank},
                           Word{"makhovik", Role::crank},
                           Word{"shatun", Role::rod},
                           Word{"polzun", Role::slide},
                           Word{"stanina", Role::frame},
                           Word{"stol", Role::frame}};

constexpr std::array<std::string_view, 8> bronzes{"bush",   "bushing", "bronze",     "liner",
                                                  "buchse", "sleeve",  "gleitlager", "brass"};

constexpr std::array<std::string_view, 7> rings{"ring",      "race",       "bearing",  "lager",
                                                "innenring", "aussenring", "w_lzlager"};

std::string underscored(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::ranges::replace(text, '-', '_');
    return text;
}

/// Whether a word stands in a name on its own or at the beginning of a word: "ram" is not in "frame".
bool holds(const std::string& name, std::string_view word)
{
    for (auto at = name.find(word); at != std::string::npos; at = name.find(word, at + 1)) {
        if (at == 0 || std::isalpha(static_cast<unsigned char>(name[at - 1])) == 0) {
            return true;
        }
    }
    return false;
}

}  // namespace

Role role_of(const std::string& name)
{
    const std::string small = underscored(name);
    const Word* best = nullptr;
    for (const Word& word : words) {
        if (holds(small, word.text) && (best == nullptr || word.text.size() > best->text.size())) {
            best = &word;
        }
    }
    return best == nullptr ? Role::unknown : best->role;
}

bool is_ring(const std::string& name)
{
    const std::string small = underscored(name);
    return std::ranges::any_of(rings, [&](auto word) { return holds(small, word); });
}

std::string material_of(const std::string& name, Role role)
{
    const std::string small = underscored(name);
    if (std::ranges::any_of(bronzes, [&](auto word) { return holds(small, word); })) {
        return "bronze";
    }
    const bool cast =
        role == Role::frame || role == Role::slide || holds(small, "flywheel") || holds(small, "schwungrad");
    return cast && !holds(small, "pin") && !holds(small, "bolt") ? "iron" : "steel";
}

}  // namespace deadpoint::full
