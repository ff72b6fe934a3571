#pragma once

#include "deadpoint/casefile/syntax/document.hpp"

/// Internal to casefile/: a file of one kind that was given for another.
namespace deadpoint::casefile {

enum class KindOfFile { case_file, study, calibration, reference };

/// Adds an error if a file has sections of another kind and none of its own.
/// @return whether it is of the wanted kind
bool require_kind(const Document& document, KindOfFile wanted, Diagnostics& diagnostics);

}  // namespace deadpoint::casefile
