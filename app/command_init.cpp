#include "commands.hpp"
#include "deadpoint/casefile/files/shipped.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "deadpoint/report/schema/input_schema.hpp"
#include "deadpoint/study/draft/draft.hpp"
#include "output.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <string_view>

namespace fs = std::filesystem;

namespace {

struct InitOptions {
    std::string folder;
    std::string step;
};

void create(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw deadpoint::IoError(
            fmt::format("cannot create the folder '{}': {}\n  help: name a folder you may write to", folder.string(),
                        error.message()));
    }
}

void say_next(const fs::path& file)
{
    print_out("wrote {}\n  look at it:  deadpoint check {}\n  compute it:  deadpoint run {} -o {}\n", file.string(),
              file.string(), file.string(), (file.parent_path() / "results").string());
}

/// Writes the case, which begins with the line that tells editors its schema, and the schema beside it.
void write_case(const fs::path& file, std::string_view text)
{
    constexpr const char* schema = "case.schema.json";
    deadpoint::write_file(file, fmt::format("#:schema ./{}\n{}", schema, text), deadpoint::IfThere::refuse);
    deadpoint::write_file(file.parent_path() / schema, deadpoint::report::schema::input_schema("case"));
}

void write_starter(const fs::path& folder)
{
    create(folder);
    const fs::path file = folder / "case.toml";
    write_case(file, deadpoint::casefile::starter_case());
    say_next(file);
}

/// A case holds its files: the drawing goes into its folder, unless it is there.
void copy_into(const fs::path& drawing, const fs::path& copy)
{
    std::error_code unknown;
    if (fs::equivalent(drawing, copy, unknown)) {
        return;
    }
    std::error_code error;
    fs::copy_file(drawing, copy, fs::copy_options::none, error);
    if (error) {
        throw deadpoint::IoError(
            fmt::format("cannot copy '{}' to '{}': {}\n  help: name a new folder, or remove that file",
                        drawing.string(), copy.string(), error.message()));
    }
}

void say_what_was_found(const deadpoint::study::Draft& draft)
{
    const auto in_joints = [&] {
        std::size_t sum = 0;
        for (const auto& joint : draft.joints) {
            sum += joint.contacts.size();
        }
        return sum;
    };
    const auto some = [](std::size_t count, const char* one, const char* more) {
        return fmt::format("{} {}", count, count == 1 ? one : more);
    };
    print_out("{} in {}, {}: {} of them in {}\n", some(draft.model.solids.size(), "solid", "solids"),
              some(draft.bodies.size(), "body", "bodies"), some(draft.contacts.size(), "contact", "contacts"),
              in_joints(), some(draft.joints.size(), "joint", "joints"));
    for (const auto& body : draft.bodies) {
        std::string names;
        for (const std::size_t i : body.solids) {
            names += (names.empty() ? "" : ", ") + draft.model.solids[i].name;
        }
        print_out("  {}: {}\n", body.name, names);
    }
    print_out("Lines with TO DO in the case hold guesses.\n");
}

void write_draft(const InitOptions& options)
{
    const fs::path folder = options.folder;
    const fs::path file = folder / "case.toml";
    if (fs::exists(file)) {
        throw deadpoint::IoError(fmt::format("'{}' is there already\n  help: name another folder", file.string()));
    }
    const fs::path drawing = options.step;
    const auto draft = deadpoint::study::draft_of(
        deadpoint::machine::read_cad(drawing.stem().string(), drawing.string(), std::nullopt, [](double) {}));
    create(folder);
    copy_into(drawing, folder / drawing.filename());
    write_case(file, deadpoint::study::draft_text(draft, drawing.filename().string()));
    say_what_was_found(draft);
    say_next(file);
}

}  // namespace

void add_init(CLI::App& app, int& exit_code)
{
    auto* command = app.add_subcommand("init", "write a commented case file to start from");
    const auto options = std::make_shared<InitOptions>();
    command->add_option("DIR", options->folder, "the folder to write case.toml into; created if missing")->required();
    command->add_option("--step", options->step,
                        "a STEP file: the case gets its solids as parts, and bodies and joints from what touches");
    command->callback([options, &exit_code] {
        options->step.empty() ? write_starter(options->folder) : write_draft(*options);
        exit_code = 0;
    });
}
