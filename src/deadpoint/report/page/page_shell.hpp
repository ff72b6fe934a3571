#pragma once

#include "deadpoint/io/write_file.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

/// Internal to report/: the common parts of the pages of a run and of a study.
namespace deadpoint::report {

struct PageContent {
    std::string title;
    nlohmann::ordered_json data;
    std::string without_scripts;  ///< HTML for readers whose browser runs no scripts
};

/// Writes the page, with the scripts after the libraries in this order; complete or absent.
/// @throws IoError if it cannot be written
void write_page(const std::filesystem::path& file, const PageContent& content,
                std::span<const std::string_view> scripts, IfThere if_there);
/// Whether a text is a page that write_page() has written and nobody has changed.
bool is_sealed(std::string_view page);

}  // namespace deadpoint::report
