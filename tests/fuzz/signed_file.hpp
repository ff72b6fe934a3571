#pragma once

#include "deadpoint/io/binary_file.hpp"

#include <sstream>
#include <string>
#include <string_view>

/// The bytes behind the first line of a binary file, with the first line, length and checksum that fit: chance does not
/// find them, and behind them lies what is to be tried.
inline std::string signed_file(std::string_view kind, std::string_view bytes)
{
    std::ostringstream out;
    deadpoint::BinaryWriter writer(out, std::string(kind).append(bytes));
    writer.finish();
    return out.str();
}
