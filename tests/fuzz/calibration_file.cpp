/// Requirement: whatever stands in a calibration file, reading it for a fit or a plan gives a calibration or an error
/// of ours.
#include "calibrated_case.hpp"

#include <filesystem>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".toml");
    static const auto of = [] {
        std::filesystem::copy_file(DEADPOINT_SOURCE_DIR "/tests/fuzz/seeds/measured_file-points",
                                   file.folder() / "log.csv", std::filesystem::copy_options::overwrite_existing);
        InputFile::write(file.folder() / "press.rom", reinterpret_cast<const std::uint8_t*>("r"),
                         1);  // named, not read
        return calibrated_case(file);
    }();
    file.write(data, size);
    for (const bool plan : {false, true})
        try {
            (void)deadpoint::casefile::read_calibration(file.path(), of, plan);
        } catch (const deadpoint::Error&) {
            continue;
        }
    return 0;
}
