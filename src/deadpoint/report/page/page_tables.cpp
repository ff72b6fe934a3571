#include "deadpoint/report/page/page_tables.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/io/csv_table.hpp"
#include "deadpoint/report/tables/table.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <utility>
#include <vector>

namespace deadpoint::report {
namespace {

using Json = nlohmann::ordered_json;

std::string html_row(const std::vector<std::string>& cells, bool heading)
{
    std::string row = "<tr>";
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const char* tag = heading || i == 0 ? "th" : "td";
        row += fmt::format("<{} {}>{}</{}>", tag,
                           heading  ? "scope=\"col\""
                           : i == 0 ? "scope=\"row\""
                                    : "",
                           xml_text(cells[i]), tag);
    }
    return row + "</tr>\n";
}

std::string html_table(const std::string& caption, const std::vector<std::string>& titles,
                       const std::vector<std::vector<std::string>>& rows)
{
    if (rows.empty())
        return {};
    std::string text = fmt::format("<div class=\"wide\"><table>\n<caption>{}</caption>\n<thead>{}</thead>\n<tbody>\n",
                                   xml_text(caption), html_row(titles, true));
    for (const auto& row : rows)
        text += html_row(row, false);
    return text + "</tbody></table></div>\n";
}

std::string signed_number(const Json& json, int decimals)
{
    return json.is_number() ? fmt::format("{:+.{}f}", json.get<double>(), decimals) : std::string("-");
}

std::string gap_table(const Json& drift)
{
    std::vector<std::vector<std::string>> rows{
        {"E_SW, largest, after " + duration_text(drift.value("time_of_largest_s", 0.0)),
         signed_number(drift.value("largest_E_SW", Json()), 1)}};
    const auto last = drift.value("final", Json::object());
    for (const auto& [name, value] : last.items())
        rows.push_back({name + " at the end", signed_number(value, 1)});
    return html_table("The gap between slide and table: changes since the start, + opens", {"", "um"}, rows);
}

std::string gaps_tables(const Json& gaps)
{
    std::vector<std::vector<std::string>> corners, clearances;
    const auto parallel = gaps.value("parallelism", Json::object()).value("corners", Json::object());
    for (const auto& [name, corner] : parallel.items())
        corners.push_back({name, signed_number(corner.value("largest_um", Json()), 1),
                           signed_number(corner.value("final_um", Json()), 1)});
    for (const auto& entry : gaps.value("clearances", Json::array()))
        clearances.push_back({entry.value("name", ""), signed_number(entry.value("least_change_um", Json()), 1),
                              signed_number(entry.value("final_change_um", Json()), 1)});
    return html_table("Gap at the corners of the slide", {"corner", "largest [um]", "at the end [um]"}, corners) +
           html_table("Clearances: changes since the start, - closes", {"", "closes most [um]", "at the end [um]"},
                      clearances);
}

std::string warnings_list(const Json& warnings)
{
    if (!warnings.is_array() || warnings.empty())
        return "<p>There are no warnings.</p>\n";
    std::string text = "<ul class=\"warnings\">\n";
    for (const auto& warning : warnings)
        text += "<li>" + xml_text(warning.get<std::string>()) + "</li>\n";
    return text + "</ul>\n";
}

std::string cite(const std::string& version, const std::string& what)
{
    return fmt::format("<p>Cite as: deadpoint {}, thermal drift of mechanical presses at bottom dead point; {}.</p>\n",
                       xml_text(version), xml_text(what));
}

}  // namespace

std::string run_tables(const Json& run)
{
    const auto& facts = run.contains("summary") ? run.at("summary") : run.at("loads");
    const auto machine = facts.value("case", Json::object());
    const auto hash = machine.value("hash", "-");
    std::string text = fmt::format("<h2>{}</h2>\n<p>deadpoint {}, case hash {}</p>\n",
                                   xml_text(machine.value("name", run.value("name", ""))),
                                   xml_text(facts.value("version", "-")), xml_text(hash));
    if (facts.contains("drift_um"))
        text += gap_table(facts.at("drift_um"));
    if (facts.contains("gaps"))
        text += gaps_tables(facts.at("gaps"));
    std::vector<std::vector<std::string>> rises;
    if (facts.contains("probe_rises_K") && facts.at("probe_rises_K").is_object())
        for (const auto& [probe, rise] : facts.at("probe_rises_K").items())
            rises.push_back({probe, signed_number(rise.value("end", Json()), 2)});
    text += html_table("Rises of the probes at the end", {"probe", "K"}, rises);
    std::vector<std::vector<std::string>> heat;
    const auto energy = facts.value("energy_J", Json::object());
    for (const auto& [key, name] : {std::pair{"generated", "generated"},
                                    {"to_air", "to the air"},
                                    {"to_oil", "to the oil"},
                                    {"stored", "stored"}})
        if (energy.contains(key) && energy.at(key).is_number())
            heat.push_back({name, fmt::format("{:.3g}", megajoule * energy.at(key).get<double>())});
    text += html_table("Heat over the run, whole press", {"", "MJ"}, heat);
    text += "<h3>Warnings</h3>\n" + warnings_list(facts.value("warnings", Json::array()));
    return text +
           cite(facts.value("version", "-"), fmt::format("case \"{}\", hash {}", machine.value("name", ""), hash));
}

std::string table_html(const std::string& caption, const CsvTable& table)
{
    std::vector<std::string> titles;
    for (const auto& column : table.columns)
        titles.push_back(column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit));
    auto rows = table.rows;
    for (auto& row : rows)
        for (auto& cell : row) {
            char* end = nullptr;
            const double value = std::strtod(cell.c_str(), &end);
            if (!cell.empty() && *end == '\0')
                cell = significant(value, 5);
        }
    return html_table(caption, titles, rows);
}

std::string sweep_tables(const Json& sweep, const CsvTable& points)
{
    const auto study = sweep.value("study", Json::object());
    const auto version = sweep.value("version", "-");
    std::string text =
        fmt::format("<p>deadpoint {}, base case {}</p>\n", xml_text(version), xml_text(study.value("base", "-")));
    std::vector<std::vector<std::string>> windows;
    for (const auto& set : sweep.value("sets", Json::array()))
        if (set.contains("window") && set.at("window").is_object())
            windows.push_back({set.value("name", ""), set.at("window").value("text", "")});
    text += html_table("Best windows", {"set", "window"}, windows);
    text += table_html("All points", points);
    text += "<h3>Warnings</h3>\n" + warnings_list(sweep.value("warnings", Json::array()));
    return text + cite(version, fmt::format("study \"{}\"", study.value("name", "")));
}

}  // namespace deadpoint::report
