#include "commands.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/mesh/calculix_deck.hpp"
#include "deadpoint/report/mesh/calculix_mesh.hpp"
#include "deadpoint/report/mesh/mesh_files.hpp"
#include "deadpoint/report/probe/node_temperatures.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>

using namespace deadpoint;

namespace {

struct MeshOptions : ResultOptions {
    bool calculix = false;
    std::string temperatures;  ///< result folder whose last field is written
};

/// Without a run, all parts are 10 K warmer than at the start.
constexpr double trial_rise = 10;

void write_calculix(const MeshOptions& options, const std::filesystem::path& folder, const casefile::Case& input,
                    const Machine& machine, std::vector<std::string> comments)
{
    report::write_calculix_mesh(folder / "mesh.inp", machine, comments);
    std::vector<double> temperatures(machine.nodes.size(),
                                     input.machine.initial_temperature - zero_celsius + trial_rise);
    comments.push_back(fmt::format("all nodes {:g} K above the start: no --temperatures were given", trial_rise));
    if (!options.temperatures.empty()) {
        temperatures = report::node_temperatures(report::ResultFiles(options.temperatures), machine);
        comments.back() = fmt::format("temperatures at the end of {}", options.temperatures);
    }
    report::write_calculix_deck(folder / "deformation.inp", machine, input, temperatures, "mesh.inp", comments);
}

void write_mesh(const MeshOptions& options)
{
    Console console(options.console);
    const auto read = read_case(options, console);
    const auto& description = read.value;
    const auto folder = start_folder(options, read, console);
    full::Press press(description, options.size_scale);
    const auto& machine = mesh_parts(press, console);
    console.stage("files");
    report::write_mesh_files(folder->path(), machine, file_comments(description, console));
    const bool calculix = options.calculix || !options.temperatures.empty();
    if (calculix) {
        write_calculix(options, folder->path(), description, machine, file_comments(description, console));
    }
    commit(*folder, options.tables, console);
    console.finish();
    print_out("{} cells, {} exterior faces; open {} and {} in ParaView\n", machine.cells.size(), machine.faces.size(),
              (folder->target() / "mesh.vtu").string(), (folder->target() / "surfaces.vtu").string());
    if (calculix) {
        print_out("a second opinion on the deformation:  cd {} && ccx deformation\n", folder->target().string());
    }
}

}  // namespace

void add_mesh(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("mesh", "mesh the machine of a case and write it for ParaView");
    const auto options = std::make_shared<MeshOptions>();
    add_result_options(*command, *options);
    command->add_flag("--calculix", options->calculix,
                      "also write mesh.inp for CalculiX or Abaqus (nodes, elements, surfaces) and deformation.inp "
                      "(materials, ties, supports, temperatures)");
    command
        ->add_option("--temperatures", options->temperatures,
                     "a result folder on the same mesh, whose last field is written with --calculix; else 10 K more "
                     "than at the start everywhere")
        ->type_name("DIR");
    command->callback([options, &exit_code] {
        write_mesh(*options);
        exit_code = 0;
    });
}
