/// Requirement: whatever goes wrong, the program says what, where and what to do, ends with the code of that kind of
/// error, and leaves no file that reads as whole.
#include "command.hpp"
#include "near.hpp"
#include "plate_case.hpp"

#include <doctest/doctest.h>

namespace {

const std::string starter = DEADPOINT_SOURCE_DIR "/cases/starter/case.toml --size 3 --set output.fields=false";
const std::string two_blocks = DEADPOINT_TEST_DATA "/cli/two-blocks.toml";

std::uintmax_t size_of(const fs::path& folder)
{
    std::uintmax_t size = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        size += entry.is_regular_file() ? entry.file_size() : 0;
    return size;
}

}  // namespace

TEST_CASE("a full disk is exit code 5 with the file's name, and leaves nothing behind")
{
    const ScratchFolder folder;
    const auto target = (folder.path / "result").string();
    for (const long long room : {0LL, 5'000LL, 12'000LL}) {
        CAPTURE(room);
        const auto outcome = run(short_disk(room, false), fmt::format("run {} -o {}", two_blocks, target));
        CHECK(outcome.code == 5);
        CHECK(has(outcome.text, "No space left on device"));
        CHECK(has(outcome.text, "cannot write '" + target));
        CHECK(fs::is_empty(folder.path));
    }
}

TEST_CASE("a disk too full for the page keeps the results and says what is missing")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto outcome = run(short_disk(200'000, false), fmt::format("run {} -o {}", two_blocks, target.string()));
    CHECK(outcome.code == 0);
    CHECK(has(outcome.text, "report.html is missing"));
    CHECK_FALSE(has(outcome.text, "see them on a page"));
    CHECK(fs::exists(target / "summary.json"));
    CHECK_FALSE(fs::exists(target / "report.html"));
}

TEST_CASE("a run that is killed leaves a whole result or none, and the same command then goes through")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto line = fmt::format("run {} -o {} --force", two_blocks, target.string());
    REQUIRE(run("", line).code == 0);
    const auto whole = static_cast<long long>(size_of(target));
    for (int i = 0; i < kills(); ++i) {
        CAPTURE(i);
        fs::remove_all(target);
        const auto outcome = run(short_disk(whole * i / kills(), true), line);
        CHECK(outcome.code == 137);
        CHECK_FALSE(fs::exists(target));  // it is named once it is whole
    }
    CHECK(run("", line).code == 0);
    CHECK(static_cast<double>(size_of(target)) == near(static_cast<double>(whole), 0.01));  // timings differ
}

TEST_CASE("killed while it replaces a result, the old one or the new one is there")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const auto line = fmt::format("run {} -o {} --force", two_blocks, target.string());
    REQUIRE(run("", line).code == 0);
    const auto before = content(target / "history.csv");
    CHECK(run(short_disk(100'000, true), line).code == 137);
    CHECK(content(target / "history.csv") == before);
}

TEST_CASE("a folder that cannot be made is exit code 5 before anything is computed")
{
    const auto outcome = run("", "run " + two_blocks + " -o /proc/deadpoint/result");
    CHECK(outcome.code == 5);
    CHECK(has(outcome.text, "/proc/deadpoint"));
    CHECK_FALSE(has(outcome.text, "time steps"));
}

TEST_CASE("broken mesh and STEP files are exit code 2 with the part and the file")
{
    const auto check = [](const std::string& key, const std::string& name, const std::string& text) {
        const ScratchFolder folder;
        folder.file(name, text);
        return run("", "check " + plate_case(folder, key, name));
    };
    const auto mesh = test_data("tilted_plate.msh");
    const auto step = test_data("plate_with_hole.step");

    const auto half_mesh = check("mesh", "half.msh", mesh.substr(0, mesh.size() / 2));
    CHECK(half_mesh.code == 2);
    CHECK(has(half_mesh.text, "part 'plate'"));
    CHECK(has(half_mesh.text, "cut short"));

    const auto half_step = check("step", "half.step", step.substr(0, step.size() / 2));
    CHECK(half_step.code == 2);
    CHECK(has(half_step.text, "cut short"));

    std::string noise;
    for (int i = 0; i < 5000; ++i)
        noise += static_cast<char>(i * 7919);
    for (const auto* key : {"mesh", "step"}) {
        const auto outcome = check(key, key == std::string("mesh") ? "noise.msh" : "noise.step", noise);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.text, "part 'plate'"));
    }
    auto nowhere = mesh;
    const auto nodes = nowhere.find("$Nodes");
    REQUIRE(nodes != std::string::npos);
    const auto dot = nowhere.find("0.0", nodes);
    if (dot != std::string::npos) {
        nowhere.replace(dot, 3, "nan");
        CHECK(check("mesh", "nan.msh", nowhere).code == 2);
    }
}

TEST_CASE("a STEP file in inches is read in inches")
{
    auto step = test_data("plate_with_hole.step");
    const std::string millimetre = "( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )";
    const auto at = step.find(millimetre);
    REQUIRE(at != std::string::npos);
    const auto plan_of = [](const std::string& text) {
        const ScratchFolder folder;
        folder.file("plate.step", text);
        return run("", "check " + plate_case(folder, "step", "plate.step"));
    };
    const auto plain = plan_of(step);
    step.replace(at, millimetre.size(), "( CONVERSION_BASED_UNIT('INCH',#9001) LENGTH_UNIT() NAMED_UNIT(#9000) )");
    const std::string inch = "#9000 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n#9001 = LENGTH_MEASURE_WITH_UNIT("
                             "LENGTH_MEASURE(25.4),#9002);\n#9002 = ( LENGTH_UNIT() NAMED_UNIT(*) "
                             "SI_UNIT(.MILLI.,.METRE.) );\n";
    step.insert(step.rfind("ENDSEC;"), inch);
    const auto in_inches = plan_of(step);
    REQUIRE(plain.code == 0);
    REQUIRE(in_inches.code == 0);
    // 25.4^3; the hole has coarser facets in the small plate, whose cells are as large, which leaves 0.7 %.
    CHECK(plate_mass(in_inches.text) / plate_mass(plain.text) == near(16387.06, 0.01));
}

TEST_CASE("a solver that does not converge is exit code 4 with its name, and leaves no result")
{
    const ScratchFolder folder;
    const auto line = fmt::format("run {} -o {}", starter, (folder.path / "result").string());
    const auto heat = run("PETSC_OPTIONS='-heat_ksp_type richardson -heat_pc_type none'", line);
    CHECK(heat.code == 4);
    CHECK(has(heat.text, "did not converge for the temperature field"));
    const auto deformation = run("PETSC_OPTIONS='-deformation_pc_type jacobi -deformation_ksp_max_it 3'", line);
    CHECK(deformation.code == 4);
    CHECK(has(deformation.text, "did not converge for the deformation"));
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a time step that collapses is exit code 4 with the time")
{
    const ScratchFolder folder;
    // The solver's errors exceed what is asked of the steps, however small they are.
    const auto outcome = run("", fmt::format("run {} -o {} --set 'numerics.time_tolerance=1e-13 K' --set "
                                             "numerics.solver_tolerance=1e-3",
                                             starter, (folder.path / "result").string()));
    CHECK(outcome.code == 4);
    CHECK(has(outcome.text, "the time step collapsed below 1 us at t = "));
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a process that dies under MPI ends the others, and leaves no result")
{
    const ScratchFolder folder;
    const auto program =
        folder.file("second-dies", "#!/bin/sh\nif [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then exec timeout -s "
                                   "KILL 1.5 \"$@\"; fi\nexec \"$@\"\n");
    fs::permissions(program, fs::perms::owner_all);
    const auto target = folder.path / "result";
    const auto outcome =
        run(fmt::format("timeout -k 5 120 {} -n 2 --oversubscribe {}", DEADPOINT_MPIRUN, program.string()),
            fmt::format("run {}/cases/starter/case.toml --size 0.5 -o {}", DEADPOINT_SOURCE_DIR, target.string()));
    CHECK(outcome.code == 137);  // of the one that was killed; the time limit's would be 124
    CHECK(has(outcome.text, "signal 9"));
    CHECK_FALSE(fs::exists(target));
}

TEST_CASE("numbers that are none in a table are refused with line and remedy")
{
    const ScratchFolder folder;
    auto text = content(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml");
    text += "\n[lubricants.bad]\nviscosity = [[\"20 degC\", \"nan mm2/s\"], [\"40 degC\", \"32 mm2/s\"]]\n";
    const auto outcome = run("", "check " + folder.file("case.toml", text).string());
    CHECK(outcome.code == 2);
    CHECK(has(outcome.text, "case.toml:"));
    CHECK(has(outcome.text, "lubricants.bad.viscosity"));
}

TEST_CASE("a limit of memory too low for any case is exit code 2, in words and at once")
{
    const ScratchFolder folder;
    const auto line = fmt::format("run {} -o {}", two_blocks, (folder.path / "result").string());
    const auto outcome = run("ulimit -v 700000; timeout 60", line);
    CHECK(outcome.code == 2);
    CHECK(has(outcome.text, "error: the memory that this program may address is limited to 0.72 GB"));
    CHECK(has(outcome.text, "ulimit -v unlimited"));
    CHECK(fs::is_empty(folder.path));
}
