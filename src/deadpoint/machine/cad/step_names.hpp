#pragma once

#include "deadpoint/machine/foreign/step_file.hpp"

#include <string>

class TCollection_ExtendedString;

/// Names in a STEP file.
namespace deadpoint::machine {

/// Open CASCADE's code page for the letters of a file. It knows none for GBK: there its letters are bytes, which
/// step_name() puts together.
const char* code_page(StepLetters letters);

/// A name as Open CASCADE has it, in UTF-8: on one line, without blanks at its ends, at most 200 characters.
std::string step_name(const TCollection_ExtendedString& name, StepLetters letters);

/// Whether a program wrote the name for want of a better one: "SOLID", "Solid1", "=>[0:1:1:2]".
bool says_nothing(const std::string& name);

/// A name as a key of a case: ASCII letters, digits, '-' and '_', at most 40. Latin letters lose their marks, Cyrillic
/// ones are transliterated; others are left out. "solid" where nothing is left.
std::string key_of(const std::string& name);

}  // namespace deadpoint::machine
