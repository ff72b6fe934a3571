#pragma once

#include <string>
#include <string_view>

/// Files that are compiled into the program, so that it needs no files at run time.
namespace deadpoint::casefile {

/// Text of the commented starter case (cases/starter/case.toml); reads without errors.
std::string_view starter_case();

/// Texts of data/materials.toml and data/lubricants.toml.
std::string_view shipped_materials();
std::string_view shipped_lubricants();

}  // namespace deadpoint::casefile
