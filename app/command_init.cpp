#include "commands.hpp"
#include "console.hpp"
#include "deadpoint/casefile/files/shipped.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/draft/draft.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "deadpoint/report/schema/input_schema.hpp"
#include "output.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace {

struct InitOptions {
    std::string folder;
    std::string step;
    std::vector<std::string> bodies;  ///< "name=solid,solid"
};

/// What init has made so far; removed with the object unless all of it is there.
class NewFiles {
public:
    NewFiles() = default;
    ~NewFiles()
    {
        std::error_code ignored;  // a folder that holds something else stays
        for (auto made = made_.rbegin(); made != made_.rend(); ++made) {
            fs::remove(*made, ignored);
        }
    }
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;

    /// Makes a folder and those above it that are missing. @throws IoError
    void create(const fs::path& folder)
    {
        std::error_code error;
        fs::path above;
        for (const auto& name : fs::absolute(folder)) {
            above /= name;
            if (fs::create_directory(above, error)) {
                made_.push_back(above);
            }
        }
        if (error) {
            throw deadpoint::IoError(
                fmt::format("cannot create the folder '{}': {}\n  help: name a folder you may write to",
                            folder.string(), error.message()));
        }
    }
    /// @throws IoError as write_file()
    void write(const fs::path& file, std::string_view text)
    {
        deadpoint::write_file(file, text, deadpoint::IfThere::refuse);
        made_.push_back(file);
    }
    /// @throws IoError
    void copy(const fs::path& from, const fs::path& to)
    {
        std::error_code error;
        fs::copy_file(from, to, fs::copy_options::none, error);
        if (error != std::errc::file_exists) {
            made_.push_back(to);
        }
        if (error) {
            throw deadpoint::IoError(
                fmt::format("cannot copy '{}' to '{}': {}\n  help: name a new folder, or remove that file",
                            from.string(), to.string(), error.message()));
        }
    }
    void keep() { made_.clear(); }

private:
    std::vector<fs::path> made_;
};

void say_next(const fs::path& file)
{
    print_out("wrote {}\n  look at it:  deadpoint check {}\n  compute it:  deadpoint run {} -o {}\n", file.string(),
              file.string(), file.string(), (file.parent_path() / "results").string());
}

constexpr const char* schema_name = "case.schema.json";

/// @throws IoError if a case is there
void refuse_existing(const fs::path& file)
{
    if (fs::exists(fs::symlink_status(file))) {
        throw deadpoint::IoError(
            fmt::format("'{}' exists already and is not overwritten\n  help: name another folder", file.string()));
    }
}

/// Writes the case, which begins with the line that tells editors its schema, and the schema beside it, unless it is
/// there.
void write_case(const fs::path& file, std::string_view text, NewFiles& files)
{
    const auto schema = deadpoint::report::schema::input_schema("case");
    const auto beside = file.parent_path() / schema_name;
    files.write(file, fmt::format("#:schema ./{}\n{}", schema_name, text));
    if (deadpoint::read_file(beside, deadpoint::largest_result) != schema) {
        files.write(beside, schema);
    }
}

void write_starter(const fs::path& folder)
{
    NewFiles files;
    const fs::path file = folder / "case.toml";
    refuse_existing(file);
    files.create(folder);
    write_case(file, deadpoint::casefile::starter_case(), files);
    files.keep();
    say_next(file);
}

/// The name of a drawing in the folder of its case. A case names files in one printable line.
std::string name_beside_case(const fs::path& drawing)
{
    auto name = deadpoint::masked(drawing.filename().string());
    constexpr std::string_view mark = "\xEF\xBF\xBD";  // of masked()
    for (auto at = name.find(mark); at != std::string::npos; at = name.find(mark)) {
        name.replace(at, mark.size(), "_");
    }
    std::ranges::replace(name, '\t', '_');
    return name;
}

/// A case holds its files: the drawing goes into its folder, unless it is there.
void copy_into(const fs::path& drawing, const fs::path& copy, NewFiles& files)
{
    std::error_code unknown;
    if (!fs::equivalent(drawing, copy, unknown)) {
        files.copy(drawing, copy);
    }
}

void say_what_was_found(const deadpoint::full::Draft& draft)
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
            names += (names.empty() ? "" : ", ") + name_in_case(draft.model.solids[i]);
        }
        print_out("  {}: {}\n", body.name, names);
    }
    for (const auto& joint : draft.joints) {
        if (joint.kind == deadpoint::full::DraftJoint::Kind::ball) {
            print_out("  joint {} is a ball, whose spherical faces make no contact: see its TO DO in the case\n",
                      joint.name);
        }
    }
    for (const auto& doubt : deadpoint::full::doubts_about(draft)) {
        print_out("{}.\n", doubt);
    }
    print_out("Is a solid in the wrong body? Begin again in another folder with --body NAME=SOLID,SOLID.\n"
              "Lines with TO DO in the case hold guesses.\n");
}

/// "name=solid,solid" @throws InputError
deadpoint::full::WantedBody wanted_body(const std::string& text)
{
    constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    const auto equals = text.find('=');
    deadpoint::full::WantedBody body{text.substr(0, equals), {}};
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

/// Reading and comparing solids takes a minute for hundreds of them, so it tells how far it is.
deadpoint::full::Draft draft_from(const fs::path& drawing, const std::vector<deadpoint::full::WantedBody>& wanted)
{
    Console console({});
    console.stage("drawing");
    auto model =
        deadpoint::machine::read_cad(drawing.stem().string(), drawing.string(), std::nullopt, [&](double seconds) {
            console.progress(0, fmt::format("reading solids and finding where they touch, {:.0f} s", seconds));
        });
    console.stage("bodies and joints");
    return deadpoint::full::draft_of(std::move(model), wanted);
}

void write_draft(const InitOptions& options)
{
    std::vector<deadpoint::full::WantedBody> wanted;
    for (const auto& text : options.bodies) {
        wanted.push_back(wanted_body(text));
    }
    const fs::path folder = options.folder;
    const fs::path file = folder / "case.toml";
    refuse_existing(file);
    const fs::path drawing = options.step;
    if (!fs::exists(drawing)) {
        const bool of_windows = options.step.find('\\') != std::string::npos;
        throw deadpoint::IoError(fmt::format("--step: there is no file '{}'\n  help: {}", options.step,
                                             of_windows
                                                 ? "write its path with / instead of \\"
                                                 : "check its path, which is relative to the folder you are in"));
    }
    const auto draft = draft_from(drawing, wanted);
    const auto name = name_beside_case(drawing);
    NewFiles files;
    files.create(folder);
    copy_into(drawing, folder / name, files);
    write_case(file, deadpoint::full::draft_text(draft, name), files);
    files.keep();
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
