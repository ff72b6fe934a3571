#pragma once

#include "deadpoint/core/names/plain_text.hpp"

#include <fmt/format.h>
#include <string_view>
#include <utility>

/// All output of the command goes through these functions. Failed writes never end a run: text for
/// standard error is dropped; lost text of standard output is remembered and becomes an error at
/// the end. Control sequences in names and messages are made visible.

/// Adds text to standard output.
void write_out(std::string_view text);

/// The same, formatted.
template <class... Values>
void print_out(fmt::format_string<Values...> format, Values&&... values)
{
    write_out(fmt::format(format, std::forward<Values>(values)...));
}

/// Flushes standard output.
void flush_out();

/// Writes text to standard error unchanged, with terminal codes.
void write_err(std::string_view text);

/// Writes formatted text to standard error; failures are ignored.
template <class... Values>
void print_err(fmt::format_string<Values...> format, Values&&... values)
{
    write_err(deadpoint::printable(fmt::format(format, std::forward<Values>(values)...)));
}

/// @throws IoError if some text for standard output was lost
void require_whole_output();

/// Opens a file for standard input, output and error if the program was started without one;
/// otherwise the next opened file, perhaps a result file, would receive the text. Writing to a
/// missing output stays an error.
void open_missing_streams();
