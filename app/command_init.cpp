#include "commands.hpp"
#include "deadpoint/casefile/files/shipped.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/write_file.hpp"
#include "output.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace fs = std::filesystem;

namespace {

void write_starter(const fs::path& folder)
{
    const fs::path file = folder / "case.toml";
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw deadpoint::IoError(
            fmt::format("cannot create the folder '{}': {}\n  help: name a folder you may write to", folder.string(),
                        error.message()));
    }
    deadpoint::write_file(file, deadpoint::casefile::starter_case(), deadpoint::IfThere::refuse);
    print_out("wrote {}\n  look at it:  deadpoint check {}\n  compute it:  deadpoint run {} -o {}\n", file.string(),
              file.string(), file.string(), (folder / "results").string());
}

}  // namespace

void add_init(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("init", "write a commented case file to start from");
    const auto folder = std::make_shared<std::string>();
    command->add_option("DIR", *folder, "the folder to write case.toml into; created if missing")->required();
    command->callback([folder, &exit_code] {
        write_starter(*folder);
        exit_code = 0;
    });
}
