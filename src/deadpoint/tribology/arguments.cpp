#include "deadpoint/tribology/arguments.hpp"

#include "deadpoint/error.hpp"

#include <cmath>
#include <fmt/format.h>

namespace deadpoint::tribology {

void require_positive(std::string_view what, double value)
{
    if (!(value > 0) || !std::isfinite(value))
        throw InputError(
            fmt::format("{} is {}, but must be greater than zero\n  help: state its true size", what, value));
}

void require_not_negative(std::string_view what, double value)
{
    if (!(value >= 0) || !std::isfinite(value))
        throw InputError(
            fmt::format("{} is {}, but must not be negative\n  help: use zero to leave it out", what, value));
}

void require_positive_state(std::string_view what, double value)
{
    if (!(value > 0) || !std::isfinite(value))
        throw DomainError(fmt::format("{} became {}, where friction has no meaning\n  help: check the temperatures and "
                                      "the lubricant's range",
                                      what, value));
}

}  // namespace deadpoint::tribology
