/// Requirement: a solid of a drawing keeps its name, whatever alphabet and encoding; a part is the same solid in every
/// export of the drawing; what cannot be meshed is told with its solid, reason and place.
#include "../../scratch_folder.hpp"
#include "deadpoint/machine/cad/identity.hpp"
#include "deadpoint/machine/cad/read_cad.hpp"
#include "deadpoint/machine/foreign/step_file.hpp"
#include "fixture.hpp"
#include "near.hpp"

#include <algorithm>

using namespace machine_test;
using namespace deadpoint::machine;

namespace {

const std::string data = DEADPOINT_TEST_DATA "/cad/";

std::string replaced(std::string text, const std::string& old, const std::string& by)
{
    for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + by.size())) {
        text.replace(at, old.size(), by);
    }
    return text;
}

CadModel read(const std::string& path, std::optional<double> unit = {}) { return read_cad("import", path, unit, {}); }

/// Names of the solids of a drawing that is given as text.
std::vector<std::string> names_in(const std::string& text)
{
    const ScratchFolder folder;
    std::vector<std::string> names;
    for (const auto& solid : read(folder.file("drawing.step", text).string()).solids) {
        names.push_back(solid.called);
    }
    return names;
}

StepSource source(const std::string& solid, const std::optional<SolidPrint>& print = {})
{
    return {"press.step", text_of(SolidReference{solid, print ? text_of(*print) : ""})};
}

std::string refusal(const StepSource& wanted, const std::vector<SolidIdentity>& solids)
{
    try {
        (void)chosen_solids("p", wanted, solids);
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

/// A block of these edges about a place [m].
SolidPrint block(Vec3 size, Vec3 centre) { return {size[0] * size[1] * size[2], size, centre}; }

/// Two bolts of one name, and a plate.
const std::vector<SolidIdentity> bolts{{"bolt", "bolt", block({0.02, 0.02, 0.1}, {0.3, 0, 0})},
                                       {"bolt", "bolt_2", block({0.02, 0.02, 0.1}, {-0.3, 0, 0})},
                                       {"plate", "plate", block({0.8, 0.1, 0.02}, {0, 0, 0.06})}};

MachineDescription of_drawing(const std::string& file, double size, double omit)
{
    StepSource step{data + file};
    step.rules.omit = omit;
    MachineDescription description;
    PartDescription part;
    part.name = "p";
    part.body = "b";
    part.source = step;
    description.parts = {part};
    description.size = size;
    return description;
}

}  // namespace

TEST_CASE("names in Chinese and Russian are those of the file")
{
    CHECK(names_in(content(data + "ru.step")) == std::vector<std::string>{"станина", "ползун", "коленвал"});
    CHECK(names_in(content(data + "names_zh_utf8.step")) == std::vector<std::string>{"机架", "滑块", "曲轴"});
    CHECK(names_in(content(data + "zh_tail.step")) == std::vector<std::string>{"Deckel_上", "Deckel_下", "Kurbel_左"});
    // Their keys in a case are ASCII, and still distinct.
    std::vector<std::string> keys;
    for (const auto& solid : read(data + "ru.step").solids) {
        keys.push_back(solid.name);
    }
    CHECK(keys == std::vector<std::string>{"stanina", "polzun", "kolenval"});
}

TEST_CASE("names are read in every encoding that exports use")
{
    const std::string text = content(data + "zh_tail.step");
    const auto with = [&](const std::string& upper, const std::string& lower, const std::string& left) {
        return names_in(replaced(replaced(replaced(text, "Deckel_上", upper), "Deckel_下", lower), "Kurbel_左", left));
    };
    const std::vector<std::string> chinese{"Deckel_上", "Deckel_下", "曲轴_左"};
    CHECK(with("Deckel_\xc9\xcf", "Deckel_\xcf\xc2", "\xc7\xfa\xd6\xe1_\xd7\xf3") == chinese);  // GBK
    CHECK(with("Deckel_\\X2\\4E0A\\X0\\", "Deckel_\\X2\\4E0B\\X0\\", "\\X2\\66F28F74\\X0\\_\\X2\\5DE6\\X0\\") ==
          chinese);
    const std::vector<std::string> western{"Stößel", "Größe É", "créée"};
    CHECK(with("St\xf6\xdf"
               "el",
               "Gr\xf6\xdf"
               "e \xc9",
               "cr\xe9\xe9"
               "e") == western);  // ISO 8859-1
    CHECK(with("St\\X\\F6\\X\\DFel", "Gr\\S\\v\\S\\_e \\X\\C9", "cr\\X2\\00E900E9\\X0\\e") == western);
    CHECK(with("\xf1\xf2\xe0\xed\xe8\xed\xe0", "\xef\xee\xeb\xe7\xf3\xed", "\xea\xee\xeb\xe5\xed\xe2\xe0\xeb") ==
          std::vector<std::string>{"станина", "ползун", "коленвал"});  // Windows-1251
}

TEST_CASE("the encoding of a file is told by its bytes")
{
    CHECK(letters_of("PRODUCT('frame')") == StepLetters::utf8);
    CHECK(letters_of("'机架'") == StepLetters::utf8);
    CHECK(letters_of("'机架', '滑块', '曲轴', '连杆' cut: '\xe6\x9c'") == StepLetters::utf8);
    CHECK(letters_of("'\xbb\xfa\xbc\xdc'") == StepLetters::gbk);  // two common characters
    CHECK(letters_of("'M8_\xc2\xdd\xcb\xa8'") == StepLetters::gbk);
    CHECK(letters_of("'\xc4rmel'") == StepLetters::latin);
    CHECK(letters_of("'St\xf6\xdf"
                     "el', 'GR\xd6\xdf"
                     "E'") == StepLetters::latin);
    CHECK(letters_of("'\xf1\xf2\xe0\xed\xe8\xed\xe0'") == StepLetters::cyrillic);
}

TEST_CASE("awkward names stay on one line and of bearable length")
{
    const std::string text = content(data + "zh_tail.step");
    const auto names = names_in(replaced(
        replaced(replaced(text, "Deckel_上", "it''s \"q\" \\\\ \x1b[2J"), "Deckel_下", std::string(10000, 'A')),
        "Kurbel_左", ""));
    CHECK(names[0] == "it's \"q\" \\ \\u001b[2J");
    CHECK(names[1] == std::string(200, 'A'));
    CHECK(names[2] == "asm");  // that of the assembly
}

TEST_CASE("a fingerprint is the same in other orders and units, and another solid's is another")
{
    const auto one = read(data + "ru.step"), other = read(data + "ru_other_order.step");
    const auto inches = read(data + "ru.step", 0.0254);
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& solid = one.solids[i];
        const auto again = std::ranges::find(other.solids, solid.called, &CadSolid::called);
        REQUIRE(again != other.solids.end());
        CHECK(same_solid(solid.fingerprint, again->fingerprint));
        CHECK(same_solid(solid.fingerprint, inches.solids[i].fingerprint));  // the file's own lengths count
        CHECK_FALSE(same_solid(solid.fingerprint, one.solids[(i + 1) % 3].fingerprint));
    }
    // 100 x 50 x 50 mm, exact but for the rounding of the kernel.
    CHECK(one.solids[0].fingerprint.volume == near(0.25e-3, 1e-9));
    CHECK(one.solids[0].fingerprint.size[0] == near(0.1, 1e-6));
    // The text of a fingerprint is read back as written.
    CHECK(text_of(block({0.1, 0.05, 0.05}, {0.05, -0.025, 0})) == "0.25 L, 100 x 50 x 50 mm at (50, -25, 0) mm");
}

TEST_CASE("of several solids of one name the fingerprint chooses, and without one none is chosen")
{
    const auto chosen = [](const StepSource& wanted) { return chosen_solids("p", wanted, bolts).solids; };
    using Indices = std::vector<std::size_t>;
    CHECK(chosen(source("plate")) == Indices{2});
    CHECK(chosen(source("bolt", bolts[1].fingerprint)) == Indices{1});
    CHECK(chosen(source("bolt_2", bolts[0].fingerprint)) == Indices{0});  // as older cases name it: only a number
    CHECK(chosen(source("bolt*")) == Indices{0, 1});
    CHECK(chosen(source("*")) == Indices{0, 1, 2});
    const auto two = refusal(source("bolt"), bolts);
    CHECK(
        contains(two, "2 solids of 'press.step' are called 'bolt': 0.04 L at (300.0, 0.0, 0.0) mm; 0.04 L at (-300.0"));
    CHECK(contains(two, "fingerprint = \"0.04 L, 20 x 20 x 100 mm at (300, 0, 0) mm\", or"));
    CHECK(refusal(source("bolt_2"), bolts) == two);
    CHECK(contains(refusal(source("bolt*", bolts[0].fingerprint), bolts), "remove the fingerprint"));
    CHECK(contains(refusal(source("blot"), bolts), "did you mean 'bolt'?"));
}

TEST_CASE("a name that is another solid's now is refused, and a changed solid is questioned")
{
    const auto other = refusal(source("plate", bolts[0].fingerprint), bolts);
    CHECK(contains(
        other, "the solid 'plate' of 'press.step' is not the one that is meant: its `fingerprint` is that of 'bolt'"));
    CHECK(contains(refusal(source("cover", bolts[2].fingerprint), bolts), "by its fingerprint it is 'plate' now"));
    // 3 mm longer: no other solid, so the drawing was changed.
    const auto changed = chosen_solids("p", source("plate", block({0.803, 0.1, 0.02}, {0, 0, 0.06})), bolts);
    CHECK(changed.solids == std::vector<std::size_t>{2});
    CHECK(contains(changed.doubt, "the solid 'plate' of 'press.step' has changed"));
    CHECK(chosen_solids("p", source("plate", block({0.8005, 0.1001, 0.02}, {0, 0, 0.06})), bolts).doubt.empty());
}

TEST_CASE("narrow roundings that meet in a point get smaller cells")
{
    Log log;
    // Edges of 1000 x 600 x 340 mm with roundings of 3 mm, meshed with cells of 60 mm; chords cut some of the
    // roundings.
    for (const auto* file : {"block_two_R3.step", "block_four_R3.step"}) {
        const Machine machine = build_machine(of_drawing(file, 0.06, 0), log);
        CHECK(machine.parts[0].volume == near(0.204, 1e-3));
    }
    CHECK(std::ranges::any_of(
        log.infos, [](const auto& text) { return contains(text, "cells on curved faces are as small as"); }));
}

TEST_CASE("roundings of all edges around a face are left out, and the face is not")
{
    for (const auto* file : {"block_two_R3.step", "block_four_R3.step"}) {
        Log log;
        const Machine machine = build_machine(of_drawing(file, 0.06, 0.02), log);
        CHECK(machine.parts[0].volume == near(1 * 0.6 * 0.34, 1e-9));  // plane faces only
        CHECK(std::ranges::any_of(log.infos, [](const auto& text) { return contains(text, "are left out: 1 of 1"); }));
    }
}

TEST_CASE("a solid that crosses itself is told with its name, the reason and the place")
{
    const auto outline = complaint(of_drawing("crossed_outline.step", 0.015, 0));
    CHECK(contains(outline, "part 'p': the solid of '" + data +
                                "crossed_outline.step' cannot be meshed: its surface crosses itself"));
    CHECK(contains(outline, "at (50.0, 30.0, "));  // the middle of the bow tie of 100 x 60 mm
    CHECK(contains(outline, "help: repair the solid there"));
    const auto faces = complaint(of_drawing("crossed_faces.step", 0.015, 0));
    CHECK(contains(faces, "cannot be meshed: its surface crosses itself at ("));
    for (const auto& text : {outline, faces}) {
        for (const auto* wrong : {"crashed", "attack", "another file", "not yours"}) {
            CHECK_FALSE(contains(text, wrong));
        }
    }
}

TEST_CASE("a fingerprint is read as it is written, and nothing else is one")
{
    const auto print = block({0.1234567, 0.05, 0.02}, {-0.0300001, 0, 1.5});
    const auto again = solid_print(text_of(print));
    REQUIRE(again);
    CHECK(again->volume == near(print.volume, 5e-5));  // five digits
    CHECK(again->size[0] == near(print.size[0], 0, 0.5e-7));
    CHECK(again->centre[0] == near(print.centre[0], 0, 0.5e-7));
    for (const auto* wrong : {"", "0.25 L", "-1 L, 1 x 1 x 1 mm at (0, 0, 0) mm", "1 L, 1 x 1 x -1 mm at (0, 0, 0) mm",
                              "nan L, 1 x 1 x 1 mm at (0, 0, 0) mm", "1 L, 1 x 1 x 1 mm at (0, 0, 0) mm or so"}) {
        CHECK_FALSE(solid_print(wrong));
    }
    const auto both = solid_reference(text_of(SolidReference{"机架", text_of(print)}));
    CHECK(both.name == "机架");
    CHECK(both.fingerprint == text_of(print));
    CHECK(solid_reference("frame").fingerprint.empty());
}

TEST_CASE("awkward drawings are read as far as they go, or refused in words")
{
    const std::string text = content(data + "ru.step");
    const std::string end = "ENDSEC;\nEND-ISO-10303-21;\n";
    const auto outcome = [](const std::string& drawing) -> std::string {
        const ScratchFolder folder;
        try {
            return std::to_string(read(folder.file("drawing.step", drawing).string()).solids.size()) + " solids";
        } catch (const InputError& error) {
            return error.what();
        }
    };
    struct Row {
        const char* what;
        std::string drawing;
        const char* words;
    };
    for (const auto& [what, drawing, words] :
         {Row{"cut in the middle, but ended", text.substr(0, text.find("#300=")) + end, "1 solids"},
          Row{"faces of no kind", replaced(text, "ADVANCED_FACE", "ADVANCED_FAKE"), "holds no solid"},
          Row{"points of no kind", replaced(text, "CARTESIAN_POINT", "CARTESIAN_PINT"), "incomplete or out of order"},
          Row{"a direction without length",
              replaced(text, "#7=DIRECTION('',(0.,0.,1.))", "#7=DIRECTION('',(0.,0.,0.))"), "3 solids"},
          Row{"a number far too large", replaced(text, "(100.,50.,0.)", "(100.E290,50.,0.)"), ""},
          Row{"a solid of itself", replaced(text, "('станина',#146)", "('станина',#147)"), "2 solids"},
          Row{"no name at all",
              replaced(replaced(replaced(text, "'станина'", "''"), "'ползун'", "''"), "'коленвал'", "''"), "3 solids"},
          Row{"a tolerance of 100 m", replaced(text, "LENGTH_MEASURE(1.E-05)", "LENGTH_MEASURE(1.E+05)"), "3 solids"},
          Row{"no data", text.substr(0, text.find("#1=")) + end, "incomplete or out of order"}}) {
        CAPTURE(what);
        const auto said = outcome(drawing);
        CAPTURE(said);
        CHECK(contains(said, words));
        for (const auto* wrong : {"crashed", "attack", "another file", "defect"}) {
            CHECK_FALSE(contains(said, wrong));
        }
    }
}

TEST_CASE("a solid without thickness, or with an edge without length, is told as one that cannot be meshed")
{
    const ScratchFolder folder;
    const std::string plate = content(DEADPOINT_TEST_DATA "/plate_with_hole.step");  // 20 mm thick
    MachineDescription description = of_drawing("ru.step", 0.03, 0);
    std::get<StepSource>(description.parts[0].source).path =
        folder.file("flat.step", replaced(plate, ",20.)", ",0.)")).string();
    const auto said = complaint(description);
    CAPTURE(said);
    CHECK((contains(said, "cannot be meshed: ") || contains(said, "holds no solid")));
    CHECK_FALSE(contains(said, "crashed"));
}
