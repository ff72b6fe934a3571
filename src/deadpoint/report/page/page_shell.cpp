#include "deadpoint/report/page/page_shell.hpp"

#include "deadpoint/core/hash.hpp"
#include "deadpoint/core/names/plain_text.hpp"
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

// The last line: a checksum of all before, by which a page is known that nobody has edited.
constexpr std::string_view seal_mark = "<!-- deadpoint wrote this page, checksum ";

std::string seal(std::string_view text) { return fmt::format("{}{} -->\n", seal_mark, stable_hash(text)); }

}  // namespace

void write_page(const fs::path& file, const PageContent& content, std::span<const std::string_view> scripts,
                IfThere if_there)
{
    const auto title = xml_text(content.title);
    std::string text =
        fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                    "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<meta name=\"generator\" content=\"deadpoint {}\">\n"
                    "<title>{} - deadpoint</title>\n<style>\n{}</style>\n</head>\n<body>\n<main id=\"page\">\n"
                    "<h1>{}</h1>\n<noscript>\n{}</noscript>\n</main>\n"
                    "<script type=\"application/json\" id=\"data\">{}</script>\n<script>\n/*\n{}*/\n{}\n</script>\n"
                    "<script>\n\"use strict\";\n",
                    policy, version, title, page_style(), title, content.without_scripts, embedded(content.data),
                    page_licences(), page_libraries());
    for (const auto script : scripts)
        text += script;
    text += "</script>\n</body>\n</html>\n";
    write_file(file, text + seal(text), if_there);
    record_file(file);
}

bool is_sealed(std::string_view page)
{
    const auto end = page.rfind(seal_mark);
    return end != std::string_view::npos && page.substr(end) == seal(page.substr(0, end));
}

}  // namespace deadpoint::report
