#include "ranks/launcher.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <unistd.h>

namespace {

bool is_set(const char* name) { return std::getenv(name) != nullptr; }

}  // namespace

Launcher launcher()
{
    constexpr std::array of_ranks{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "PMI_SIZE", "PMI_FD",
                                  "SLURM_STEP_ID"};
    constexpr std::array of_queues{"SLURM_JOB_ID", "PBS_JOBID", "LSB_JOBID", "PE_HOSTFILE"};
    if (std::ranges::any_of(of_ranks, is_set)) {
        return Launcher::ranks;
    }
    return std::ranges::any_of(of_queues, is_set) ? Launcher::queue : Launcher::none;
}

int launched_ranks()
{
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "SLURM_STEP_NUM_TASKS"}) {
        if (const char* text = std::getenv(name)) {
            return std::atoi(text);
        }
    }
    return 0;
}

std::vector<std::string> environment_of_no_launcher()
{
    constexpr std::array<std::string_view, 12> theirs{"OMPI_COMM_WORLD_",
                                                      "OMPI_UNIVERSE_SIZE",
                                                      "OMPI_MCA_ess",
                                                      "OMPI_MCA_orte_",
                                                      "PMIX_",
                                                      "PMI_",
                                                      "PRTE_",
                                                      "SLURM_",
                                                      "PBS_",
                                                      "LSB_",
                                                      "PE_HOSTFILE",
                                                      "JOB_ID="};
    std::vector<std::string> result;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text(*variable);
        if (std::ranges::none_of(theirs, [&](std::string_view prefix) { return text.starts_with(prefix); })) {
            result.emplace_back(text);
        }
    }
    return result;
}
