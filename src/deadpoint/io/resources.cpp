#include "deadpoint/io/resources.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <sys/times.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace deadpoint {
namespace {

namespace fs = std::filesystem;

constexpr double unlimited = std::numeric_limits<double>::infinity();

std::string first_line(const fs::path& file)
{
    std::string line;
    std::ifstream in(file);
    std::getline(in, line);
    return line;
}

/// The rest of the line that begins with `key`.
std::string value_of(const fs::path& file, std::string_view key)
{
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(key))
            return line.substr(key.size());
    return {};
}

/// The number that a text begins with; "max" of a control group is none.
std::optional<double> number_in(const std::string& text)
{
    std::istringstream in(text);
    double value = 0;
    return in >> value ? std::optional(value) : std::nullopt;
}

/// Numbers of a list such as "0-3,8".
std::vector<int> listed(const std::string& list)
{
    std::vector<int> result;
    std::istringstream in(list);
    for (int first = 0; in >> first;) {
        int last = first;
        if (in.peek() == '-') {
            in.ignore();
            in >> last;
        }
        for (int number = first; number <= last; ++number)
            result.push_back(number);
        if (in.peek() == ',')
            in.ignore();
    }
    return result;
}

int allowed_cores(const fs::path& system)
{
    std::set<std::string> cores;
    for (const int processor : listed(value_of(system / "proc/self/status", "Cpus_allowed_list:"))) {
        const auto topology = system / fmt::format("sys/devices/system/cpu/cpu{}/topology", processor);
        const auto siblings = first_line(topology / "thread_siblings_list");
        cores.insert(siblings.empty() ? std::to_string(processor) : siblings);
    }
    return std::max<int>(1, static_cast<int>(cores.size()));
}

/// The control group of a process in one hierarchy and those above it, as folders.
/// @param controller  of version 1: "cpu"; empty: version 2
std::vector<fs::path> groups(const fs::path& system, const std::string& controller)
{
    std::vector<fs::path> result;
    std::ifstream in(system / "proc/self/cgroup");
    for (std::string line; std::getline(in, line);) {
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos)
            continue;
        const auto controllers = ',' + line.substr(first + 1, second - first - 1) + ',';
        if (controller.empty() ? controllers != ",," : controllers.find(',' + controller + ',') == std::string::npos)
            continue;
        const auto root = system / "sys/fs/cgroup" / controller;
        // In a container the path is that of the host, and only the root is there.
        for (fs::path path = fs::path(line.substr(second + 1)).relative_path(); !path.empty();
             path = path.parent_path())
            result.push_back(root / path);
        result.push_back(root);
    }
    return result;
}

/// Processors whose time the control groups give.
double quota(const fs::path& system)
{
    double least = unlimited;
    const auto take = [&](const std::string& time, const std::string& period) {
        const auto of = number_in(time), per = number_in(period);
        if (of && per && *of > 0 && *per > 0)
            least = std::min(least, *of / *per);
    };
    for (const auto& group : groups(system, "")) {
        const auto line = first_line(group / "cpu.max");
        take(line, line.substr(std::min(line.find(' '), line.size())));
    }
    for (const auto& group : groups(system, "cpu"))
        take(first_line(group / "cpu.cfs_quota_us"), first_line(group / "cpu.cfs_period_us"));
    return least;
}

/// What is left of a limit; pages of files that were read can be dropped.
double left(const std::string& limit, const std::string& used, const std::string& droppable)
{
    const auto most = number_in(limit), now = number_in(used);
    return most && now ? std::max(0.0, *most - *now + number_in(droppable).value_or(0)) : unlimited;
}

double left_in_groups(const fs::path& system)
{
    double least = unlimited;
    for (const auto& group : groups(system, ""))
        least = std::min(least, left(first_line(group / "memory.max"), first_line(group / "memory.current"),
                                     value_of(group / "memory.stat", "inactive_file ")));
    for (const auto& group : groups(system, "memory"))
        least = std::min(least,
                         left(first_line(group / "memory.limit_in_bytes"), first_line(group / "memory.usage_in_bytes"),
                              value_of(group / "memory.stat", "total_inactive_file ")));
    return least;
}

/// Busy time of the processors that the process may run on, since the system started [s].
double busy_seconds(const fs::path& system)
{
    const auto allowed = listed(value_of(system / "proc/self/status", "Cpus_allowed_list:"));
    std::ifstream in(system / "proc/stat");
    double ticks = 0;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line);
        std::string name;
        std::array<double, 8> used{};  // user, nice, system, idle, waiting for disks, interrupts, soft ones, stolen
        words >> name;
        for (double& value : used)
            words >> value;
        if (name.starts_with("cpu") && std::ranges::find(allowed, std::atoi(name.c_str() + 3)) != allowed.end() &&
            name.size() > 3)
            ticks += used[0] + used[1] + used[2] + used[5] + used[6] + used[7];
    }
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// Processor time of this process and its ended children [s].
double own_seconds()
{
    tms used{};
    times(&used);
    return static_cast<double>(used.tms_utime + used.tms_stime + used.tms_cutime + used.tms_cstime) /
           static_cast<double>(sysconf(_SC_CLK_TCK));
}

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

OtherLoad::OtherLoad(fs::path system)
    : system_(std::move(system)), start_(now()), busy_(busy_seconds(system_)), own_(own_seconds())
{}

double OtherLoad::busy_cores() const
{
    constexpr double shortest = 0.25;
    std::this_thread::sleep_for(std::chrono::duration<double>(std::max(0.0, start_ + shortest - now())));
    const double others = busy_seconds(system_) - busy_ - (own_seconds() - own_);
    return std::max(0.0, others) / (now() - start_);
}

int usable_cores(const fs::path& system)
{
    return std::max(1, static_cast<int>(std::min<double>(allowed_cores(system), quota(system))));
}

double available_memory(const fs::path& system)
{
    constexpr double kibibyte = 1024;
    const auto machine = number_in(value_of(system / "proc/meminfo", "MemAvailable:"));
    return std::min(machine ? kibibyte * *machine : unlimited, left_in_groups(system));
}

}  // namespace deadpoint
