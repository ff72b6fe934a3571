#pragma once

#include <CLI/CLI.hpp>

/// Each adds one subcommand. If the user chooses it, it runs during parsing and stores its exit
/// code in `exit_code`. Errors of the library pass through to main().
void add_init(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_mesh(CLI::App& app, int& exit_code);
void add_loads(CLI::App& app, int& exit_code);
void add_heat(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_reduce(CLI::App& app, int& exit_code);
void add_sweep(CLI::App& app, int& exit_code);
void add_sensitivity(CLI::App& app, int& exit_code);
void add_calibrate(CLI::App& app, int& exit_code);
void add_optimise(CLI::App& app, int& exit_code);
void add_probe(CLI::App& app, int& exit_code);
void add_report(CLI::App& app, int& exit_code);
void add_schema(CLI::App& app, int& exit_code);
void add_view(CLI::App& app, int& exit_code);
