#include "deadpoint/machine/cad/step_names.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include <Resource_Unicode.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_ExtendedString.hxx>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace deadpoint::machine {
namespace {

constexpr std::size_t longest_name = 200;
constexpr std::size_t longest_key = 40;

bool is_byte(Standard_ExtCharacter letter) { return letter >= 0x80 && letter <= 0xff; }

/// Bytes that were read as letters, as the characters of GBK that they are.
TCollection_ExtendedString characters_of_gbk(const TCollection_ExtendedString& name)
{
    TCollection_ExtendedString result;
    for (int i = 1; i <= name.Length(); ++i) {
        const Standard_ExtCharacter letter = name.Value(i);
        const Standard_ExtCharacter next = i < name.Length() ? name.Value(i + 1) : 0;
        if (!is_byte(letter) || next < 0x40 || next > 0xff) {
            result.AssignCat(TCollection_ExtendedString(letter));
            continue;
        }
        const char pair[] = {static_cast<char>(letter), static_cast<char>(next), 0};
        TCollection_ExtendedString character;
        Resource_Unicode::ConvertGBKToUnicode(pair, character);
        result.AssignCat(character);
        ++i;
    }
    return result;
}

std::string trimmed(const std::string& text)
{
    const auto begin = text.find_first_not_of(' ');
    return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The first characters of a UTF-8 text, no more than `most` bytes of it.
std::string cut(std::string text, std::size_t most)
{
    if (text.size() > most) {
        while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0U) == 0x80) {
            --most;
        }
        text.resize(most);
    }
    return text;
}

/// Letters as they are written in plain ASCII: without marks, or transliterated.
const std::map<char16_t, std::string>& plain_letters()
{
    static const std::map<char16_t, std::string> plain = [] {
        std::map<char16_t, std::string> letters{{u'ä', "ae"}, {u'ö', "oe"}, {u'ü', "ue"}, {u'ß', "ss"}, {u'Ä', "Ae"},
                                                {u'Ö', "Oe"}, {u'Ü', "Ue"}, {u'é', "e"},  {u'è', "e"},  {u'ê', "e"},
                                                {u'à', "a"},  {u'á', "a"},  {u'â', "a"},  {u'å', "a"},  {u'ç', "c"},
                                                {u'í', "i"},  {u'ñ', "n"},  {u'ó', "o"},  {u'ø', "o"},  {u'ú', "u"},
                                                {u'ł', "l"},  {u'š', "s"},  {u'ž', "z"},  {u'č', "c"},  {u'ř', "r"},
                                                {u'ş', "s"},  {u'ı', "i"},  {u'ğ', "g"},  {u'ё', "yo"}, {u'Ё', "Yo"}};
        const std::vector<std::string> cyrillic{"a",  "b",  "v",  "g",    "d", "e", "zh", "z", "i",  "y", "k",
                                                "l",  "m",  "n",  "o",    "p", "r", "s",  "t", "u",  "f", "kh",
                                                "ts", "ch", "sh", "shch", "",  "y", "",   "e", "yu", "ya"};
        for (std::size_t i = 0; i < cyrillic.size(); ++i) {
            letters[static_cast<char16_t>(u'а' + i)] = letters[static_cast<char16_t>(u'А' + i)] = cyrillic[i];
        }
        return letters;
    }();
    return plain;
}

/// Letters, digits, '-' and '_' only: a name that needs no quotes in a case file.
std::string bare(const std::string& name)
{
    std::string result;
    for (const char c : name) {
        const bool kept = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || (c == '-' && !result.empty());
        if (kept || (!result.empty() && result.back() != '_')) {
            result += kept ? c : '_';
        }
    }
    while (!result.empty() && result.back() == '_') {
        result.pop_back();
    }
    return result;
}

}  // namespace

const char* code_page(StepLetters letters)
{
    switch (letters) {
    case StepLetters::utf8:
        return "UTF8";
    case StepLetters::cyrillic:
        return "CP1251";
    case StepLetters::gbk:
    case StepLetters::latin:
        break;
    }
    return "iso8859-1";
}

std::string step_name(const TCollection_ExtendedString& whole, StepLetters letters)
{
    constexpr int worth_reading = 4 * static_cast<int>(longest_name);
    TCollection_ExtendedString name = whole;
    name.Trunc(std::min(name.Length(), worth_reading));
    const TCollection_AsciiString text(letters == StepLetters::gbk ? characters_of_gbk(name) : name);
    return trimmed(cut(trimmed(one_line({text.ToCString(), static_cast<std::size_t>(text.Length())})), longest_name));
}

bool says_nothing(const std::string& name)
{
    std::string small = name;
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    while (!small.empty() && (std::isdigit(static_cast<unsigned char>(small.back())) != 0 || small.back() == '_' ||
                              small.back() == ' ' || small.back() == '.')) {
        small.pop_back();
    }
    static const std::set<std::string> empty{
        "",     "solid", "compound", "body",    "shape", "none", "open cascade step translator", "manifold_solid_brep",
        "brep", "part",  "product",  "assembly"};
    return empty.contains(small) || small.starts_with("=>") || small.starts_with("open cascade");
}

std::string key_of(const std::string& name)
{
    const TCollection_ExtendedString letters(name.c_str(), true);
    std::string text;
    for (int i = 1; i <= letters.Length(); ++i) {
        const auto letter = static_cast<char16_t>(letters.Value(i));
        const auto plain = plain_letters().find(letter);
        text += plain != plain_letters().end() ? plain->second
                                               : std::string(1, letter < 128 ? static_cast<char>(letter) : '_');
    }
    const std::string key = bare(bare(text).substr(0, longest_key));
    return key.empty() ? "solid" : key;
}

}  // namespace deadpoint::machine
