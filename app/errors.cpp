#include "errors.hpp"

#include "output.hpp"

#include <string>

void print_error(const deadpoint::Error& error)
{
    const std::string text = error.what();
    const bool placed = text.find(": error[") != std::string::npos;
    print_err("{}{}\n", placed ? "" : "error: ", text);
}
