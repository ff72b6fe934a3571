/// Requirement: whatever is given as --set, the case is read or an error of ours comes.
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        deadpoint::casefile::read_case(DEADPOINT_SOURCE_DIR "/tests/fuzz/sound/case.toml", {text});
    } catch (const deadpoint::Error&) {
        return 0;
    }
    return 0;
}
