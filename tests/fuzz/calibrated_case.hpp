#pragma once

#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/error.hpp"
#include "input_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// The case that the calibrations of fuzzers are about, beside the input. Keys are taken as they are.
inline deadpoint::casefile::CalibratedCase calibrated_case(const InputFile& beside)
{
    const auto path = beside.folder() / "case.toml";
    std::filesystem::copy_file(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml", path,
                               std::filesystem::copy_options::overwrite_existing);
    deadpoint::casefile::CalibratedCase of;
    of.path = path;
    of.keys_of = [](const deadpoint::casefile::Case&, const std::vector<std::string>& patterns) { return patterns; };
    return of;
}
