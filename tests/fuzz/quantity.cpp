/// Requirement: a text is a finite quantity of a dimension, which reads back as the same number, or a problem; a text
/// is a formula or an error of ours. The first byte of the input chooses the dimension, or the formula.
#include "deadpoint/core/quantity.hpp"

#include "deadpoint/core/formula.hpp"
#include "deadpoint/error.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace {

void read_quantity(const std::string& text, deadpoint::Dimension dimension)
{
    const auto result = deadpoint::try_parse_quantity(text, dimension);
    const auto* value = std::get_if<double>(&result);
    if (value == nullptr)
        return;
    const auto again = deadpoint::try_parse_quantity(deadpoint::format_quantity(*value, dimension), dimension);
    if (!std::isfinite(*value) || !std::holds_alternative<double>(again) || std::get<double>(again) != *value)
        std::abort();
}

void read_formula(const std::string& text)
{
    try {
        const deadpoint::Formula formula(text);
        if (!std::isfinite(formula({0.1, 0.2, -0.3}, 60.0)))
            std::abort();
    } catch (const deadpoint::Error&) {
        return;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    if (size == 0)
        return 0;
    const std::string text(reinterpret_cast<const char*>(data + 1), size - 1);
    const auto dimensions = deadpoint::all_dimensions();
    const std::size_t chosen = data[0] % (dimensions.size() + 1);
    if (chosen < dimensions.size())
        read_quantity(text, dimensions[chosen].dimension);
    else
        read_formula(text);
    return 0;
}
