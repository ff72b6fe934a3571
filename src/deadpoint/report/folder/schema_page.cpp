#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/schema/schema.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace deadpoint::report::schema {
namespace {

constexpr const char* introduction = R"(# Result files

This page lists every file that the program writes into a result folder, with every column and key, its unit and meaning.
The program prints this page; a test fails if a file has other contents.

Format of the folders: {0}. `deadpoint.json` in each folder states it, and a program refuses folders of another format.

A name in braces, like `{{joint}}`, is a placeholder for a name of the case. Tables are CSV. Lines with `#` at their start state
version, case and warnings; the heading with units in brackets follows. The last line with `#`, `# columns: ...`, states the kind
of each column, so that a program finds a joint, a probe or a dimension without reading headings:

```
# columns: time, probe_temperature, joint_temperature, joint_heat
time [s],upright [degC],crank_pin temperature [degC],crank_pin heat [W]
```

In JSON files `/` separates the names of nested values, and `[]` stands for every entry of a list. The unit `{{unit}}` is stated
beside the value. Values that a case does not have are left out; `null` is a figure that does not exist. Heat is that of the
whole press, unless the table says otherwise.

## Files

| file | written by | contents |
|---|---|---|
)";

std::string text_cell(const std::string& text)
{
    std::string cell;
    for (const char c : text) {
        cell += c == '|' ? std::string("\\|") : std::string(1, c);
    }
    return cell;
}

std::string section(const File& file)
{
    std::string text = fmt::format("\n## {}\n\nWritten by `{}`: {}.\n\n", file.name, file.written_by, file.meaning);
    if (!file.columns.empty()) {
        text += "| column | unit | kind | meaning |\n|---|---|---|---|\n";
    }
    for (const auto& column : file.columns) {
        text += fmt::format("| `{}` | {} | `{}` | {} |\n", column.heading, column.unit, column.kind, column.meaning);
    }
    if (!file.keys.empty()) {
        text += "| key | unit | meaning |\n|---|---|---|\n";
    }
    for (const auto& key : file.keys) {
        text += fmt::format("| `{}` | {} | {} |\n", key.path, key.unit, text_cell(key.meaning));
    }
    return text;
}

}  // namespace

std::string page()
{
    std::string text = fmt::format(fmt::runtime(introduction), result_format);
    for (const auto& file : files()) {
        text += fmt::format("| `{}` | {} | {} |\n", file.name, file.written_by, file.meaning);
    }
    text += "\nDimensions of the chain, changes since the start at bottom dead point:\n\n| dimension | change of "
            "|\n|---|---|\n";
    for (const auto& dimension : dimensions()) {
        text += fmt::format("| `{}` | {} |\n", dimension.name, dimension.meaning);
    }
    for (const auto& file : files()) {
        if (!file.columns.empty() || !file.keys.empty()) {
            text += section(file);
        }
    }
    return text;
}

std::string script_json()
{
    nlohmann::ordered_json json;
    for (const auto& file : files()) {
        for (const auto& column : file.columns) {
            json["columns"][file.name][std::string(column.kind)] = std::string(column.heading);
        }
    }
    for (const auto& dimension : dimensions()) {
        json["dimensions"][dimension.name] = dimension.meaning;
    }
    return json.dump();
}

}  // namespace deadpoint::report::schema
