#include "errors.hpp"

#include <fmt/format.h>
#include <string>

void print_error(const deadpoint::Error& error)
{
    const std::string text = error.what();
    const bool placed = text.find(": error[") != std::string::npos;
    fmt::print(stderr, "{}{}\n", placed ? "" : "error: ", text);
}
