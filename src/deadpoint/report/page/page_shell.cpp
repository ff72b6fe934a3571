#include "deadpoint/report/page/page_shell.hpp"

#include "deadpoint/core/plain_text.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/page/page_parts.hpp"

#include <fmt/format.h>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view policy =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

// JSON that is safe in a script element, whatever its strings contain.
std::string embedded(const Json& json)
{
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string result;
    result.reserve(text.size());
    for (const char c : text) {
        if (c == '<')
            result += "\\u003c";
        else
            result += c;
    }
    return result;
}

}  // namespace

void write_page(const fs::path& file, const PageContent& content, std::span<const std::string_view> scripts,
                IfThere if_there)
{
    const auto title = xml_text(content.title);
    const auto fill = [&](std::ostream& out) {
        out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            << "<meta http-equiv=\"Content-Security-Policy\" content=\"" << policy << "\">\n"
            << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            << "<meta name=\"generator\" content=\"deadpoint " << version << "\">\n"
            << "<title>" << title << " - deadpoint</title>\n<style>\n"
            << page_style() << "</style>\n</head>\n<body>\n<main id=\"page\">\n<h1>" << title << "</h1>\n"
            << "<noscript>\n"
            << content.without_scripts << "</noscript>\n</main>\n"
            << "<script type=\"application/json\" id=\"data\">" << embedded(content.data) << "</script>\n"
            << "<script>\n/*\n"
            << page_licences() << "*/\n"
            << page_libraries() << "\n</script>\n<script>\n\"use strict\";\n";
        for (const auto script : scripts)
            out << script;
        out << "</script>\n</body>\n</html>\n";
    };
    write_file(file, fill, Durability::usual, if_there);
    record_file(file);
}

}  // namespace deadpoint::report
