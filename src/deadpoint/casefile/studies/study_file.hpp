#pragma once

#include "deadpoint/casefile/studies/design_section.hpp"
#include "deadpoint/casefile/syntax/file_access.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// A study file, as `deadpoint sweep` and `deadpoint sensitivity` read it.
namespace deadpoint::casefile {

class Visitor;

struct StudyAxis {
    std::string name;  ///< after reading never empty
    std::string key;
    std::vector<std::string> keys;                 ///< after reading: all of them, also a single `key`
    std::vector<std::vector<std::string>> values;  ///< per step, one text for each key; after reading also of a range
    std::string from;
    std::string to;
    int count = 0;                    ///< steps of the range
    std::vector<std::string> labels;  ///< after reading: one per step
};

struct StudySet {
    std::string name;
    std::vector<StudyAxis> axes;
};

struct StudyLimits {
    std::optional<double> largest;  ///< of |E_SW| at any time [m]
    std::optional<double> final;    ///< of |E_SW| at the end [m]
};

struct StudyFile {
    int format = 1;
    std::string name;
    std::string note;
    std::string base;  ///< after reading: the full path of the base case
    std::vector<std::string> set;
    std::vector<StudySet> sets;
    std::optional<StudyLimits> limits;
    std::optional<SensitivitySection> sensitivity;
    std::optional<OptimiseSection> optimise;
    FileAccess files = FileAccess::below;  ///< files that the base case may name
};

void describe(Visitor& v, StudyFile& f);
void describe(Visitor& v, StudySet& s);
void describe(Visitor& v, StudyAxis& a);
void describe(Visitor& v, StudyLimits& l);

inline constexpr std::size_t most_study_points = 10000;

/// Reads and checks a study file: every axis gets its name, its steps and their labels, and every value has been read
/// by the base case.
///
/// @param path   TOML, format = 1; its base case may lie anywhere
/// @param files files that this case may name
/// @throws InputError whose text lists every mistake with file:line:column, the line and a remedy; mistakes of the
///         base case itself are listed as for a run
/// @throws IoError if a file cannot be read
StudyFile read_study(const std::filesystem::path& path, FileAccess files = FileAccess::below);

/// A text such as "300 rpm" in its two halves; the unit of "0.3" is empty.
struct NumberAndUnit {
    double number = 0;
    std::string unit;
};
/// @return nothing if the text does not begin with a finite number
std::optional<NumberAndUnit> number_and_unit(std::string_view text);

/// One way to write a value, so that "300 rpm" and "300.0  rpm" are the same step.
std::string plain_setting(std::string_view text);

}  // namespace deadpoint::casefile
