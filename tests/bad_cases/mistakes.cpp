/// Requirement: mistakes that users make in the case of `deadpoint init` are answered with what is wrong, where, and
/// what to do about it, as an error or, where it can be computed, as a warning.
///
/// mistakes.txt holds one mistake below each "## name":
///   "- " and "+ "  lines of the case that are replaced, and by what (several "- " after a "+ ": another place)
///   "$ "           further arguments
///   "! "           exit code
///   "= "           lines of the answer, in this order, without numbers of lines; "..." at the end stands for the rest
#include "broken.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <regex>
#include <sys/wait.h>

namespace {

namespace fs = std::filesystem;

struct Edit {
    std::string before;
    std::string after;
};

struct Mistake {
    std::string name;
    std::vector<Edit> edits;
    std::string arguments;
    int code = 2;
    std::string answer;
};

void add_line(Mistake& mistake, char kind, const std::string& text)
{
    if (kind == '-') {
        if (mistake.edits.empty() || !mistake.edits.back().after.empty()) {
            mistake.edits.emplace_back();
        }
        mistake.edits.back().before += text + "\n";
    } else if (kind == '+') {
        mistake.edits.back().after += text + "\n";
    } else if (kind == '$') {
        mistake.arguments = text;
    } else if (kind == '!') {
        mistake.code = std::stoi(text);
    } else if (kind == '=') {
        mistake.answer += text + "\n";
    }
}

std::vector<Mistake> read_mistakes()
{
    std::vector<Mistake> mistakes;
    std::ifstream file(fs::path(DEADPOINT_SOURCE_DIR) / "tests/bad_cases/mistakes.txt");
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("## ")) {
            mistakes.push_back({line.substr(3), {}, {}, 2, {}});
        } else if (!mistakes.empty() && !line.empty()) {
            add_line(mistakes.back(), line.front(), line.size() > 2 ? line.substr(2) : "");
        }
    }
    return mistakes;
}

std::string content(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// The text without the line break at its end: edits may lie within a line.
std::string trimmed(std::string text)
{
    text.pop_back();
    return text;
}

/// Without numbers of lines and columns, which change with the case.
std::string without_numbers(const std::string& message)
{
    auto text = std::regex_replace(message, std::regex(R"((warning: )?(case\.toml|--set):\d+:\d+: )"), "");
    return std::regex_replace(text, std::regex(R"(\n +\d+ \| )"), "\n| ");
}

struct Scratch {
    fs::path path = fs::temp_directory_path() / ("deadpoint-mistakes-" + std::to_string(std::random_device{}()));
    Scratch() { fs::create_directories(path); }
    ~Scratch() { fs::remove_all(path); }
};

}  // namespace

TEST_CASE("every mistake in the starter case is answered as mistakes.txt says")
{
    const Scratch scratch;
    const auto sound = content(fs::path(DEADPOINT_SOURCE_DIR) / "cases/starter/case.toml");
    const auto mistakes = read_mistakes();
    CHECK(mistakes.size() >= 60);
    for (const auto& mistake : mistakes) {
        CAPTURE(mistake.name);
        std::string text = sound;
        for (const auto& edit : mistake.edits) {
            const auto before = trimmed(edit.before);
            const auto at = text.find(before);
            REQUIRE_MESSAGE(at != std::string::npos, before);
            text.replace(at, before.size(), trimmed(edit.after));
        }
        std::ofstream(scratch.path / "case.toml") << text;
        const int status =
            std::system(("cd " + scratch.path.string() + " && " DEADPOINT_COMMAND " check -q case.toml " +
                         mistake.arguments + " >out 2>err")
                            .c_str());
        const auto message = content(scratch.path / "err");
        CAPTURE(message);
        CHECK((WIFEXITED(status) ? WEXITSTATUS(status) : -1) == mistake.code);
        CHECK(mistake.answer.find("help: ") != std::string::npos);
        CHECK(broken::missing_line(without_numbers("\n" + message), mistake.answer) == "");
    }
}
