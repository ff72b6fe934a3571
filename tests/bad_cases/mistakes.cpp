/// Requirement: mistakes that users make, in the case of `deadpoint init` and elsewhere, are answered with what is
/// wrong, where, and what to do about it, as an error or, where it can be computed, as a warning. Each answer is graded
/// by that; docs/validation/mistakes.md lists the grades.
///
/// mistakes.txt holds one mistake below each "## name":
///   "- " and "+ "  lines of the case that are replaced, and by what (several "- " after a "+ ": another place)
///   "% "           a line of shell before, in the folder of the case; $CASES holds the shipped cases, $DATA the tests'
///                  files, $DEADPOINT is the program
///   "$ "           further arguments
///   "& "           what is called instead of `check -q case.toml`
///   "! "           exit code
///   "? "           a text that says what is wrong
///   "@ "           a text that says where, if that is no line that was changed
///   "> "           a text of the help that says what to do
///   "= "           lines of the answer, in this order, without numbers of lines; "..." at the end stands for the rest
#include "broken.hpp"
#include "grade.hpp"

#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <regex>
#include <set>
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
    std::string before;
    std::string arguments;
    std::string command = "check -q case.toml";
    int code = 2;
    grade::Demands demands;
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
    } else if (kind == '%') {
        mistake.before += text + " && ";
    } else if (kind == '&') {
        mistake.command = text;
    } else if (kind == '?') {
        mistake.demands.what.push_back(text);
    } else if (kind == '@') {
        mistake.demands.place = text;
    } else if (kind == '>') {
        mistake.demands.remedy.push_back(text);
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
            mistakes.emplace_back();
            mistakes.back().name = line.substr(3);
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

int count_lines(const std::string& text, std::size_t end)
{
    return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
}

struct Changed {
    std::string text;
    std::set<int> lines;  ///< that hold the mistake, from 1
};

Changed changed(std::string text, const Mistake& mistake)
{
    Changed result;
    std::size_t from = 0;
    for (const auto& edit : mistake.edits) {
        const auto before = trimmed(edit.before);
        const auto after = trimmed(edit.after);
        const auto at = text.find(before);
        REQUIRE_MESSAGE(at != std::string::npos, before);
        REQUIRE_MESSAGE(at >= from, "the edits of a mistake go down the case");
        text.replace(at, before.size(), after);
        from = at + after.size();
        for (int line = count_lines(text, at); line <= count_lines(text, from); ++line) {
            result.lines.insert(line);
        }
    }
    result.text = std::move(text);
    return result;
}

struct Outcome {
    int code = -1;
    std::string message;
};

Outcome answer_to(const Mistake& mistake, const std::string& text)
{
    const Scratch scratch;
    std::ofstream(scratch.path / "case.toml") << text;
    const std::string line = "cd " + scratch.path.string() +
                             " && export BROWSER=true DEADPOINT=" DEADPOINT_COMMAND " CASES=" DEADPOINT_SOURCE_DIR
                             "/cases DATA=" DEADPOINT_SOURCE_DIR "/tests/data && ( " +
                             mistake.before + "true ) >before 2>&1 && " DEADPOINT_COMMAND " " + mistake.command + " " +
                             mistake.arguments + " >out 2>err </dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(scratch.path / "err")};
}

/// The page of all grades.
class Page {
public:
    void add(const Mistake& mistake, const grade::Grade& grade)
    {
        const bool is_error = mistake.code != 0;
        rows_ << "| " << mistake.name << " | " << (is_error ? "refused" : "warned about") << " | " << grade.points()
              << " |\n";
        sum_ += grade.points();
        least_ = std::min(least_, grade.points());
        ++count_;
    }
    [[nodiscard]] std::string text() const
    {
        std::ostringstream page;
        page
            << "<!-- Written by the test `mistakes` with DEADPOINT_RENEW_DOCS=1. Do not edit. -->\n\n"
               "# Mistakes and their answers\n\n"
               "A mistake has grade 3 if the answer says what is wrong, where, and what to do; 2 if one of these is "
               "missing; 1 if two are\nmissing or the answer misleads; 0 if nothing is said. For each mistake "
               "[mistakes.txt](../../tests/bad_cases/mistakes.txt) states\nwhat an answer has to hold: the user's own "
               "value and the limit it breaks; the changed line, or the key, part, file or\noption at fault; and the "
               "remedy in the help. The test `mistakes` makes every mistake, grades the answer, and fails below 3.\n\n";
        page.precision(3);
        page << count_ << " mistakes, mean grade " << static_cast<double>(sum_) / count_ << ", lowest " << least_
             << ".\n\n| mistake | answer | grade |\n|---|---|--:|\n"
             << rows_.str();
        return page.str();
    }

private:
    std::ostringstream rows_;
    int sum_ = 0;
    int least_ = 3;
    int count_ = 0;
};

}  // namespace

TEST_CASE("every mistake is answered as mistakes.txt says, with what is wrong, where, and what to do")
{
    const auto sound = content(fs::path(DEADPOINT_SOURCE_DIR) / "cases/starter/case.toml");
    const auto mistakes = read_mistakes();
    CHECK(mistakes.size() >= 155);
    Page page;
    for (const auto& mistake : mistakes) {
        CAPTURE(mistake.name);
        const auto input = changed(sound, mistake);
        const auto [code, message] = answer_to(mistake, input.text);
        CAPTURE(message);
        CHECK(code == mistake.code);
        CHECK(broken::missing_line(without_numbers("\n" + message), mistake.answer) == "");
        const auto grade = grade::of(message, mistake.demands, input.lines);
        CAPTURE(grade.what);
        CAPTURE(grade.place);
        CAPTURE(grade.remedy);
        CHECK(grade.points() == 3);
        page.add(mistake, grade);
    }
    const auto file = fs::path(DEADPOINT_SOURCE_DIR) / "docs/validation/mistakes.md";
    if (std::getenv("DEADPOINT_RENEW_DOCS") != nullptr) {
        std::ofstream(file) << page.text();
    }
    CHECK(content(file) == page.text());
}

TEST_CASE("an answer that lacks something has a lower grade")
{
    const std::string whole = "case.toml:7:3: error[out-of-range]: operation.0.speed\n  '-60 rpm' is out of range\n"
                              "     7 | speed = \"-60 rpm\"\n       |         ^^^\n  help: it must not be negative\n";
    const grade::Demands demands{{"-60 rpm"}, {"negative"}, ""};
    CHECK(grade::of(whole, demands, {7}).points() == 3);
    CHECK(grade::of(whole, demands, {8}).points() == 2);  // another line
    CHECK(grade::of(whole, {{"-60 rpm"}, {"negative"}, "operation.0.speed"}, {}).points() == 3);
    CHECK(grade::of(whole, {{"-60 rpm"}, {"negative"}, "operation.1.speed"}, {}).points() == 2);
    CHECK(grade::of(whole, {{"is out of range"}, {"write it like"}, ""}, {7}).points() == 2);
    // What only the shown line of the case says is not said.
    CHECK(grade::of(whole, {{"speed = "}, {"negative"}, ""}, {7}).points() == 2);
    CHECK(grade::of(whole, {{"too slow"}, {"faster"}, ""}, {8}).points() == 1);
    CHECK(grade::of("", demands, {7}).points() == 0);
}
