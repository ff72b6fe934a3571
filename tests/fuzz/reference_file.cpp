/// Requirement: whatever stands in a reference file, reading it gives figures or an error of ours.
#include "deadpoint/casefile/studies/reference_file.hpp"

#include "deadpoint/error.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".toml");
    file.write(data, size);
    try {
        for (const auto& [name, point] : deadpoint::casefile::reference_points(file.path()))
            deadpoint::casefile::read_reference(file.path(), name);
        deadpoint::casefile::read_reference(file.path());
    } catch (const deadpoint::Error&) {
        return 0;
    }
    return 0;
}
