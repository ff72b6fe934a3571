/// Requirement: a text is a finite quantity of each dimension, which reads back as the same number, or a problem; a
/// text is a formula or an error of ours.
#include "deadpoint/core/quantity.hpp"

#include "deadpoint/core/error.hpp"
#include "deadpoint/core/formula.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const auto& info : deadpoint::all_dimensions()) {
        const auto result = deadpoint::try_parse_quantity(text, info.dimension);
        const auto* value = std::get_if<double>(&result);
        if (value == nullptr)
            continue;
        const auto again =
            deadpoint::try_parse_quantity(deadpoint::format_quantity(*value, info.dimension), info.dimension);
        if (!std::isfinite(*value) || !std::holds_alternative<double>(again) || std::get<double>(again) != *value)
            std::abort();
    }
    try {
        const deadpoint::Formula formula(text);
        if (!std::isfinite(formula({0.1, 0.2, -0.3}, 60.0)))
            std::abort();
    } catch (const deadpoint::Error&) {
        return 0;
    }
    return 0;
}
