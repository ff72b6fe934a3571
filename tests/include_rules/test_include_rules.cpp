#include "include_rules.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <random>

namespace fs = std::filesystem;

namespace {

/// A small source tree in a temporary folder.
struct Tree {
    fs::path root = fs::temp_directory_path() / ("deadpoint-rules-" + std::to_string(std::random_device{}()));
    ~Tree() { fs::remove_all(root); }
    void add(const std::string& file, const std::string& text) const
    {
        fs::create_directories((root / file).parent_path());
        std::ofstream(root / file) << text;
    }
};

/// The one violation that a single file with the given text causes.
std::string violation(const std::string& file, const std::string& text)
{
    const Tree tree;
    tree.add(file, text);
    const auto found = include_violations(tree.root);
    return found.size() == 1 ? found.front() : std::to_string(found.size()) + " violations";
}

}  // namespace

TEST_CASE("the project's own sources keep the rules")
{
    REQUIRE(fs::exists(fs::path(DEADPOINT_SOURCE_DIR) / "src/deadpoint/core/vec.hpp"));
    for (const auto& text : include_violations(DEADPOINT_SOURCE_DIR)) {
        FAIL_CHECK(text);
    }
}

TEST_CASE("a tree that keeps the rules passes")
{
    const Tree tree;
    tree.add("src/deadpoint/core/a.hpp", "#include <vector>\n");
    tree.add("src/deadpoint/exchange/b.hpp", "#include \"deadpoint/core/a.hpp\"\n");
    tree.add("src/deadpoint/fem/c.hpp", "#include <petscvec.h>\n#include <mpi.h>\n");
    tree.add("src/deadpoint/fem/c.cpp", "#include \"deadpoint/fem/c.hpp\"\n#include <petscksp.h>\n");
    tree.add("src/deadpoint/machine/d.cpp", "#include \"deadpoint/exchange/b.hpp\"\n#include <gmsh.h>\n");
    tree.add("src/deadpoint/full/e.hpp", "#include \"deadpoint/exchange/b.hpp\"\n");
    tree.add("include/deadpoint/error.hpp", "#include <string>\n");
    tree.add("include/deadpoint/press.hpp", "#include \"deadpoint/error.hpp\"\n");
    tree.add("src/deadpoint/core/f.hpp", "#include \"deadpoint/error.hpp\"\n");
    tree.add("src/deadpoint/api/g.cpp", "#include \"deadpoint/press.hpp\"\n#include \"deadpoint/full/e.hpp\"\n");
    tree.add("app/console.hpp", "#include <spdlog/spdlog.h>\n");
    tree.add("app/main.cpp", "#include \"console.hpp\"\n#include \"deadpoint/full/e.hpp\"\n#include <CLI/CLI.hpp>\n");
    CHECK(include_violations(tree.root).empty());
}

TEST_CASE("each planted violation is found, with file and line")
{
    CHECK(violation("src/deadpoint/core/a.cpp", "\n#include \"deadpoint/exchange/machine.hpp\"\n") ==
          "src/deadpoint/core/a.cpp:2: 'core' may not include 'exchange' (deadpoint/exchange/machine.hpp)");
    CHECK(violation("src/deadpoint/drift/a.cpp", "#include \"deadpoint/mechanism/x.hpp\"\n") ==
          "src/deadpoint/drift/a.cpp:1: 'drift' may not include 'mechanism' (deadpoint/mechanism/x.hpp)");
    CHECK(violation("src/deadpoint/fem/a.cpp", "#include \"deadpoint/casefile/describe/case.hpp\"\n")
              .find("'fem' may not") != std::string::npos);
    CHECK(
        violation("src/deadpoint/report/a.cpp", "#include \"../../../app/console.hpp\"\n").find("write own headers") !=
        std::string::npos);
    CHECK(violation("src/deadpoint/full/a.cpp", "  #  include <mpi.h>\n") ==
          "src/deadpoint/full/a.cpp:1: <mpi.h> may be included only in 'fem'");
    CHECK(violation("src/deadpoint/drift/a.cpp", "#include <petscmat.h>\n").find("only in 'fem'") != std::string::npos);
    CHECK(violation("app/a.cpp", "#include <gmsh.h>\n").find("only in 'machine'") != std::string::npos);
    CHECK(violation("src/deadpoint/machine/a.cpp", "#include <toml++/toml.h>\n").find("only in 'casefile'") !=
          std::string::npos);
    CHECK(violation("src/deadpoint/report/a.cpp", "#include <spdlog/spdlog.h>\n").find("only in 'app'") !=
          std::string::npos);
    CHECK(violation("src/deadpoint/novel/a.cpp", "#include \"deadpoint/core/vec.hpp\"\n").find("has no rule") !=
          std::string::npos);
}

TEST_CASE("public headers show nothing but the standard library and themselves")
{
    CHECK(violation("include/deadpoint/a.hpp", "#include <mpi.h>\n") ==
          "include/deadpoint/a.hpp:1: public headers include the standard library only, not <mpi.h>");
    CHECK(violation("include/deadpoint/a.hpp", "#include \"deadpoint/core/vec.hpp\"\n") ==
          "include/deadpoint/a.hpp:1: 'include' may not include 'core' (deadpoint/core/vec.hpp)");
    CHECK(violation("src/deadpoint/full/a.cpp", "#include \"deadpoint/press.hpp\"\n") ==
          "src/deadpoint/full/a.cpp:1: 'full' may not include 'include' (deadpoint/press.hpp)");
}

TEST_CASE("a cycle is found, also through a third file")
{
    const Tree tree;
    tree.add("src/deadpoint/core/a.hpp", "#include \"deadpoint/core/b.hpp\"\n");
    tree.add("src/deadpoint/core/b.hpp", "#include \"deadpoint/core/c.hpp\"\n");
    tree.add("src/deadpoint/core/c.hpp", "#include <vector>\n#include \"deadpoint/core/a.hpp\"\n");
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == "src/deadpoint/core/c.hpp:2: cycle of includes: src/deadpoint/core/a -> "
                           "src/deadpoint/core/b -> src/deadpoint/core/c -> src/deadpoint/core/a");
}

TEST_CASE("a cycle through a source is found: units are a header and its source")
{
    const Tree tree;
    tree.add("src/deadpoint/core/a.hpp", "#include <vector>\n");
    tree.add("src/deadpoint/core/a.cpp", "#include \"deadpoint/core/a.hpp\"\n#include \"deadpoint/core/b.hpp\"\n");
    tree.add("src/deadpoint/core/b.hpp", "#include \"deadpoint/core/a.hpp\"\n");
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == "src/deadpoint/core/b.hpp:1: cycle of includes: src/deadpoint/core/a -> "
                           "src/deadpoint/core/b -> src/deadpoint/core/a");
}

TEST_CASE("a cycle between rooms is found where no two files form one")
{
    const Tree tree;
    tree.add("src/deadpoint/fem/space/a.hpp", "#include <vector>\n");
    tree.add("src/deadpoint/fem/space/b.cpp", "#include \"deadpoint/fem/elastic/c.hpp\"\n");
    tree.add("src/deadpoint/fem/elastic/c.hpp", "#include <vector>\n");
    CHECK(include_violations(tree.root).empty());
    tree.add("src/deadpoint/fem/elastic/d.cpp", "#include \"deadpoint/fem/space/a.hpp\"\n");
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == "src/deadpoint/fem/space/b.cpp:1: cycle of includes: src/deadpoint/fem/elastic -> "
                           "src/deadpoint/fem/space -> src/deadpoint/fem/elastic");
}

TEST_CASE("a library seen through a header may not leave its folder")
{
    const Tree tree;
    tree.add("src/deadpoint/fem/a.hpp", "#include <petscvec.h>\n");
    tree.add("src/deadpoint/fem/b.hpp", "#include \"deadpoint/fem/a.hpp\"\n");
    tree.add("src/deadpoint/fem/b.cpp", "#include \"deadpoint/fem/b.hpp\"\n");
    CHECK(include_violations(tree.root).empty());
    tree.add("src/deadpoint/full/c.cpp", "#include <vector>\n#include \"deadpoint/fem/b.hpp\"\n");
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == "src/deadpoint/full/c.cpp:2: 'deadpoint/fem/b.hpp' shows a library's header and is "
                           "therefore internal to 'fem'");
}

TEST_CASE("a header that reaches twenty others is too wide; nineteen are allowed, however they are reached")
{
    const Tree tree;
    for (int i = 0; i < 20; ++i) {
        const auto next = "#include \"deadpoint/core/h" + std::to_string(i + 1) + ".hpp\"\n";
        tree.add("src/deadpoint/core/h" + std::to_string(i) + ".hpp", i < 19 ? next : "#include <vector>\n");
    }
    CHECK(include_violations(tree.root).empty());
    tree.add("src/deadpoint/core/wide.hpp", "#include \"deadpoint/core/h0.hpp\"\n");
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 1);
    CHECK(found.front() ==
          "src/deadpoint/core/wide.hpp:1: reaches 20 own headers; declare what the header only mentions");
}

TEST_CASE("a folder of twenty-six files is too full")
{
    const Tree tree;
    for (int i = 0; i < 25; ++i) {
        tree.add("src/deadpoint/core/room/f" + std::to_string(i) + ".cpp", "#include <vector>\n");
    }
    tree.add("src/deadpoint/core/beside.cpp", "#include <vector>\n");
    CHECK(include_violations(tree.root).empty());
    tree.add("src/deadpoint/core/room/more.hpp", "#include <vector>\n");
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == "src/deadpoint/core/room:1: holds 26 files; divide it into rooms");
}

TEST_CASE("a comparison that adds 1 to its scale is found in tests; words that only contain its name are not")
{
    const Tree tree;
    tree.add("tests/unit/near.cpp", "CHECK(a.isApprox(b, 1e-9));\nCHECK(a == near(b, 1e-9));  // not Approx\n");
    CHECK(include_violations(tree.root).empty());
    tree.add("tests/unit/loose.cpp", std::string("#include <vector>\nCHECK(a == doctest::Appr") + "ox(b).scale(0));\n");
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 1);
    CHECK(found.front() == "tests/unit/loose.cpp:2: Approx adds 1 to its scale; compare with near() of tests/near.hpp");
}

TEST_CASE("a comment that begins with \"Of\" is found in sources, bindings and tests; one that goes on so is not")
{
    const std::string planted = std::string("/") + "/ Of a run.\n";
    const std::string fault = "a comment begins with \"Of\"; begin with the noun or verb that it is about";
    const Tree tree;
    tree.add("src/deadpoint/core/a.hpp", "// Heat of a run.\n" + planted + "int heat = 0;  ///< of the body\n");
    CHECK(include_violations(tree.root).empty());
    tree.add("src/deadpoint/core/b.hpp", "#include <vector>\n" + planted);
    tree.add("tests/unit/c.cpp", "int heat = 0;  /" + planted);
    const auto found = include_violations(tree.root);
    REQUIRE(found.size() == 2);
    CHECK(found.front() == "src/deadpoint/core/b.hpp:2: " + fault);
    CHECK(found.back() == "tests/unit/c.cpp:1: " + fault);
    for (const char* file : {"include/deadpoint/a.hpp", "app/a.cpp", "python/bindings/a.cpp"}) {
        CHECK(violation(file, "/" + planted) == file + (":1: " + fault));
        CHECK(violation(file, std::string("/") + "** Of a run. */\n") == file + (":1: " + fault));
    }
}
