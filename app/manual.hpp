#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

/// The command's manual and shell completions, made of the options that it has.

/// A manual page (man 1).
std::string man_page(const CLI::App& app, const std::string& version);
/// Completion of subcommands, options and files.
std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

/// Writes deadpoint.1, deadpoint.bash, _deadpoint and deadpoint.fish into an existing folder.
/// @throws IoError if one cannot be written
void write_manual(const CLI::App& app, const std::string& version, const std::filesystem::path& folder);
