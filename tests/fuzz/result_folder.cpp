/// Requirement: whatever stands in summary.json or history.csv of a results folder, reading it gives a record or an
/// error of ours. The first byte of the input chooses the file; the other one is sound.
#include "deadpoint/core/error.hpp"
#include "deadpoint/report/read_result.hpp"
#include "input_file.hpp"

#include <array>
#include <filesystem>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file("");
    static const std::array<std::string, 3> names{"summary.json", "history.csv", "loads.json"};
    if (size == 0)
        return 0;
    const auto chosen = data[0] % names.size();
    for (const auto& name : names) {
        const auto target = file.folder() / name;
        if (name == names[chosen])
            InputFile::write(target, data + 1, size - 1);
        else
            std::filesystem::copy_file(DEADPOINT_SOURCE_DIR "/tests/fuzz/sound/" + name, target,
                                       std::filesystem::copy_options::overwrite_existing);
    }
    try {
        deadpoint::report::read_result(file.folder());
    } catch (const deadpoint::Error&) {
        return 0;
    }
    return 0;
}
