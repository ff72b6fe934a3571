#pragma once

#include <string>
#include <string_view>

namespace deadpoint::machine {

/// How a STEP file writes letters beyond ASCII, other than by the escapes of ISO 10303-21.
enum class StepLetters { utf8, gbk, cyrillic, latin };

/// Properties of a STEP file that must be known before a library reads it.
struct StepText {
    bool has_unit = false;  ///< it says its unit of length
    StepLetters letters = StepLetters::utf8;
    std::size_t overflow = 0;  ///< line of a number beyond 1e300, with which Open CASCADE may compute forever; 0: none
};

/// The encoding of a text: UTF-8 where most of its bytes are; GBK where pairs of bytes are mostly the 3755 common
/// characters of GB 2312, and not each alone within a word of ASCII letters; Windows-1251 where runs of three bytes and
/// more are mostly Cyrillic letters; else ISO 8859-1.
StepLetters letters_of(std::string_view text);

/// Checks a STEP file: it must begin and end correctly, and have values where values are expected.
/// Open CASCADE would compute forever with unreadable values ("nan").
/// @throws IoError if it cannot be read, InputError naming part, file and line
StepText check_step_file(const std::string& part, const std::string& path);

}  // namespace deadpoint::machine
