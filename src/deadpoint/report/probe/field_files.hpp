#pragma once

#include "deadpoint/io/read_vtu.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// The field files of a result folder.
namespace deadpoint::report {

class ResultFiles;

/// Times and files of the fields, ascending. @throws InputError if there are none
std::vector<PvdEntry> field_times(const ResultFiles& results);

/// The field of one time: a file, or one of each rank.
/// @throws IoError, InputError as ResultFiles::read() and parse_vtu()
std::vector<VtuContents> field_pieces(const ResultFiles& results, const std::string& name);

/// Number of the part of each cell. @throws InputError if the file has none
const std::vector<std::int32_t>& parts_of(const VtuContents& piece);

}  // namespace deadpoint::report
