/// Requirement: a run on several ranks that the program has started itself answers as one process does: one message,
/// the same exit codes and files, whatever ends it; and where ranks cannot be started, one process computes.
#include "command.hpp"

#include <chrono>
#include <csignal>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <thread>
#include <unistd.h>
#include <vector>

using namespace std::chrono_literals;

namespace {

const std::string starter = DEADPOINT_SOURCE_DIR "/cases/starter/case.toml --size 3 --set output.fields=false";
/// Takes a minute, so that it never ends by itself.
const std::string long_run = starter + " --set 'numerics.max_step=5 s'";

/// The program at work in a group of processes of its own; its text goes to files.
class Running {
public:
    Running(const ScratchFolder& folder, const std::string& arguments) : folder_(folder)
    {
        const auto line = fmt::format("exec {} {} >{} 2>{} </dev/null", DEADPOINT_COMMAND, arguments, out(), err());
        process = fork();
        if (process == 0) {
            setpgid(0, 0);
            execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
            _exit(127);
        }
    }
    [[nodiscard]] std::string out() const { return (folder_.path / "out").string(); }
    [[nodiscard]] std::string err() const { return (folder_.path / "err").string(); }
    /// Waits for a stage, and a little longer.
    void wait_for(const std::string& stage) const
    {
        for (int i = 0; i < 600 && !has(content(err()), stage); ++i)
            std::this_thread::sleep_for(50ms);
        REQUIRE(has(content(err()), stage));
        std::this_thread::sleep_for(300ms);
    }
    /// As a shell shows it.
    [[nodiscard]] int end() const
    {
        int status = 0;
        waitpid(process, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    /// Processes that it has started, ranks first and mpirun with them.
    [[nodiscard]] std::vector<pid_t> children() const
    {
        std::vector<pid_t> found;
        std::ifstream in(fmt::format("/proc/{0}/task/{0}/children", process));
        for (pid_t child = 0; in >> child;)
            found.push_back(child);
        return found;
    }

    pid_t process = 0;

private:
    const ScratchFolder& folder_;
};

bool lives(pid_t process) { return kill(process, 0) == 0; }

/// Ended within some seconds; a process that others have left may be a zombie of init for a moment.
bool all_end(const std::vector<pid_t>& processes)
{
    for (int i = 0; i < 100; ++i) {
        bool any = false;
        for (const auto process : processes)
            any = any || (lives(process) && !has(content(fmt::format("/proc/{}/stat", process)), ") Z "));
        if (!any)
            return true;
        std::this_thread::sleep_for(50ms);
    }
    return false;
}

std::size_t count(const std::string& text, const std::string& piece)
{
    std::size_t found = 0;
    for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1))
        ++found;
    return found;
}

}  // namespace

TEST_CASE("two ranks give the text and the files of one process")
{
    const ScratchFolder folder;
    const auto at = [&](const char* name) { return (folder.path / name).string(); };
    const auto line = [&](int ranks, const char* name) {
        return fmt::format("run {} -q --set 'operation.0.duration=10 min' --ranks {} -o {}", starter, ranks, at(name));
    };
    const auto one = run("", line(1, "one")), two = run("", line(2, "two"));
    CHECK(one.code == 0);
    CHECK(two.code == 0);
    CHECK(has(content(folder.path / "one/summary.json"), "\"ranks\": 1"));
    CHECK(has(content(folder.path / "two/summary.json"), "\"ranks\": 2"));
    // As many lines: nothing is said by each rank.
    CHECK(count(two.text, "\n") == count(one.text, "\n"));
    for (const auto& entry : fs::directory_iterator(folder.path / "one"))
        CHECK_MESSAGE(fs::exists(folder.path / "two" / entry.path().filename()), entry.path().filename().string());
    CHECK_FALSE(fs::exists(at("two.lock")));
}

TEST_CASE("SIGINT to the program, or to all of its group, ends a run of two ranks after its step")
{
    for (const bool group : {false, true}) {
        CAPTURE(group);
        const ScratchFolder folder;
        const auto target = folder.path / "result";
        const Running program(folder, fmt::format("run {} --ranks 2 -o {}", long_run, target.string()));
        program.wait_for("time steps");
        const auto children = program.children();
        REQUIRE(children.size() == 3);  // mpirun and two ranks
        kill(group ? -program.process : program.process, SIGINT);
        CHECK(program.end() == 130);
        const auto text = content(program.err());
        CHECK(count(text, "stopping after this step") == 1);
        CHECK_FALSE(has(text, "error"));
        CHECK(has(content(program.out()), "with --resume continues from there"));
        CHECK(fs::exists(target / "summary.json"));
        CHECK(fs::exists(target.string() + ".checkpoint"));
        CHECK(all_end(children));
    }
}

TEST_CASE("a second SIGINT ends all ranks at once")
{
    const ScratchFolder folder;
    const Running program(folder, fmt::format("run {} --ranks 2 -o {}/result", long_run, folder.path.string()));
    program.wait_for("dimension chain");
    const auto children = program.children();
    kill(program.process, SIGINT);
    std::this_thread::sleep_for(20ms);
    kill(program.process, SIGINT);
    CHECK(program.end() == 130);
    CHECK(all_end(children));
}

TEST_CASE("a rank that is killed ends the others: one message, no results")
{
    const ScratchFolder folder;
    const auto target = folder.path / "result";
    const Running program(folder, fmt::format("run {} --ranks 2 -o {}", long_run, target.string()));
    program.wait_for("time steps");
    const auto children = program.children();
    REQUIRE(children.size() == 3);
    kill(children.back(), SIGKILL);
    CHECK(program.end() == 137);
    const auto text = content(program.err());
    CHECK(count(text, "error: ") == 1);
    CHECK(has(text, "one of 2 ranks, process"));
    CHECK(has(text, "was ended by signal 9 (Killed)"));
    CHECK(has(text, "--ranks 1"));
    CHECK_FALSE(fs::exists(target));
    CHECK_FALSE(fs::exists(target.string() + ".lock"));
    CHECK(all_end(children));
}

TEST_CASE("ranks and mpirun do not outlive a program that is killed")
{
    const ScratchFolder folder;
    const Running program(folder, fmt::format("run {} --ranks 2 -o {}/result", long_run, folder.path.string()));
    program.wait_for("time steps");
    const auto children = program.children();
    REQUIRE(children.size() == 3);
    kill(program.process, SIGKILL);
    CHECK(program.end() == 137);
    CHECK(all_end(children));
}

TEST_CASE("an error that ranks find is shown once, with its exit code")
{
    const ScratchFolder folder;
    const auto line = fmt::format("run {} --ranks 2 -o {}/result", starter, folder.path.string());
    const auto outcome = run("PETSC_OPTIONS='-heat_ksp_type richardson -heat_pc_type none'", line);
    CHECK(outcome.code == 4);
    CHECK(count(outcome.text, "error: ") == 1);
    CHECK(has(outcome.text, "did not converge for the temperature field"));
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("where no ranks can be started one process computes, and says so with --verbose")
{
    const ScratchFolder folder;
    const auto silent = folder.file("mpirun", "#!/bin/sh\nexit 3\n");
    const auto alone = folder.file("alone", "#!/bin/sh\nshift 2\nfor i in 1 2; do env -u OMPI_COMM_WORLD_SIZE \"$@\" & "
                                            "done\nwait\n");
    for (const auto& file : {silent, alone})
        fs::permissions(file, fs::perms::owner_all);
    // Missing, failing, and one that starts processes which are ranks of nothing.
    for (const auto& program : {folder.path / "none", silent, alone}) {
        CAPTURE(program.string());
        const auto target = folder.path / "result";
        const auto line = fmt::format("run {} --set 'operation.0.duration=1 min' --ranks 2 -v --force -o {}", starter,
                                      target.string());
        const auto outcome = run(fmt::format("DEADPOINT_MPIRUN={}", program.string()), line);
        CHECK(outcome.code == 0);
        CHECK(has(outcome.text, "one process computes, since no 2 ranks could be started: "));
        CHECK(has(content(target / "summary.json"), "\"ranks\": 1"));
    }
}

TEST_CASE("commands that solve no field, and bad input, start no ranks")
{
    const ScratchFolder folder;
    const auto trace = folder.path / "started";
    const auto mpirun = folder.file("mpirun", fmt::format("#!/bin/sh\ntouch {}\nexit 1\n", trace.string()));
    fs::permissions(mpirun, fs::perms::owner_all);
    const auto before = fmt::format("DEADPOINT_RANKS=2 DEADPOINT_MPIRUN={}", mpirun.string());
    const auto target = (folder.path / "result").string();
    const auto wrong = folder.file("case.toml", "format = 1\n");
    CHECK(run(before, "--help").code == 0);
    CHECK(run(before, "check -q " + starter).code == 0);
    CHECK(run(before, fmt::format("loads {} -o {}", starter, target)).code == 0);
    CHECK(run(before, fmt::format("run {} -o {}", wrong.string(), target)).code == 2);
    CHECK(run(before, fmt::format("run {} -o {}", starter, target)).code == 5);  // the folder is there
    CHECK_FALSE(fs::exists(trace));
    CHECK(run(before, fmt::format("run {} --set 'operation.0.duration=1 min' -o {}2", starter, target)).code == 0);
    CHECK(fs::exists(trace));
}

TEST_CASE("a number of ranks that cannot be meant is exit code 2")
{
    const ScratchFolder folder;
    const auto line = fmt::format("run {} -o {}/result", starter, folder.path.string());
    CHECK(run("", line + " --ranks 0").code == 2);
    const auto variable = run("DEADPOINT_RANKS=two", line);
    CHECK(variable.code == 2);
    CHECK(has(variable.text, "DEADPOINT_RANKS is 'two'"));
    const auto both = run("OMPI_COMM_WORLD_SIZE=2 PMIX_RANK=0", line + " --ranks 3");
    CHECK(both.code == 2);
    CHECK(has(both.text, "--ranks 3 was given, but this program was started on 2 ranks"));
    CHECK(fs::is_empty(folder.path));
}

TEST_CASE("a study of fewer points than cores runs each on the ranks that are wanted")
{
    const ScratchFolder folder;
    const auto study = folder.file(
        "study.toml", fmt::format("format = 1\nname = \"one\"\nbase = \"{}/cases/starter/case.toml\"\nset = "
                                  "[\"operation.0.duration=1 min\"]\n[[sets]]\nname = \"speeds\"\n[[sets.axes]]\nkey = "
                                  "\"operation.0.speed\"\nvalues = [\"50 rpm\"]\n",
                                  DEADPOINT_SOURCE_DIR));
    const auto target = folder.path / "study";
    const auto outcome =
        run("", fmt::format("sweep {} --allow-outside --size 3 --ranks 2 -o {}", study.string(), target.string()));
    CHECK(outcome.code == 0);
    CHECK(has(content(target / "points/speed=50_rpm/summary.json"), "\"ranks\": 2"));
    CHECK(fs::exists(target / "report.html"));
}

TEST_CASE("one process needs neither PATH nor a folder for temporary files nor sound settings of MPI")
{
    const ScratchFolder folder;
    const auto line = fmt::format("run -q {}/cli/two-blocks.toml --ranks 1 --force -o {}/result", DEADPOINT_TEST_DATA,
                                  folder.path.string());
    const auto usual = run("", line);
    REQUIRE(usual.code == 0);
    for (const char* settings :
         {"PATH=", "env -u PATH", "TMPDIR=/no/such/folder", "TMPDIR=/proc", "TMPDIR=", "OMPI_MCA_pml=nonsense",
          "OMPI_MCA_btl=nonsense", "OMPI_MCA_coll=nonsense", "OMPI_MCA_ess=nonsense", "OMPI_MCA_shmem=nonsense",
          "OMPI_MCA_mpi_param_check=nonsense", "OPAL_PREFIX=/no/such/folder", "PMIX_MCA_gds=nonsense",
          "PMIX_SERVER_URI2=nonsense", "PMIX_NAMESPACE=nonsense", "HOME=/no/such/folder"}) {
        CAPTURE(settings);
        const auto outcome = run(settings, line);
        CHECK(outcome.code == 0);
        CHECK(count(outcome.text, "\n") == count(usual.text, "\n"));
    }
    CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("what mpirun left in the environment, and too few open files, are refused in one sentence")
{
    const ScratchFolder folder;
    const auto line =
        fmt::format("run -q {}/cli/two-blocks.toml -o {}/result", DEADPOINT_TEST_DATA, folder.path.string());
    for (const char* settings :
         {"PMIX_RANK=0", "PMIX_RANK=nonsense", "OMPI_COMM_WORLD_SIZE=2 OMPI_COMM_WORLD_RANK=0",
          "PMIX_RANK=0 PMIX_NAMESPACE=n PMIX_SERVER_URI2=u PMIX_SERVER_TMPDIR=/no/such/folder"}) {
        CAPTURE(settings);
        const auto outcome = run(settings, line);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.text, "error: the environment says that mpirun started this program"));
        CHECK(has(outcome.text, "env -u OMPI_COMM_WORLD_SIZE -u PMIX_RANK"));
        CHECK(count(outcome.text, "\n") == 2);
    }
    for (const int files : {16, 20, 40}) {
        const auto outcome = run(fmt::format("ulimit -n {};", files), line);
        CHECK(outcome.code == 2);
        CHECK(has(outcome.text, fmt::format("open at a time is limited to {}, fewer than the 48", files)));
        CHECK(has(outcome.text, "ulimit -n 1024"));
        CHECK(count(outcome.text, "\n") == 2);
    }
    CHECK(run("ulimit -n 48;", line).code == 0);           // so many are enough
    CHECK(run("ulimit -S -n 20;", line + "2").code == 0);  // what the user may raise is raised
    CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 2);
}

TEST_CASE("ranks leave nothing among the temporary files, whether they can be started there or not")
{
    const ScratchFolder folder;
    const auto temporary = folder.path / "tmp";
    fs::create_directories(temporary);
    const auto line = fmt::format("run {} --set 'operation.0.duration=1 min' --ranks 2 --force -o {}/result", starter,
                                  folder.path.string());
    const auto ranks_of = [&](const std::string& settings) {
        const auto outcome = run(settings, line);
        CAPTURE(settings);
        CAPTURE(outcome.text);
        CHECK(outcome.code == 0);
        CHECK_FALSE(has(outcome.text, "-----"));  // of pages of Open MPI
        const bool told = has(outcome.text, "note: one process computes, since no 2 ranks could be started: ");
        const bool alone = has(content(folder.path / "result/summary.json"), "\"ranks\": 1");
        CHECK(told == alone);
        CHECK(fs::is_empty(temporary));
        CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 2);
        return alone ? 1 : 2;
    };
    CHECK(ranks_of(fmt::format("TMPDIR={}", temporary.string())) == 2);
    CHECK(ranks_of("TMPDIR=/no/such/folder") == 2);  // /tmp serves as well
    CHECK(ranks_of(fmt::format("TMPDIR={} OMPI_MCA_coll=nonsense", temporary.string())) == 1);
    CHECK(ranks_of(fmt::format("TMPDIR={} OMPI_MCA_rmaps=nonsense", temporary.string())) == 1);
    CHECK(ranks_of(fmt::format("TMPDIR={} DEADPOINT_MPIRUN=/no/such/program", temporary.string())) == 1);
    (void)ranks_of(fmt::format("PATH= TMPDIR={}", temporary.string()));  // mpirun may need it
}
