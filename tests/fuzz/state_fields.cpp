/// Requirement: whatever stands in a file of fields with a right checksum, reading it gives as many finite numbers as
/// are due, or an error of ours.
#include "deadpoint/error.hpp"
#include "deadpoint/fem/reduction/field_reader.hpp"
#include "input_file.hpp"
#include "signed_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

using namespace deadpoint;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    constexpr std::size_t states = 3, unknowns = 8;
    static const InputFile file(".fields.rom");
    const auto bytes = signed_file(fem::fields_kind, {reinterpret_cast<const char*>(data), size});
    file.write(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    try {
        fem::FieldReader reader(file.path().string(), {{}, "model", "mesh"}, states, unknowns);
        for (std::size_t k = 0; k < states; ++k) {
            const auto field = reader.next();
            if (field.size() != unknowns || !std::ranges::all_of(field, [](float x) { return std::isfinite(x); }))
                std::abort();
        }
    } catch (const Error&) {
    }
    return 0;
}
