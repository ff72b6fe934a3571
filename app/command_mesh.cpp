#include "commands.hpp"
#include "deadpoint/report/files/calculix_mesh.hpp"
#include "deadpoint/report/files/mesh_files.hpp"
#include "deadpoint/report/text/plan_text.hpp"
#include "options/result_options.hpp"
#include "output.hpp"

#include <memory>

using namespace deadpoint;

namespace {

void write_mesh(const ResultOptions& options, bool calculix)
{
    Console console(options.console);
    const auto read = read_case(options, console);
    const auto& description = read.value;
    const auto folder = start_folder(options, read, console);
    study::Press press(description, options.size_scale);
    const auto& machine = mesh_parts(press, console);
    for (const auto& warning : report::plan_warnings(description, machine)) {
        console.warn(warning);
    }
    report::write_mesh_files(folder->path(), machine, file_comments(description, console));
    if (calculix) {
        report::write_calculix_mesh(folder->path() / "mesh.inp", machine, file_comments(description, console));
    }
    commit(*folder, options.tables, console);
    print_out("{} cells, {} exterior faces; open {} and {} in ParaView\n", machine.cells.size(), machine.faces.size(),
              (folder->target() / "mesh.vtu").string(), (folder->target() / "surfaces.vtu").string());
}

}  // namespace

void add_mesh(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("mesh", "mesh the machine of a case and write it for ParaView");
    const auto options = std::make_shared<ResultOptions>();
    add_result_options(*command, *options);
    const auto calculix = std::make_shared<bool>(false);
    command->add_flag("--calculix", *calculix, "also write mesh.inp for CalculiX or Abaqus: nodes, elements, surfaces");
    command->callback([options, calculix, &exit_code] {
        write_mesh(*options, *calculix);
        exit_code = 0;
    });
}
