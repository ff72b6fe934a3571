#pragma once

#include <string_view>

/// Checks of the arguments of friction laws. The text names the quantity with its owner and unit,
/// as in "pin radius [m]".
namespace deadpoint::tribology {

/// @throws InputError unless the value is finite and greater than zero
void require_positive(std::string_view what, double value);

/// @throws InputError unless the value is finite and not negative
void require_not_negative(std::string_view what, double value);

/// For values that change while a law is evaluated, not for user input.
/// @throws DomainError unless the value is finite and greater than zero
void require_positive_state(std::string_view what, double value);

}  // namespace deadpoint::tribology
