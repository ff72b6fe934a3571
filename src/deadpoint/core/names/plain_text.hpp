#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Text from outside (names of a case, of files, messages of libraries) at the borders of the program.
///
/// The following are not printable: control characters, including line breaks; characters that are
/// invisible or change the direction of the following text; and bytes that are not UTF-8.
namespace deadpoint {

/// Characters of a UTF-8 text; a byte that belongs to none counts as one.
std::size_t character_count(std::string_view text);

/// Name of the first character that is not printable ("U+001B", "byte 0xff"); empty if there is
/// none.
std::string first_unprintable(std::string_view text);

/// The text with a blank for each line break and tab, and everything else that is not printable made visible, like
/// "\u001b" or "\xff". For one line of a file.
std::string one_line(std::string_view text);

/// The same, but line breaks and tabs stay. For a terminal.
std::string printable(std::string_view text);

/// The text with a mark (U+FFFD) for each character that is not printable, tabs aside: as many characters as before.
std::string masked(std::string_view text);

/// The same as one_line(), with XML and HTML markup escaped; for elements and quoted attributes.
std::string xml_text(std::string_view text);

/// A line with an XML comment that holds the text, in which "--" may not stand.
std::string xml_comment(std::string_view text);

}  // namespace deadpoint
