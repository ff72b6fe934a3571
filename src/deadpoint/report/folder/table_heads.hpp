#pragma once

#include <string>

/// Comment lines that left the tables of a result folder (table_style.hpp).
namespace deadpoint::report {

inline constexpr const char* table_heads_name = "tables.json";

/// A table as the program writes it, from its text in a folder and the text of tables.json there.
/// @throws InputError if tables.json is not as style_tables() writes it
std::string usual_table(const std::string& name, const std::string& text, const std::string& heads);

}  // namespace deadpoint::report
