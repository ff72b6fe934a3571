#include "deadpoint/io/resources.hpp"

#include "../../scratch_folder.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <sched.h>
#include <string>

using namespace deadpoint;

namespace {

/// A folder with files as the kernel shows them.
struct System : ScratchFolder {
    void put(const std::string& name, const std::string& text) const
    {
        std::filesystem::create_directories((path / name).parent_path());
        (void)file(name, text);
    }
    /// Processors 0-7, of which 0 and 4, 1 and 5, ... are hyperthreads of one core.
    void put_eight_threads(const std::string& allowed) const
    {
        put("proc/self/status", "Name:\tdeadpoint\nCpus_allowed:\tff\nCpus_allowed_list:\t" + allowed + "\n");
        for (int p = 0; p < 8; ++p)
            put("sys/devices/system/cpu/cpu" + std::to_string(p) + "/topology/thread_siblings_list",
                std::to_string(p % 4) + "," + std::to_string(p % 4 + 4) + "\n");
    }
};

}  // namespace

TEST_CASE("hyperthreads of one core count once")
{
    const System system;
    system.put_eight_threads("0-7");
    CHECK(usable_cores(system.path) == 4);
}

TEST_CASE("only processors that the process may run on count")
{
    const System system;
    system.put_eight_threads("0,4-5");
    CHECK(usable_cores(system.path) == 2);
}

TEST_CASE("without a topology each processor is a core; without anything there is one")
{
    const System system;
    CHECK(usable_cores(system.path) == 1);
    system.put("proc/self/status", "Cpus_allowed_list:\t0-2\n");
    CHECK(usable_cores(system.path) == 3);
}

TEST_CASE("a control group of version 2 limits the cores, and so does one above it")
{
    const System system;
    system.put_eight_threads("0-7");
    system.put("proc/self/cgroup", "0::/user/job\n");
    system.put("sys/fs/cgroup/user/job/cpu.max", "max 100000\n");
    CHECK(usable_cores(system.path) == 4);
    system.put("sys/fs/cgroup/user/cpu.max", "250000 100000\n");
    CHECK(usable_cores(system.path) == 2);
    system.put("sys/fs/cgroup/user/job/cpu.max", "50000 100000\n");
    CHECK(usable_cores(system.path) == 1);
}

TEST_CASE("a control group of version 1 limits the cores of a container, which sees the path of its host")
{
    const System system;
    system.put_eight_threads("0-7");
    system.put("proc/self/cgroup", "4:cpuset:/\n3:cpu,cpuacct:/docker/abc\n0::/\n");
    system.put("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "-1\n");
    system.put("sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000\n");
    CHECK(usable_cores(system.path) == 4);
    system.put("sys/fs/cgroup/cpu/cpu.cfs_quota_us", "300000\n");
    CHECK(usable_cores(system.path) == 3);
}

TEST_CASE("memory is what the machine has left, or less in a control group")
{
    const System system;
    CHECK(std::isinf(available_memory(system.path)));
    system.put("proc/meminfo", "MemTotal: 16000 kB\nMemAvailable:    8000 kB\n");
    CHECK(available_memory(system.path) == 8000 * 1024);
    system.put("proc/self/cgroup", "0::/job\n");
    system.put("sys/fs/cgroup/job/memory.max", "max\n");
    system.put("sys/fs/cgroup/job/memory.current", "1000\n");
    CHECK(available_memory(system.path) == 8000 * 1024);
    system.put("sys/fs/cgroup/job/memory.max", "5000000\n");
    system.put("sys/fs/cgroup/job/memory.current", "3000000\n");
    CHECK(available_memory(system.path) == 2000000);
    system.put("sys/fs/cgroup/job/memory.stat", "anon 1\ninactive_file 500000\n");
    CHECK(available_memory(system.path) == 2500000);
}

TEST_CASE("memory of a control group of version 1")
{
    const System system;
    system.put("proc/meminfo", "MemAvailable:    8000 kB\n");
    system.put("proc/self/cgroup", "4:memory:/job\n");
    system.put("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "4000000\n");
    system.put("sys/fs/cgroup/memory/job/memory.usage_in_bytes", "1000000\n");
    CHECK(available_memory(system.path) == 3000000);
}

TEST_CASE("other programs keep the cores busy on which this process may run, and no others")
{
    const System system;
    system.put_eight_threads("0-1");
    // 100 ticks a second; user, nice, system, idle, ...
    system.put("proc/stat", "cpu 0 0 0 0\ncpu0 0 0 0 0 0 0 0 0\ncpu1 0 0 0 0 0 0 0 0\ncpu2 0 0 0 0 0 0 0 0\n");
    const OtherLoad load(system.path);
    system.put("proc/stat",
               "cpu 9 9 9 9\ncpu0 1000 0 0 0 0 0 0 0\ncpu1 0 0 0 9000 9000 0 0 0\ncpu2 5000 0 0 0 0 0 0 0\n");
    // 10 s within the quarter of a second that is waited at least; this process's own time is little.
    CHECK(load.busy_cores() > 20);
    CHECK(load.busy_cores() < 41);
    system.put("proc/stat", "cpu0 0 0 0 900\ncpu1 0 0 0 900\n");
    CHECK(load.busy_cores() == 0);
}

TEST_CASE("a process bound to one processor has one core")
{
    cpu_set_t all;
    REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
    const int before = usable_cores();
    CHECK(before >= 1);
    CHECK(before <= CPU_COUNT(&all));
    int first = 0;
    while (!CPU_ISSET(first, &all))
        ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
    CHECK(usable_cores() == 1);
    REQUIRE(sched_setaffinity(0, sizeof all, &all) == 0);
    CHECK(available_memory() > 0);
}
