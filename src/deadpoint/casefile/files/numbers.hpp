#pragma once

#include "deadpoint/core/quantity.hpp"

#include <map>
#include <string>
#include <vector>

/// The numbers of a case by their keys, for studies that change them without reading the case again.
namespace deadpoint::casefile {

struct Case;

/// A number of a case. A curve over time or temperature counts as one: a factor acts on all of its values.
struct CaseNumber {
    std::string path;     ///< as for --set: "joints.crank_pin.interfaces.0.oil"
    std::string by_name;  ///< the same with the names of list items, where they have one: "...interfaces.pin.oil"
    double value = 0;     ///< in SI units; of a curve its first value, of a daily course its mean
    Dimension dimension = Dimension::none;
    double least = 0, most = 0;  ///< allowed values, in SI units
};

/// All quantities and plain numbers that a case has, also those that the library or a default states.
std::vector<CaseNumber> numbers_of(const Case& input);

/// Those that a pattern names, by number or by name of list items; `*` stands for any characters.
std::vector<const CaseNumber*> numbers_matching(const std::vector<CaseNumber>& numbers, const std::string& pattern);

/// The key nearest to a pattern that matches none: the closest spelling, else the longest common beginning.
std::string nearest_key(const std::vector<CaseNumber>& numbers, const std::string& pattern);

/// A new value is factor times the old one, plus shift [SI units]. A daily course keeps its amplitude under a shift.
struct NumberChange {
    double factor = 1;
    double shift = 0;
};

/// @param changes  by CaseNumber::path; other paths change nothing
/// @throws InputError if a value leaves its allowed range, with the key
void change_numbers(Case& input, const std::map<std::string, NumberChange>& changes);

/// Values as text for --set and case files, by path; those of paths that the case has.
std::map<std::string, std::string> texts_of(const Case& input, const std::vector<std::string>& paths);

}  // namespace deadpoint::casefile
