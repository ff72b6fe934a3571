/// Requirement: whatever stands in a case file, reading it gives a case or an error of ours, and a case that was read
/// without mistakes reads back from what is written of it.
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/error.hpp"
#include "input_file.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".toml");
    static const InputFile again(".again.toml");
    file.write(data, size);
    deadpoint::casefile::Case read;
    try {
        read = deadpoint::casefile::read_case(file.path()).value;
    } catch (const deadpoint::Error&) {
        return 0;
    }
    const auto text = deadpoint::casefile::write_case(read);
    again.write(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    if (deadpoint::casefile::write_case(deadpoint::casefile::read_case(again.path()).value) != text)
        std::abort();
    return 0;
}
