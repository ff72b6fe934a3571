/// Requirement: whatever stands in summary.json or history.csv of a results folder, reading it gives a record or an
/// error of ours. The first byte of the input chooses the file; the other one is sound.
#include "deadpoint/error.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/folder/read_result.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "input_file.hpp"

#include <array>
#include <filesystem>

namespace {

constexpr std::array<const char*, 3> names{"summary.json", "history.csv", "loads.json"};

void make_sound(const std::filesystem::path& folder, const char* name)
{
    std::filesystem::copy_file(std::filesystem::path(DEADPOINT_SOURCE_DIR "/tests/fuzz/sound") / name, folder / name,
                               std::filesystem::copy_options::overwrite_existing);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file("");
    static const bool ready = [] {
        for (const char* name : names)
            make_sound(file.folder(), name);
        return true;
    }();
    static std::size_t broken = 0;
    if (size == 0 || !ready)
        return 0;
    const auto chosen = data[0] % names.size();
    if (chosen != broken)
        make_sound(file.folder(), names[broken]);
    broken = chosen;
    InputFile::write(file.folder() / names[chosen], data + 1, size - 1);
    deadpoint::report::write_manifest(file.folder());  // chance does not find the checksum
    try {
        deadpoint::report::read_result(file.folder());
    } catch (const deadpoint::Error&) {
        return 0;
    }
    return 0;
}
