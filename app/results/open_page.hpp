#pragma once

#include <filesystem>

/// Opens a page in the browser of the desktop, or of $BROWSER, and says so; else says where the page is.
void open_page(const std::filesystem::path& page);
