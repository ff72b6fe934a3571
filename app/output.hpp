#pragma once

#include "deadpoint/core/plain_text.hpp"

#include <fmt/format.h>
#include <string_view>
#include <utility>

/// All that the command prints goes through here. What cannot be written never ends a run: text for standard error is
/// dropped, lost text of standard output is remembered and becomes an error when everything else is done.
///
/// Names and messages in it may hold what moves a cursor or changes colours: that is made visible.

/// Adds text to standard output.
void write_out(std::string_view text);

/// The same, formatted.
template <class... Values>
void print_out(fmt::format_string<Values...> format, Values&&... values)
{
    write_out(fmt::format(format, std::forward<Values>(values)...));
}

/// Shows what standard output was given so far.
void flush_out();

/// Shows text on standard error just as it is, with codes for the terminal.
void write_err(std::string_view text);

/// Shows formatted text on standard error, as far as that takes it.
template <class... Values>
void print_err(fmt::format_string<Values...> format, Values&&... values)
{
    write_err(deadpoint::printable(fmt::format(format, std::forward<Values>(values)...)));
}

/// @throws IoError if some of what standard output was given is lost
void require_whole_output();

/// Gives standard input, output and error a file where the program was started without one; else the next file that is
/// opened, one of results perhaps, would take the text. A missing output stays an error for whoever writes to it.
void open_missing_streams();
