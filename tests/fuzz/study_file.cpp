/// Requirement: whatever stands in a study file, reading it gives a study or an error of ours.
#include "deadpoint/casefile/studies/study_file.hpp"

#include "deadpoint/error.hpp"
#include "input_file.hpp"

#include <filesystem>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".toml");
    static const bool copied =
        std::filesystem::copy_file(DEADPOINT_SOURCE_DIR "/tests/fuzz/sound/case.toml", file.folder() / "case.toml");
    (void)copied;
    file.write(data, size);
    try {
        deadpoint::casefile::read_study(file.path());
    } catch (const deadpoint::Error&) {
        return 0;
    }
    return 0;
}
