#pragma once

#include "deadpoint/error.hpp"

/// Shows an error of the library on standard error. Messages about case files begin with their own place.
void print_error(const deadpoint::Error& error);
