#pragma once

#include "deadpoint/error.hpp"

#include <exception>

/// Shows an error of the library on standard error. Messages about case files begin with their own place.
void print_error(const deadpoint::Error& error);

/// Shows whatever was thrown. @return its exit code
int explain(const std::exception_ptr& thrown);
/// The exit code alone.
int exit_code_of(const std::exception_ptr& thrown);
