#include "manual.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/read_file.hpp"
#include "deadpoint/io/write_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <ostream>
#include <string_view>
#include <vector>

namespace {

/// Text with some characters replaced.
std::string replaced(std::string text, std::string_view from, std::string_view to)
{
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

bool starts_command(const std::string& line) { return line.starts_with('.') || line.starts_with('\''); }

/// As troff shows it: no commands at the starts of lines, hyphens that can be copied.
std::string troff(std::string text)
{
    text = replaced(replaced(std::move(text), "\\", "\\e"), "-", "\\-");
    return starts_command(text) ? "\\&" + text : text;
}

/// In single quotes, for shells.
std::string quoted(const std::string& text) { return "'" + replaced(text, "'", "'\\''") + "'"; }

/// "-q,--quiet" as its names.
std::vector<std::string> names_of(const CLI::Option& option)
{
    std::vector<std::string> names;
    for (const auto& name : option.get_snames()) {
        names.push_back("-" + name);
    }
    for (const auto& name : option.get_lnames()) {
        names.push_back("--" + name);
    }
    return names;
}

bool is_shown(const CLI::Option& option) { return !option.get_group().empty(); }
bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<const CLI::Option*> options_of(const CLI::App& app, bool positional)
{
    std::vector<const CLI::Option*> result;
    for (const auto* option : app.get_options()) {
        if (is_shown(*option) && option->nonpositional() != positional) {
            result.push_back(option);
        }
    }
    return result;
}

std::vector<const CLI::App*> subcommands_of(const CLI::App& app)
{
    return app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

/// "--output DIR"
std::string heading(const CLI::Option& option)
{
    const auto names = fmt::format("\\fB{}\\fR", troff(fmt::format("{}", fmt::join(names_of(option), ", "))));
    return takes_value(option) ? names + " \\fI" + troff(option.get_type_name()) + "\\fR" : names;
}

std::string paragraph(const std::string& head, const std::string& text)
{
    return ".TP\n" + head + "\n" + troff(text) + "\n";
}

std::string options_page(const CLI::App& app)
{
    std::string text;
    for (const auto* option : options_of(app, true)) {
        text += paragraph("\\fI" + troff(option->get_name(true)) + "\\fR", option->get_description());
    }
    for (const auto* option : options_of(app, false)) {
        text += paragraph(heading(*option), option->get_description());
    }
    return text;
}

/// "deadpoint run [OPTIONS] CASE"
std::string synopsis(const CLI::App& sub)
{
    std::string text = "\\fBdeadpoint " + troff(sub.get_name()) + "\\fR [\\fIOPTIONS\\fR]";
    for (const auto* option : options_of(sub, true)) {
        text += " \\fI" + troff(option->get_name(true)) + "\\fR";
    }
    return text;
}

/// Lines as they stand.
std::string verbatim(const std::string& text)
{
    std::string lines = ".nf\n";
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto end = std::min(text.find('\n', begin), text.size());
        lines += troff(text.substr(begin, end - begin)) + "\n";
        begin = end + 1;
    }
    return lines + ".fi\n";
}

/// All names of an app's options, in one line.
std::string option_words(const CLI::App& app)
{
    std::vector<std::string> words;
    for (const auto* option : options_of(app, false)) {
        for (const auto& name : names_of(*option)) {
            words.push_back(name);
        }
    }
    return fmt::format("{}", fmt::join(words, " "));
}

std::string subcommand_words(const CLI::App& app)
{
    std::vector<std::string> words;
    for (const auto* sub : subcommands_of(app)) {
        words.push_back(sub->get_name());
    }
    return fmt::format("{}", fmt::join(words, " "));
}

/// Options as _arguments of zsh takes them.
std::string zsh_arguments(const CLI::App& app)
{
    std::string text;
    for (const auto* option : options_of(app, false)) {
        auto about = replaced(replaced(option->get_description(), "[", "("), "]", ")");
        about = replaced(std::move(about), ":", "\\:");
        const std::string value = takes_value(*option) ? ":" + option->get_type_name() + ":_files" : "";
        for (const auto& name : names_of(*option)) {
            text += " \\\n        " + quoted("*" + name + "[" + about + "]" + value);
        }
    }
    return text;
}

std::string fish_option(const CLI::Option& option, const std::string& condition)
{
    std::string line = "complete -c deadpoint -n " + quoted(condition);
    for (const auto& name : option.get_snames()) {
        line += " -s " + name;
    }
    for (const auto& name : option.get_lnames()) {
        line += " -l " + name;
    }
    return line + (takes_value(option) ? " -r" : "") + " -d " + quoted(option.get_description()) + "\n";
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version)
{
    std::string text = fmt::format(".TH DEADPOINT 1 \"\" \"deadpoint {}\" \"User Commands\"\n", version);
    text += ".SH NAME\ndeadpoint \\- thermal drift of a mechanical press at bottom dead point\n.SH SYNOPSIS\n";
    for (const auto* sub : subcommands_of(app)) {
        text += synopsis(*sub) + "\n.br\n";
    }
    text += ".SH OPTIONS\n" + options_page(app) + ".SH COMMANDS\n";
    for (const auto* sub : subcommands_of(app)) {
        text += ".SS \"" + synopsis(*sub) + "\"\n" + troff(sub->get_description()) + "\n" + options_page(*sub);
    }
    return text + ".SH EXAMPLES AND EXIT CODES\n" + verbatim(app.get_footer());
}

std::string bash_completion(const CLI::App& app)
{
    std::string cases;
    for (const auto* sub : subcommands_of(app)) {
        cases += fmt::format("        {}) words=\"{}\" ;;\n", sub->get_name(), option_words(*sub));
    }
    return fmt::format(R"(# Completion of deadpoint for bash; written by deadpoint --write-manual.
_deadpoint()
{{
    local word=${{COMP_WORDS[COMP_CWORD]}} words="{} {}"
    case ${{COMP_WORDS[1]-}} in
{}    esac
    if [[ $word == -* || $COMP_CWORD -eq 1 ]]; then
        COMPREPLY=($(compgen -W "$words" -- "$word"))
    else
        COMPREPLY=($(compgen -f -- "$word"))
    fi
}}
complete -o filenames -F _deadpoint deadpoint
)",
                       subcommand_words(app), option_words(app), cases);
}

std::string zsh_completion(const CLI::App& app)
{
    std::string commands, cases;
    for (const auto* sub : subcommands_of(app)) {
        commands += "        " + quoted(sub->get_name() + ":" + sub->get_description()) + "\n";
        cases += fmt::format("    {})\n        _arguments{} \\\n        '*:file:_files' ;;\n", sub->get_name(),
                             zsh_arguments(*sub));
    }
    return fmt::format(R"(#compdef deadpoint
# Completion of deadpoint for zsh; written by deadpoint --write-manual.
_deadpoint()
{{
    local -a commands=(
{}    )
    if (( CURRENT == 2 )); then
        _describe command commands
        _arguments{}
        return
    fi
    case $words[2] in
{}    esac
}}
_deadpoint "$@"
)",
                       commands, zsh_arguments(app), cases);
}

std::string fish_completion(const CLI::App& app)
{
    std::string text = "# Completion of deadpoint for fish; written by deadpoint --write-manual.\n";
    for (const auto* option : options_of(app, false)) {
        text += fish_option(*option, "__fish_use_subcommand");
    }
    for (const auto* sub : subcommands_of(app)) {
        text += "complete -c deadpoint -n __fish_use_subcommand -a " + sub->get_name() + " -d " +
                quoted(sub->get_description()) + "\n";
        for (const auto* option : options_of(*sub, false)) {
            text += fish_option(*option, "__fish_seen_subcommand_from " + sub->get_name());
        }
    }
    return text;
}

void write_manual(const CLI::App& app, const std::string& version, const std::filesystem::path& folder)
{
    const auto write = [&](const char* name, const std::string& text) {
        const auto file = folder / name;
        const auto there = deadpoint::read_file(file, deadpoint::largest_result);
        constexpr std::size_t heading = 16;  // an older one begins alike
        if (there && there->substr(0, heading) != text.substr(0, heading)) {
            throw deadpoint::IoError(fmt::format("'{}' exists, and deadpoint did not write it\n  help: name another "
                                                 "folder",
                                                 file.string()));
        }
        deadpoint::write_file(file, text);
    };
    write("deadpoint.1", man_page(app, version));
    write("deadpoint.bash", bash_completion(app));
    write("_deadpoint", zsh_completion(app));
    write("deadpoint.fish", fish_completion(app));
}
