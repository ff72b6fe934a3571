#include "commands.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/core/version.hpp"
#include "deadpoint/fem/algebra/product_kernels.hpp"
#include "errors.hpp"
#include "interrupt.hpp"
#include "manual.hpp"
#include "options/examples.hpp"
#include "output.hpp"
#include "ranks/places.hpp"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

const std::vector<std::string> subcommands{"init",   "check",  "mesh",        "loads",    "heat",      "run",
                                           "reduce", "sweep",  "sensitivity", "optimise", "calibrate", "compare",
                                           "probe",  "report", "schema",      "view"};

/// Says that a word is no subcommand, and which one it may have meant.
int refuse_subcommand(const std::string& word)
{
    const auto meant = deadpoint::closest_name(word, subcommands);
    print_err("error: there is no subcommand '{}'\n  help: {}\n", word,
              meant.empty()
                  ? "give one of init, check, mesh, loads, heat, run, reduce, sweep, sensitivity, optimise, calibrate, "
                    "compare, probe, report, schema and view"
                  : fmt::format("did you mean '{}'?", meant));
    return static_cast<int>(deadpoint::ErrorKind::input);
}

/// Words that begin with "--" and are no option of a subcommand; the first of them, or nothing.
std::optional<std::string> unknown_option(const CLI::App& command, int argc, char** argv)
{
    for (int i = 2; i < argc; ++i) {
        const std::string word(argv[i]);
        const auto name = word.substr(0, word.find('='));
        if (word == "--") {
            return std::nullopt;
        }
        if (name.starts_with("--") && command.get_option_no_throw(name) == nullptr) {
            return name;
        }
    }
    return std::nullopt;
}

/// CLI11's message in words for a user, where its own are those of its options' types.
std::string said_plainly(const CLI::ParseError& error)
{
    const std::string text = error.what(), kind = error.get_name();
    const auto after = [&](std::string_view mark) { return text.substr(text.find(mark) + mark.size()); };
    if (kind == "ArgumentMismatch" && text.find(": ") != std::string::npos) {
        return fmt::format("{} needs a value", text.substr(0, text.find(": ")));
    }
    if (kind == "ConversionError" && text.find(" = ") != std::string::npos) {
        const auto option = after(": ");
        return fmt::format("'{}' is no value that {} takes", after(" = "), option.substr(0, option.find(" = ")));
    }
    if (kind == "RequiredError" && text.ends_with(" is required")) {
        return fmt::format("{} is missing", text.substr(0, text.find(" is required")));
    }
    if (kind == "ValidationError" && text.find(": Value ") != std::string::npos &&
        text.find(" not in range ") != std::string::npos) {
        const auto value = after(": Value ");
        return fmt::format("'{}' is no value that {} takes, which lies between {}",
                           value.substr(0, value.find(" not in range ")), text.substr(0, text.find(": ")),
                           after(" not in range ").replace(after(" not in range ").find(" to "), 4, " and "));
    }
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && text.find(": ") != std::string::npos) {
        return fmt::format("there is no room for '{}' in this command", after(": "));
    }
    if (kind == "ExcludesError" && text.find(" excludes ") != std::string::npos) {
        return fmt::format("{} and {} exclude each other", text.substr(0, text.find(" excludes ")),
                           after(" excludes "));
    }
    if (kind == "RequiresError" && text.find(" requires ") != std::string::npos) {
        return fmt::format("{} works with {} only", text.substr(0, text.find(" requires ")), after(" requires "));
    }
    return text;
}

/// Says what is wrong with the words of the command line, and where to read on.
int refuse_arguments(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv)
{
    const auto used = app.get_subcommands();
    if (used.empty()) {
        print_err("error: {}\n  help: begin with `deadpoint init DIR`; `deadpoint --help` lists all subcommands\n",
                  argc < 2 ? "a subcommand is missing" : error.what());
        return static_cast<int>(deadpoint::ErrorKind::input);
    }
    const auto& command = *used.front();
    std::string what = said_plainly(error);
    std::string help = fmt::format("`deadpoint {} --help` shows its arguments and examples", command.get_name());
    if (const auto unknown = unknown_option(command, argc, argv)) {
        std::vector<std::string> known;
        for (const auto* option : command.get_options()) {
            known.push_back("--" + (option->get_lnames().empty() ? std::string{} : option->get_lnames().front()));
        }
        const auto longer = std::ranges::find_if(known, [&](const auto& name) { return name.starts_with(*unknown); });
        const auto meant = longer != known.end() ? *longer : deadpoint::closest_name(*unknown, known);
        what = fmt::format("there is no option '{}' of '{}'", *unknown, command.get_name());
        help = meant.empty() ? help : fmt::format("did you mean '{}'? {}", meant, help);
    } else if (what == "--output is missing") {
        what = "-o is missing, the name for what is written";
        help = fmt::format("add it, like -o results; {}", help);
    }
    print_err("error: {}\n  help: {}\n", what, help);
    return static_cast<int>(deadpoint::ErrorKind::input);
}

int run(int argc, char** argv)
{
    CLI::App app("deadpoint: thermal drift of a mechanical press at bottom dead point", "deadpoint");
    app.set_version_flag("--version", fmt::format("deadpoint {}", deadpoint::version));
    app.require_subcommand(1);
    int exit_code = 0;
    add_init(app, exit_code);
    add_check(app, exit_code);
    add_mesh(app, exit_code);
    add_loads(app, exit_code);
    add_heat(app, exit_code);
    add_run(app, exit_code);
    add_compare(app, exit_code);
    add_reduce(app, exit_code);
    add_sweep(app, exit_code);
    add_sensitivity(app, exit_code);
    add_calibrate(app, exit_code);
    add_optimise(app, exit_code);
    add_probe(app, exit_code);
    add_report(app, exit_code);
    add_schema(app, exit_code);
    add_view(app, exit_code);
    add_examples(app);
    if (argc == 3 && std::string_view(argv[1]) == "--write-manual") {  // used when the program is packaged
        write_manual(app, std::string(deadpoint::version), argv[2]);
        return 0;
    }
    if (argc > 1 && argv[1][0] != '-' && std::count(subcommands.begin(), subcommands.end(), argv[1]) == 0) {
        return refuse_subcommand(argv[1]);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const bool asked_for = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success);
        return asked_for ? app.exit(error) : refuse_arguments(app, error, argc, argv);
    }
    return exit_code;
}

/// Runs the command. @return its exit code; whatever it throws is shown
int run_and_explain(int argc, char** argv)
{
    try {
        deadpoint::fem::choose_product_kernels();
        return run(argc, argv);
    } catch (...) {
        return explain(std::current_exception());
    }
}

/// The exit code after all text was given to standard output: an error of its own where that lost some.
int after_output(int exit_code)
{
    try {
        require_whole_output();
        return exit_code;
    } catch (const deadpoint::IoError& error) {
        print_error(error);
        return exit_code != 0 ? exit_code : error.exit_code();
    }
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc == 3 && std::string_view(argv[1]) == hold_place_argument) {  // started by mpirun, for ranks
        return hold_place(argv[2]);
    }
    open_missing_streams();
    outlast_failing_writes();
    return after_output(run_and_explain(argc, argv));
}
