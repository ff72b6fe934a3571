#pragma once

#include <filesystem>

namespace deadpoint::press {
struct RunRecord;
}

namespace deadpoint::report {

/// Reads the results of `deadpoint run` in a folder: summary.json, history.csv and, where there is
/// one, loads.json.
/// @throws IoError if the folder or one of the first two files cannot be read
/// @throws InputError if a file is not as the program wrote it, or times do not increase
press::RunRecord read_result(const std::filesystem::path& folder);

}  // namespace deadpoint::report
