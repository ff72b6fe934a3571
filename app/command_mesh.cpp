#include "case_options.hpp"
#include "commands.hpp"
#include "deadpoint/report/mesh_files.hpp"
#include "deadpoint/report/plan_text.hpp"
#include "deadpoint/report/result_folder.hpp"

#include <fmt/format.h>
#include <memory>

namespace {

struct MeshOptions : CaseOptions {
    std::string folder;
    bool force = false;
};

void write_mesh(const MeshOptions& options)
{
    using deadpoint::report::ResultFolder;
    Console console(options.console);
    const auto description = read_case(options, console);
    ResultFolder folder(options.folder,
                        options.force ? ResultFolder::IfExists::replace : ResultFolder::IfExists::refuse);
    const auto machine = mesh_case(description, options, console);
    for (const auto& warning : deadpoint::report::plan_warnings(description, machine)) {
        console.warn(warning);
    }
    deadpoint::report::write_mesh_files(folder.path(), machine, file_comments(description, console));
    folder.commit();
    fmt::print("{} cells, {} exterior faces; open {} and {} in ParaView\n", machine.cells.size(), machine.faces.size(),
               (folder.target() / "mesh.vtu").string(), (folder.target() / "surfaces.vtu").string());
}

}  // namespace

void add_mesh(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("mesh", "mesh the machine of a case and write it for ParaView");
    const auto options = std::make_shared<MeshOptions>();
    add_case_options(*command, *options);
    command->add_option("-o,--output", options->folder, "the folder to write into; it must not exist")
        ->required()
        ->type_name("DIR");
    command->add_flag("--force", options->force, "replace the folder if it exists");
    command->callback([options, &exit_code] {
        write_mesh(*options);
        exit_code = 0;
    });
}
