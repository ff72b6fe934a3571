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
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct InitOptions {
    std::string folder;
    std::string step;
    std::vector<std::string> bodies;  ///< "name=solid,solid"
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
    for (const auto& joint : draft.joints) {
        if (joint.kind == deadpoint::study::DraftJoint::Kind::ball) {
            print_out("  joint {} is a ball, whose spherical faces make no contact: see its TO DO in the case\n",
                      joint.name);
        }
    }
    for (const auto& doubt : deadpoint::study::doubts_about(draft)) {
        print_out("{}.\n", doubt);
    }
    print_out("Is a solid in the wrong body? Begin again in another folder with --body NAME=SOLID,SOLID.\n"
              "Lines with TO DO in the case hold guesses.\n");
}

/// "name=solid,solid" @throws InputError
deadpoint::study::WantedBody wanted_body(const std::string& text)
{
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    const auto equals = text.find('=');
    deadpoint::study::WantedBody body{text.substr(0, equals), {}};
    std::istringstream solids(equals == std::string::npos ? "" : text.substr(equals + 1));
    for (std::string solid; std::getline(solids, solid, ',');) {
        body.solids.push_back(solid);
    }
    if (body.name.empty() || body.name.find_first_not_of(letters) != std::string::npos || body.solids.empty()) {
        throw deadpoint::InputError(fmt::format("--body '{}' is not a body with its solids\n  help: write it like "
                                                "--body slide=ram,wrist_pin,upper_die*",
                                                text));
    }
    return body;
}

void write_draft(const InitOptions& options)
{
    std::vector<deadpoint::study::WantedBody> wanted;
    for (const auto& text : options.bodies) {
        wanted.push_back(wanted_body(text));
    }
    const fs::path folder = options.folder;
    const fs::path file = folder / "case.toml";
    if (fs::exists(file)) {
        throw deadpoint::IoError(fmt::format("'{}' is there already\n  help: name another folder", file.string()));
    }
    const fs::path drawing = options.step;
    if (!fs::exists(drawing)) {
        const bool of_windows = options.step.find('\\') != std::string::npos;
        throw deadpoint::IoError(fmt::format("--step: there is no file '{}'\n  help: {}", options.step,
                                             of_windows
                                                 ? "write its path with / instead of \\"
                                                 : "check its path, which is relative to the folder you are in"));
    }
    const auto draft = deadpoint::study::draft_of(
        deadpoint::machine::read_cad(drawing.stem().string(), drawing.string(), std::nullopt, [](double) {}), wanted);
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
    auto* step =
        command->add_option("--step", options->step,
                            "a STEP file: the case gets its solids as parts, and bodies and joints from what touches");
    command
        ->add_option("--body", options->bodies,
                     "with --step: puts solids into one body, 'slide=ram,wrist_pin,upper_die*'; may be repeated")
        ->type_name("NAME=SOLIDS")
        ->allow_extra_args(false)
        ->needs(step);
    command->callback([options, &exit_code] {
        options->step.empty() ? write_starter(options->folder) : write_draft(*options);
        exit_code = 0;
    });
}
