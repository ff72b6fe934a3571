#pragma once

#include "deadpoint/observer.hpp"

#include <filesystem>

/// The address of a local file: "file://" and its path, in which every byte but letters, digits and -._~/ is written as
/// % and two hexadecimal digits (RFC 3986), so that # and ? are part of the name.
std::string file_address(const std::filesystem::path& file);

/// @throws IoError if one of the pictures is there, and may not be replaced by force either
void require_new_pictures(const std::filesystem::path& folder, bool force);

/// Pictures of the machine at the end of the run, machine-oblique.png and others, drawn by Chromium without a window
/// from the page itself. They replace what is there.
/// @param folder  created if missing
/// @throws IoError if Chromium is missing, fails or takes longer than DEADPOINT_BROWSER_SECONDS (120) for one of them
/// @return false after Ctrl-C
bool take_pictures(const std::filesystem::path& page, const std::filesystem::path& folder,
                   deadpoint::Observer& observer);
