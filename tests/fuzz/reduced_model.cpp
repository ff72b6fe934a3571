/// Requirement: whatever stands in a reduced model with a right checksum, reading it gives a press whose sizes fit,
/// which is the same once written and read back, or an error of ours. Small and large models have one format.
#include "deadpoint/error.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "input_file.hpp"
#include "signed_file.hpp"

#include <cstdlib>
#include <filesystem>
#include <string_view>

using namespace deadpoint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".rom");
    const auto bytes = signed_file(twin::reduced_kind, {reinterpret_cast<const char*>(data), size});
    file.write(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    twin::ReducedPress press;
    try {
        press = twin::read_reduced(file.path());
    } catch (const IoError&) {
        return 0;
    }
    const auto again = file.folder() / "again.rom";
    try {
        twin::write_reduced(again, press);
        if (twin::read_reduced(again).states != press.states)
            std::abort();
    } catch (const IoError&) {  // what a uniform temperature does was restored, and may now be too large for 32 bits
    }
    return 0;
}
