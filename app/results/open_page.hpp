#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What a started program may write.
enum class Says { everything, no_errors, nothing };

/// Runs a program of the path; false if there is none or it fails.
bool run_program(std::vector<std::string> command, Says says);

/// Opens a page in the browser of the desktop, or of $BROWSER, and says so; else says where the page is.
void open_page(const std::filesystem::path& page);
