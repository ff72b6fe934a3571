/// Requirement: whatever stands in a text of a case, study or reference file, it is refused with its place in words
/// that a terminal can show, or it is taken as it is meant. Nothing of it is dropped or understood as something else.
#include "../scratch_folder.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"
#include "deadpoint/core/names/plain_text.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace {

using namespace deadpoint;
using casefile::read_case;
using casefile::read_reference;
using casefile::read_study;

/// Sound files. "@" and a letter stand where a hostile text goes; what stands there else is behind the letter.
const std::string case_text = R"(format = 1
[machine]
name = "@a{press}"
description = "@b{a plate}"
unbonded = ["@c{plate}|plate"]
[bodies."@d{frame}"]
ground = true
[materials.steel]
library = "@e{C45}"
[parts.plate]
body = "frame"
material = "steel"
size = "@f{10 mm}"
shapes = [{ add = "box", x = ["0 mm", "100 mm"], y = ["0 mm", "20 mm"], z = ["0 mm", "100 mm"] }]
[surfaces.top]
select = "plane"
axis = "y"
position = "20 mm"
@g{temperature = "20 degC"}
[[operation]]
duration = "1 min"
speed = "0 rpm"
)";
const std::string study_text = R"(format = 1
name = "@a{study}"
note = "@b{why}"
base = "case.toml"
[[sets]]
name = "@c{set}"
[[sets.axes]]
name = "@d{size}"
key = "numerics.size"
values = ["20 mm", "@f{30 mm}"]
labels = ["fine", "@e{coarse}"]
)";
const std::string reference_text = R"(format = 1
name = "@a{bench}"
source = "@b{measured}"
note = "@c{by hand}"
[[rises]]
time = "@f{1 h}"
values = { "@d{top}" = "2 K" }
[[claims]]
text = "@e{the top is warmest}"
kind = "unchecked"
reason = "no sensor"
)";

/// A file with one text in the place of a letter, and at all others what belongs there.
std::string with(const std::string& file, char letter, const std::string& text)
{
    std::string result;
    for (std::size_t at = 0; at < file.size();) {
        const auto mark = file.find('@', at);
        if (mark == std::string::npos)
            return result + file.substr(at);
        const auto end = file.find('}', mark);
        result += file.substr(at, mark - at);
        result += file[mark + 1] == letter ? text : file.substr(mark + 3, end - mark - 3);
        at = end + 1;
    }
    return result;
}

enum class Kind { case_file, study, reference };

std::string text_of(Kind kind, char letter, const std::string& text)
{
    return with(kind == Kind::case_file ? case_text : kind == Kind::study ? study_text : reference_text, letter, text);
}

/// What is said about a file; empty if it is taken.
std::string answer(Kind kind, const std::string& text)
{
    const ScratchFolder folder;
    (void)folder.file("case.toml", kind == Kind::case_file ? text : with(case_text, '-', ""));
    try {
        if (kind == Kind::case_file)
            (void)read_case(folder.path / "case.toml");
        else if (kind == Kind::study)
            (void)read_study(folder.file("study.toml", text));
        else
            (void)read_reference(folder.file("reference.toml", text), "");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// As TOML writes them within quotes.
const std::vector<std::string> strange{"a\\u0000b",     "a\\u001b[31mred", "a\\nb = 1",     "a\\r\\nb",
                                       "a\\tb",         "a\\u0007",        "a\\u007f",      "a\\u009b2J",
                                       "a\\u202egpj",   "a\\u200bb",       "a\\u2028b",     "a\\ufeff",
                                       "a\\U000e0041b", "a\\u0008",        "\\nkey = \\\"", "\\u2066a\\u2069"};

int attacks = 0;

/// @return whether an attack is refused in words that can be shown, with the place
void require_refused(Kind kind, char letter, const std::string& text, const std::string& code)
{
    ++attacks;
    const auto said = answer(kind, text_of(kind, letter, text));
    CAPTURE(static_cast<int>(kind));
    CAPTURE(letter);
    CAPTURE(text.substr(0, 80));
    CAPTURE(said);
    CHECK(said.find("error[" + code) != std::string::npos);
    CHECK(said.find(".toml:") != std::string::npos);
    CHECK(said.find("help: ") != std::string::npos);
    CHECK(printable(said) == said);
    CHECK(said.size() < 8000);
}

void require_taken(Kind kind, char letter, const std::string& text)
{
    ++attacks;
    CAPTURE(static_cast<int>(kind));
    CAPTURE(letter);
    CAPTURE(text);
    CHECK(answer(kind, text_of(kind, letter, text)) == "");
}

}  // namespace

TEST_CASE("the files that are attacked are sound")
{
    for (const Kind kind : {Kind::case_file, Kind::study, Kind::reference})
        CHECK(answer(kind, text_of(kind, '-', "")) == "");
}

TEST_CASE(
    "hostile texts in case, study and reference files: 144 and more, each refused with its place or taken as meant")
{
    attacks = 0;
    using enum Kind;
    // Characters that no line, table or terminal can show.
    for (const auto& text : strange) {
        for (const char letter : {'a', 'b', 'c', 'd', 'e'})
            require_refused(case_file, letter, text, "bad-text");
        for (const char letter : {'a', 'b', 'c', 'd', 'e'})
            require_refused(study, letter, text, "bad-text");
        for (const char letter : {'a', 'b', 'c', 'd', 'e'})
            require_refused(reference, letter, text, "bad-text");
    }
    // The same raw, which TOML itself forbids, and bytes that are not UTF-8.
    for (const std::string text : {"a\x1b[2Jb", "a\x01", "a\xff", "a\xc0\x80", "a\xed\xa0\x80"})
        for (const Kind kind : {case_file, study, reference})
            require_refused(kind, 'a', text, "syntax");
    // Names and texts of any length.
    for (const std::size_t length : {101, 256, 5000}) {
        const std::string text(length, 'n');
        require_refused(case_file, 'a', text, "too-long");
        require_refused(case_file, 'd', text, "too-long");
        for (const char letter : {'a', 'c', 'd', 'e'})
            require_refused(study, letter, text, "too-long");
        require_refused(reference, 'a', text, "too-long");
        require_refused(reference, 'd', text, "too-long");
    }
    require_refused(case_file, 'b', std::string(20'000, 'n'), "too-long");
    require_refused(study, 'b', std::string(20'000, 'n'), "too-long");
    require_refused(reference, 'e', std::string(20'000, 'n'), "too-long");
    // Names of tables become columns and files.
    for (const char* text : {"=cmd|' /C calc'!A0", "+A1", "-A1", "@SUM(A1)", "../up", "a/b", "a b", ".", "a\\\\b",
                             "<b>", "a;b", "$(id)", "`id`", "a,b", "a%n"})
        require_refused(case_file, 'd', text, "bad-name");
    // Decimal commas, and marks between thousands.
    for (const char* text : {"0,5 mm", "10,0 mm", "1,000 mm", "-0,5 mm", "+1,5 mm", " 2,5mm", "1,5e1 mm"}) {
        require_refused(case_file, 'f', text, "decimal-comma");
        require_refused(study, 'f', text, "decimal-comma");
    }
    for (const char* text : {"0,5 h", "1,000 s"})
        require_refused(reference, 'f', text, "decimal-comma");
    // Quantities that are none.
    for (const char* text : {"", " ", "mm", "1 mm mm", "1e999 mm", "nan mm", "inf mm", "0x10 mm", "1 mm; 2 mm",
                             "1 'mm'", "1 mm @ 3", "1 $(id)", "--1 mm", "1..5 mm", "\xef\xbc\x91 mm"})
        require_refused(case_file, 'f', text, "");
    // Formulas that cannot be meant.
    for (const char* text : {"293,15", "0", "-50", "", " ", "x=5", "t=300", "300/0", "log(-1)", "20 degC", "293.15;1",
                             "1e400", "300 - t*10", "(", "system(1)", "sin", "\\\"id\\\""})
        require_refused(case_file, 'g', "temperature_formula = \"" + std::string(text) + "\"", "");
    // What is strange to files, but can be shown, is taken.
    for (const char* text : {"=cmd|' /C calc'!A0", "</script><b>", "--> <!--", "a,b;c", "a|b", "$(id)", "\xc3\xbc",
                             "%s%n{}", "[machine]", "# name", "\\\"quoted\\\""})
        for (const Kind kind : {case_file, study, reference})
            require_taken(kind, 'a', text);
    CHECK(attacks >= 144);
    MESSAGE(attacks, " hostile texts");
}

TEST_CASE("a formula colder than any press is taken with a warning")
{
    for (const auto& [formula, warned] : {std::pair{"20", true},
                                          {"149", true},
                                          {"20 + 10*sin(t/40)", true},
                                          {"151", false},
                                          {"293.15 + t/60", false}}) {
        CAPTURE(formula);
        const ScratchFolder folder;
        const auto file =
            folder.file("case.toml", with(case_text, 'g', "temperature_formula = \"" + std::string(formula) + "\""));
        const auto warnings = read_case(file).warnings;
        const bool found = std::ranges::any_of(
            warnings, [](const auto& text) { return text.find("add 273.15") != std::string::npos; });
        CHECK(found == warned);
    }
}

TEST_CASE("a name in a written case is the name that was read, whatever is in it")
{
    for (const char* name : {"=1", "a # b", "[machine]", "x = 1", "\\\"", "'", "\\\\n", "\xc3\xbc"}) {
        CAPTURE(name);
        const ScratchFolder folder;
        const auto first = read_case(folder.file("case.toml", with(case_text, 'a', name))).value;
        const auto again = read_case(folder.file("again.toml", casefile::write_case(first))).value;
        CHECK(again.machine.name == first.machine.name);
        CHECK(casefile::case_hash(again) == casefile::case_hash(first));
    }
}
