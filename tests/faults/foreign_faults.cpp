/// Requirement: whatever stands in a mesh or STEP file, nothing is run, written, removed or read beyond it, no process
/// is left, and the program says what is wrong with it; and what is only unusual is read as it is meant.
#include "command.hpp"
#include "near.hpp"
#include "plate_case.hpp"

#include <bit>
#include <cstdint>
#include <doctest/doctest.h>
#include <functional>
#include <map>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <vector>

namespace {

const std::string commands = "SystemCall \"touch pwned\";\nSystem \"touch pwned\";\nMerge \"good.msh\";\n";

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    return text.replace(at, from.size(), to);
}

std::string all_replaced(const std::string& text, const std::string& from, const std::string& to)
{
    std::string result;
    std::size_t done = 0;
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, done)) {
        result += text.substr(done, at - done) + to;
        done = at + from.size();
    }
    return result + text.substr(done);
}

const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string names = "$PhysicalNames\n1\n3 1 \"solid\"\n$EndPhysicalNames\n";
const std::string corners =
    "1 0 0 0\n2 100 0 0\n3 100 100 0\n4 0 100 0\n5 0 0 100\n6 100 0 100\n7 100 100 100\n8 0 100 100\n";
const std::string nodes = "$Nodes\n8\n" + corners + "$EndNodes\n";
const std::string cell = "1 5 2 1 1 1 2 3 4 5 6 7 8\n";
const std::string cells = "$Elements\n1\n" + cell + "$EndElements\n";

/// A cube of 100 units in one cell, MSH 2.2.
const std::string cube = head + names + nodes + cells;

/// The same, MSH 4.1.
const std::string cube_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n1 0 0 0 100 100 100 0 0\n"
                           "$EndEntities\n$Nodes\n1 8 1 8\n3 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n100 0 0\n"
                           "100 100 0\n0 100 0\n0 0 100\n100 0 100\n100 100 100\n0 100 100\n$EndNodes\n$Elements\n"
                           "1 1 1 1\n3 1 5 1\n1 1 2 3 4 5 6 7 8\n$EndElements\n";

template <class T>
std::string bytes(T value, bool swapped)
{
    std::string result(reinterpret_cast<const char*>(&value), sizeof value);
    return swapped ? std::string(result.rbegin(), result.rend()) : result;
}

/// The same in binary, with so many nodes and cells as its counts say.
std::string binary_cube(std::int32_t mark, bool swapped, int node_count, int cell_count)
{
    std::string text = "$MeshFormat\n2.2 1 8\n" + bytes(mark, swapped) + "\n$EndMeshFormat\n" +
                       fmt::format("$Nodes\n{}\n", node_count);
    for (int i = 0; i < 8; ++i) {
        text += bytes(i + 1, swapped) + bytes(i % 4 == 1 || i % 4 == 2 ? 100.0 : 0.0, swapped) +
                bytes(i % 4 >= 2 ? 100.0 : 0.0, swapped) + bytes(i >= 4 ? 100.0 : 0.0, swapped);
    }
    text += fmt::format("\n$EndNodes\n$Elements\n{}\n", cell_count);
    for (const int number : {5, cell_count, 2, 1, 1, 1, 1, 2, 3, 4, 5, 6, 7, 8}) {
        text += bytes(number, swapped);
    }
    return text + "\n$EndElements\n";
}

std::string utf_16(const std::string& text)
{
    std::string result = "\xff\xfe";
    for (const char c : text) {
        result += c;
        result += '\0';
    }
    return result;
}

std::string noise(int length)
{
    std::string result;
    for (int i = 0; i < length; ++i) {
        result += static_cast<char>(i * 7919 >> 3);
    }
    return result;
}

/// Whatever is below a folder, with its size.
std::map<std::string, std::uintmax_t> listing(const fs::path& folder)
{
    std::map<std::string, std::uintmax_t> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        result[entry.path().string()] = entry.symlink_status().type() == fs::file_type::regular ? entry.file_size() : 0;
    }
    return result;
}

/// While it lives, orphans of what a test starts become children of the tests. Other tests leave theirs to the system.
class Adoption {
public:
    Adoption()
    {
        REQUIRE(prctl(PR_SET_CHILD_SUBREAPER, 1) == 0);
        while (waitpid(-1, nullptr, WNOHANG) > 0) {
        }
    }
    ~Adoption() { prctl(PR_SET_CHILD_SUBREAPER, 0); }
    Adoption(const Adoption&) = delete;
    Adoption& operator=(const Adoption&) = delete;
};

/// A folder with a home for attacks, in which `check` runs.
struct Target {
    Adoption adoption;
    ScratchFolder folder;
    fs::path home = folder.path / "home";

    Target()
    {
        fs::create_directory(home);
        // Gmsh reads these where it is not told otherwise.
        for (const auto* name : {"home/.gmshrc", "home/.gmsh-options", "home/.gmsh-tmp"}) {
            folder.file(name, commands);
        }
        folder.file("good.msh", cube);
    }

    /// What `check` says of a plate in that file. Nothing may appear or go, and no process may be left.
    Outcome check(const std::string& key, const std::string& file) const
    {
        const auto target = plate_case(folder, key, file);
        const auto before = listing(folder.path);
        const auto outcome =
            run(fmt::format("cd {} && HOME={} timeout 300", folder.path.string(), home.string()), "check " + target);
        CHECK(listing(folder.path) == before);
        CHECK(waitpid(-1, nullptr, WNOHANG) == -1);
        return outcome;
    }
};

struct Attack {
    std::string file;
    std::string content;
    std::string said;  ///< in the message
};

void expect_refused(const std::string& key, const std::vector<Attack>& attacks)
{
    const Target target;
    for (const auto& attack : attacks) {
        CAPTURE(attack.file);
        CAPTURE(attack.said);
        const auto path = target.folder.file(attack.file, attack.content);
        const auto outcome = target.check(key, attack.file);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.text, "]: parts.plate\n  part 'plate'"));
        CHECK(has(outcome.text, attack.said));
        fs::remove(path);
    }
}

/// What is only unusual is the same cube.
void expect_read(const std::vector<Attack>& oddities)
{
    const Target target;
    const double mass = plate_mass(target.check("mesh", "good.msh").text);
    REQUIRE(mass > 0);
    for (const auto& oddity : oddities) {
        CAPTURE(oddity.file);
        const auto path = target.folder.file(oddity.file, oddity.content);
        const auto outcome = target.check("mesh", oddity.file);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 0);
        CHECK(plate_mass(outcome.text) == near(mass, 1e-9));  // of the same numbers
        fs::remove(path);
    }
}

}  // namespace

TEST_CASE("commands in mesh and STEP files are not run, whatever the file is called")
{
    const std::string no_mesh = "is not a Gmsh mesh file (MSH 2 or 4): its first line is not '$MeshFormat'";
    std::vector<Attack> scripts;
    for (const auto* name : {"a.msh", "a.geo", "a.pos", "a.inp", "a.txt", "a.py", "a.brep", "a.opt", "a", "a.msh.gz"}) {
        scripts.push_back({name, commands, no_mesh});
    }
    scripts.push_back({"view.msh", "$PostFormat\n1.2 0 8\n$EndPostFormat\n" + commands, no_mesh});
    scripts.push_back({"comment.msh", "$Comments\n" + commands + "$EndComments\n" + cube, no_mesh});
    scripts.push_back({"blank.msh", "\n" + cube, no_mesh});
    scripts.push_back(
        {"head.msh", "$MeshFormat\n" + commands + "$EndMeshFormat\n", "does not name a supported version"});
    scripts.push_back({"tail.msh", cube + commands, "cut short"});
    expect_refused("mesh", scripts);
    expect_refused(
        "step", {{"a.step", commands, "is not a STEP file"},
                 {"a.geo", commands, "is not a STEP file"},
                 {"b.step", "ISO-10303-21;\n" + commands + "END-ISO-10303-21;\n", "are incomplete or out of order"}});
}

TEST_CASE("what stands around or between the sections of a mesh is not run, and a name decides nothing")
{
    const Target target;
    target.folder.file("good.msh.opt", commands);  // Gmsh reads it by itself
    const auto outcome = target.check("mesh", "good.msh");
    CHECK(outcome.code == 0);
    expect_read(
        {{"between.msh", head + commands + names + nodes + commands + cells, ""},
         {"a.geo", cube, ""},
         {"a.msh.gz", cube, ""},
         {"a.step", cube, ""},
         {"a", cube, ""},
         {"$(touch pwned).msh", cube, ""},
         {"a; touch pwned; .msh", cube, ""},
         {"version-4.msh", cube_4, ""},
         {"binary.msh", binary_cube(1, false, 8, 1), ""},
         {"other-endian.msh", binary_cube(1, true, 8, 1), ""},
         {"crlf.msh", all_replaced(cube, "\n", "\r\n"), ""},
         {"periodic.msh", cube + "$Periodic\n0\n$EndPeriodic\n", ""},
         {"unknown.msh", cube + "$Whatever\n1 2 3\n$EndWhatever\n", ""},
         {"huge-number.msh",
          all_replaced(replaced(cube, "8 0 100 100", "2000000000 0 100 100"), " 6 7 8\n", " 6 7 2000000000\n"), ""}});
}

TEST_CASE("mesh files that are cut, miscounted or made of nonsense are refused in words")
{
    expect_refused(
        "mesh",
        {{"empty.msh", "", "first line"},
         {"one.msh", "$", "first line"},
         {"zip.msh", "PK\x03\x04" + noise(1000), "first line"},
         {"gzip.msh", "\x1f\x8b\x08" + noise(1000), "first line"},
         {"hdf.msh", "\x89HDF\r\n\x1a\n" + noise(1000), "first line"},
         {"utf-16.msh", utf_16(cube), "first line"},
         {"mark.msh", "\xef\xbb\xbf" + cube, "first line"},
         {"version-1.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n$ELM\n0\n$ENDELM\n", "first line"},
         {"version-3.msh", replaced(cube, "2.2 0 8", "3 0 8"), "not name a supported version"},
         {"version-9.msh", replaced(cube, "2.2 0 8", "9.9 0 8"), "not name a supported version"},
         {"version-nan.msh", replaced(cube, "2.2 0 8", "nan 0 8"), "not name a supported version"},
         {"size.msh", replaced(cube, "2.2 0 8", "2.2 0 4"), "not name a supported version"},
         {"type.msh", replaced(cube, "2.2 0 8", "2.2 7 8"), "not name a supported version"},
         {"only-head.msh", head, "holds no solid cells"},
         {"no-nodes.msh", head + cells, "Wrong node index 1"},
         {"no-cells.msh", head + nodes, "holds no solid cells"},
         {"cut.msh", cube.substr(0, cube.size() - 20), "cut short"},
         {"cut-nodes.msh", head + nodes.substr(0, 40) + "\n$EndNodes\n" + cells,
          "line 5: by its count section $Nodes has 8 lines, but it has 4"},
         {"one-more.msh", replaced(cube, "$Nodes\n8", "$Nodes\n9"),
          "line 9: by its count section $Nodes has 9 lines, but it has 8"},
         {"one-less.msh", replaced(cube, "$Nodes\n8", "$Nodes\n7"),
          "line 9: by its count section $Nodes has 7 lines, but it has 8"},
         {"cells-more.msh", replaced(cube, "$Elements\n1", "$Elements\n2"),
          "line 20: by its count section $Elements has 2 lines, but it has 1"},
         {"cells-less.msh", replaced(cube, cell, cell + "2 5 2 1 1 1 2 3 4 5 6 7 8\n"),
          "line 20: by its count section $Elements has 1 lines, but it has 2"},
         {"negative-count.msh", replaced(cube, "$Nodes\n8", "$Nodes\n-8"),
          "line 9: section $Nodes does not begin with its count"},
         {"huge-count.msh", replaced(cube, "$Nodes\n8", "$Nodes\n999999999999999999"), "line 9: by its count"},
         {"huge-cells.msh", replaced(cube, "$Elements\n1", "$Elements\n999999999999999999"), "line 20: by its count"},
         {"huge-names.msh", replaced(cube, "$PhysicalNames\n1", "$PhysicalNames\n2000000000"),
          "line 5: by its count section $PhysicalNames"},
         {"nan.msh", replaced(cube, "8 0 100 100", "8 nan 100 100"), "a non-finite coordinate"},
         {"inf.msh", replaced(cube, "8 0 100 100", "8 0 1e999 100"), "a non-finite coordinate"},
         {"word.msh", replaced(cube, "8 0 100 100", "8 0 left 100"), "are incomplete or out of order"},
         {"huge-place.msh", replaced(cube, "8 0 100 100", "8 0 1e300 100"), "a non-finite coordinate"},
         {"no-node.msh", replaced(cube, " 6 7 8\n", " 6 7 9\n"), "the reader crashed"},
         {"zero-node.msh", replaced(cube, " 6 7 8\n", " 6 7 0\n"), "Wrong node index 0"},
         {"twice-a-node.msh", replaced(cube, "8 0 100 100", "7 0 100 100"), "Wrong node index 8"},
         {"same-node.msh", replaced(cube, " 6 7 8\n", " 6 7 7\n"), "inverted or flat cells"},
         {"flat.msh", all_replaced(cube, " 100\n", " 0\n"), "inverted or flat cells"},
         {"type-999.msh", replaced(cube, cell, "1 999 2 1 1 1 2 3 4 5 6 7 8\n"), "Unknown type of element 999"},
         {"type-negative.msh", replaced(cube, cell, "1 -5 2 1 1 1 2 3 4 5 6 7 8\n"), "Unknown type of element -5"},
         {"tags-huge.msh", replaced(cube, cell, "1 5 2000000000 1 1 1 2 3 4 5 6 7 8\n"),
          "are incomplete or out of order"},
         {"tags-negative.msh", replaced(cube, cell, "1 5 -2 1 1 1 2 3 4 5 6 7 8\n"), "inverted or flat cells"},
         {"views.msh", cube + "$NodeData\n2000000000\n\"x\"\n1\n0\n3\n0\n1\n2000000000\n1 1\n$EndNodeData\n",
          "are incomplete or out of order"}});
}

TEST_CASE("mesh files of the newer format and binary ones that are miscounted or nonsense are refused in words")
{
    expect_refused(
        "mesh",
        {{"blocks-4.msh", replaced(cube_4, "1 8 1 8", "999999999999 8 1 8"), "line 9: by its count"},
         {"nodes-4.msh", replaced(cube_4, "1 8 1 8", "1 999999999999999 1 999999999999999"), "line 9: by its count"},
         {"block-4.msh", replaced(cube_4, "3 1 0 8", "3 1 0 999999999999999"), "reading '"},
         {"negative-4.msh", replaced(cube_4, "1 8 1 8", "-1 -8 -1 -8"),
          "line 9: section $Nodes does not begin with its count"},
         {"entities-4.msh", replaced(cube_4, "0 0 0 1\n", "0 0 0 999999999999999\n"), "Could not read entities"},
         {"type-4.msh", replaced(cube_4, "3 1 5 1", "3 1 500 1"), "Unknown type of element 500"},
         {"no-node-4.msh", replaced(cube_4, "1 1 2 3 4 5 6 7 8", "1 1 2 3 4 5 6 7 88"), "Unknown node 88"},
         {"binary-mark.msh", binary_cube(77, false, 8, 1), "Unknown type of element"},
         {"binary-more.msh", binary_cube(1, false, 9, 1), "holds no solid cells"},
         {"binary-huge.msh", binary_cube(1, false, 2'000'000'000, 1), "are incomplete or out of order"},
         {"binary-cells.msh", binary_cube(1, false, 8, 2'000'000'000), "are incomplete or out of order"},
         {"binary-negative.msh", binary_cube(1, false, 8, -1), "holds no solid cells"},
         {"binary-cut.msh", binary_cube(1, false, 8, 1).substr(0, 200) + "\n$EndNodes\n",
          "are incomplete or out of order"},
         {"binary-noise.msh", "$MeshFormat\n2.2 1 8\n" + noise(5000) + "\n$EndNodes\n", "holds no solid cells"},
         {"text-as-binary.msh", replaced(cube, "2.2 0 8", "2.2 1 8"), "are incomplete or out of order"}});
}

TEST_CASE("STEP files that are cut or made of nonsense are refused in words")
{
    const auto plate = test_data("plate_with_hole.step");
    const std::string start =
        "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
        "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\n";
    const std::string end = "ENDSEC;\nEND-ISO-10303-21;\n";
    const auto instead = [&](const std::string& from, const std::string& to) { return replaced(plate, from, to); };
    expect_refused(
        "step",
        {{"empty.step", "", "is not a STEP file"},
         {"one.step", "I", "is not a STEP file"},
         {"zip.step", "PK\x03\x04" + noise(1000), "is not a STEP file"},
         {"utf-16.step", utf_16(plate), "is not a STEP file"},
         {"mesh.step", cube, "is not a STEP file"},
         {"iges.step", std::string(72, ' ') + "S      1\n", "is not a STEP file"},
         {"cut.step", plate.substr(0, plate.size() / 2), "cut short"},
         {"cut-with-end.step", plate.substr(0, plate.size() / 2) + "\n" + end, "are incomplete or out of order"},
         {"no-data.step", start + end, "are incomplete or out of order"},
         {"only-words.step", "ISO-10303-21; END-ISO-10303-21;", "are incomplete or out of order"},
         {"no-solid.step", instead("#15 = MANIFOLD_SOLID_BREP('',#16);", ""), "holds no solid"},
         {"no-shell.step", instead("MANIFOLD_SOLID_BREP('',#16)", "MANIFOLD_SOLID_BREP('',#99999)"), "holds no solid"},
         {"itself.step", instead("MANIFOLD_SOLID_BREP('',#16)", "MANIFOLD_SOLID_BREP('',#15)"), "holds no solid"},
         {"circle.step", instead("CLOSED_SHELL('',(#17,", "CLOSED_SHELL('',(#16,"), "holds no solid"},
         {"open-shell.step", instead("(#17,#137,#213,", "("), "holds no solid"},
         {"huge-number.step", instead("#15 = ", "#99999999999999999999 = "), "holds no solid"},
         {"nan.step", all_replaced(plate, "(-50.,-30.,0.)", "(nan,-30.,0.)"),
          "line 35: a word is found where a value is expected"},
         {"infinite.step", all_replaced(plate, "(-50.,-30.,0.)", "(-50.,1.E999,0.)"), "holds no solid"},
         {"far.step", all_replaced(plate, "-50.", "-5.E300"), "holds no solid"},
         {"deep.step",
          instead("MANIFOLD_SOLID_BREP('',#16)",
                  "MANIFOLD_SOLID_BREP('',#16" + std::string(200'000, '(') + std::string(200'000, ')') + ")"),
          "holds no solid"},
         {"noise.step", start + noise(20000) + end, "are incomplete or out of order"},
         {"script.step", start + commands + end, "are incomplete or out of order"}});
}

TEST_CASE("a STEP file that refers to another is refused, whether the other is there or not")
{
    const auto refers = test_data("box_in_another_file.step");  // Open CASCADE follows it
    const std::string stopped = "was stopped: it wants to open another file, '";
    const Target target;
    target.folder.file("ext_box.stp", test_data("plate_with_hole.step"));
    for (const auto* other : {"ext_box.stp", "missing.stp", "/etc/passwd", "../../../etc/passwd", "home/.gmshrc"}) {
        CAPTURE(other);
        target.folder.file("plate.step", all_replaced(refers, "ext_box.stp", other));
        const auto outcome = target.check("step", "plate.step");
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.text, stopped));
    }
}

TEST_CASE("what is no file, or not of the case, is refused at once")
{
    const Target target;
    fs::create_directory(target.folder.path / "folder.msh");
    REQUIRE(mkfifo((target.folder.path / "pipe.msh").c_str(), 0600) == 0);
    fs::create_symlink("missing", target.folder.path / "dangling.msh");
    fs::create_symlink("circle.msh", target.folder.path / "circle.msh");
    for (const auto* key : {"mesh", "step"}) {
        for (const auto* name : {"folder.msh", "pipe.msh", "dangling.msh", "circle.msh", "missing.msh"}) {
            CAPTURE(name);
            const auto outcome = target.check(key, name);
            CAPTURE(outcome.text);
            CHECK(outcome.code == 2);
            CHECK(has(outcome.text, "error[missing-file]: parts.plate."));
        }
    }
    fs::create_symlink("/dev/zero", target.folder.path / "device.msh");
    fs::create_symlink("/etc/passwd", target.folder.path / "link.msh");
    for (const auto* name : {"device.msh", "link.msh", "/dev/zero", "../../../../../../etc/passwd"}) {
        CAPTURE(name);
        const auto outcome = target.check("mesh", name);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.text, "outside"));
    }
}
