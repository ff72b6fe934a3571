#pragma once

#include <string>

namespace deadpoint::casefile {

/// The reference of the case file as Markdown: every section and key with its unit, range, default and meaning, and
/// the shipped library. docs/case-file.md is this text; a test compares the two.
std::string reference_page();

/// The same for the reference files of `compare`: docs/reference-file.md.
std::string reference_file_page();

/// The same for the study files of `sweep`: docs/study-file.md.
std::string study_file_page();

/// The same for the calibration files of `calibrate`: docs/calibration-file.md.
std::string calibration_file_page();

}  // namespace deadpoint::casefile
