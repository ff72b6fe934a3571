#include "deadpoint/report/folder/read_result.hpp"

#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/press/run/run_record.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/folder/result_json.hpp"
#include "deadpoint/report/folder/result_table.hpp"
#include "deadpoint/report/schema/columns.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace deadpoint::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

template <class Content>
Content needed(std::optional<Content> content, const fs::path& path)
{
    if (!content) {
        throw IoError(
            fmt::format("there is no '{}'\n  help: name a folder that 'deadpoint run' has written", path.string()));
    }
    return *std::move(content);
}

/// Checks that time increases from row to row. The checksum shows only that rows are as written.
void require_course(const CsvTable& table, const std::vector<double>& time)
{
    if (time.empty()) {
        throw InputError(fmt::format("{}: there are no rows\n  help: compute the case again", table.file));
    }
    const auto back = std::ranges::adjacent_find(time, [](double now, double next) { return !(now < next); });
    if (back != time.end()) {
        throw InputError(fmt::format("{}:{}: the time does not increase\n  help: compute the case again", table.file,
                                     table.lines[static_cast<std::size_t>(back - time.begin()) + 1]));
    }
}

/// Every number below a value, by the names and indices that lead to it with points between.
void flatten(const Json& json, const std::string& path, std::map<std::string, double>& numbers)
{
    const auto below = [&](const std::string& step) { return path.empty() ? step : path + "." + step; };
    if (json.is_number()) {
        numbers[path] = json.get<double>();
    } else if (json.is_object()) {
        for (const auto& [name, value] : json.items()) {
            flatten(value, below(name), numbers);
        }
    } else if (json.is_array()) {
        for (std::size_t i = 0; i < json.size(); ++i) {
            flatten(json[i], below(std::to_string(i)), numbers);
        }
    }
}

void read_summary(const Json& json, press::RunRecord& run)
{
    run.machine = one_line(json.at("case").at("name").get<std::string>());
    run.hash = json.at("case").at("hash").get<std::string>();
    run.interrupted = json.at("interrupted").get<bool>();
    run.initial_temperature = json.at("initial_temperature_degC").get<double>() + zero_celsius;
    // A case without probes has null here.
    for (const auto& [probe, rises] : json.at("probe_rises_K").items()) {
        run.probes.push_back(probe);
    }
    if (const Json::json_pointer gap("/drift_summary/E_SW"); json.contains(gap)) {
        const auto& course = json.at(gap);
        run.gap = press::GapFigures{course.at("first_hour").at("change_um").get<double>() / micrometre,
                                    course.at("range_um").get<double>() / micrometre, std::nullopt};
        if (const auto& steady = course.at("steady_from_s"); steady.is_number()) {
            run.gap->steady_from = steady.get<double>();
        }
    }
    if (!json.contains("reference")) {
        return;
    }
    const auto& reference = json.at("reference");
    run.calibrated_on = reference.at("calibrated_on").get<std::vector<std::string>>();
    run.calibrated_time = reference.at("time_s").get<double>();
    if (reference.contains("rises_K")) {
        for (const auto& [probe, rise] : reference.at("rises_K").items()) {
            run.calibrated_probes.push_back(probe);
        }
    }
}

std::vector<double> scaled_then_shifted(std::vector<double> values, double factor, double offset)
{
    for (double& value : values) {
        value = factor * value + offset;
    }
    return values;
}

void read_history(const ResultTable& table, press::RunRecord& run)
{
    namespace history = schema::history;
    run.time = table.numbers(schema::time);
    require_course(table.csv(), run.time);
    for (const auto& probe : run.probes) {
        run.rises[probe] =
            scaled_then_shifted(table.numbers(history::probe, probe), 1, zero_celsius - run.initial_temperature);
    }
    for (const auto& joint : table.names(history::joint_heat)) {
        run.joint_heat[joint] = table.numbers(history::joint_heat, joint);
    }
    for (const auto& dimension : table.names(history::dimension)) {
        run.chain[dimension] = scaled_then_shifted(table.numbers(history::dimension, dimension), 1 / micrometre, 0);
    }
}

}  // namespace

press::RunRecord read_result(const fs::path& folder)
{
    const ResultFiles files(folder);
    press::RunRecord run;
    run.folder = folder.string();
    const fs::path summary = folder / "summary.json";
    try {
        read_summary(needed(read_json(files, "summary.json"), summary), run);
    } catch (const Json::exception&) {
        throw InputError(fmt::format("{}: a figure is missing or of another kind\n  help: it is from another version "
                                     "of the program; compute the case again",
                                     summary.string()));
    }
    const fs::path history = folder / "history.csv";
    read_history(ResultTable(needed(files.read("history.csv"), history), history.string()), run);
    if (const auto loads = read_json(files, "loads.json")) {
        run.has_loads = true;
        flatten(*loads, "", run.loads);
    }
    return run;
}

}  // namespace deadpoint::report
