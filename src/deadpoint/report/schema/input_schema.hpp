#pragma once

#include <span>
#include <string>
#include <string_view>

/// JSON schemas of the files that users write, for completion and meanings in editors.
namespace deadpoint::report::schema {

/// The kinds of files: case, study, calibration, reference.
std::span<const std::string_view> input_kinds();

/// The schema (JSON Schema, draft 07) of a kind of file, from the descriptions that also read it.
///
/// It states the keys of each table, the kind, range, default and meaning of their values. It requires no key, since
/// included files may hold it, and checks no unit and no rule between keys: 'deadpoint check' does.
///
/// @throws InputError if there is no such kind
std::string input_schema(std::string_view kind);

}  // namespace deadpoint::report::schema
