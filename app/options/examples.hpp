#pragma once

#include <CLI/CLI.hpp>

/// Gives the program all examples of use and each subcommand its own, below their help.
void add_examples(CLI::App& app);
