#pragma once

#include <string>
#include <string_view>

/// What the program brings along: compiled into it, so that it never looks for files of its own.
namespace deadpoint::casefile {

/// Text of the commented starter case (cases/starter/case.toml); reads without errors.
std::string_view starter_case();

/// Texts of data/materials.toml and data/lubricants.toml.
std::string_view shipped_materials();
std::string_view shipped_lubricants();

}  // namespace deadpoint::casefile
