#include "ranks/launcher.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
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

void require_launcher()
{
    // Variables of Open MPI's mpirun, and of others that speak PMIx: where the ranks' server is, and its folder.
    constexpr std::array servers{"PMIX_SERVER_URI41", "PMIX_SERVER_URI4", "PMIX_SERVER_URI3",
                                 "PMIX_SERVER_URI21", "PMIX_SERVER_URI2", "PMIX_SERVER_URI"};
    const char* folder = std::getenv("PMIX_SERVER_TMPDIR");
    const bool by_mpirun = is_set("OMPI_COMM_WORLD_SIZE") || is_set("PMIX_RANK");
    const bool there = is_set("PMIX_NAMESPACE") && is_set("PMIX_RANK") && std::ranges::any_of(servers, is_set) &&
                       (folder == nullptr || access(folder, F_OK) == 0 || errno != ENOENT);
    if (by_mpirun && !there) {
        throw deadpoint::InputError(
            "the environment says that mpirun started this program as one of its ranks, but that mpirun is not there\n"
            "  help: start it by mpirun, or remove the variables OMPI_COMM_WORLD_* and PMIX_* from the environment, as "
            "by `env -u OMPI_COMM_WORLD_SIZE -u PMIX_RANK deadpoint ...`");
    }
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

void leave_mpi_to_itself()
{
    constexpr std::array<std::string_view, 6> of_mpi{"OMPI_", "OPAL_", "ORTE_", "PMIX_", "PMI_", "PRTE_"};
    std::vector<std::string> dropped;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text(*variable);
        if (std::ranges::any_of(of_mpi, [&](std::string_view prefix) { return text.starts_with(prefix); })) {
            dropped.emplace_back(text.substr(0, text.find('=')));
        }
    }
    for (const auto& name : dropped) {
        unsetenv(name.c_str());
    }
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 1);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 1);
    setenv("OMPI_MCA_pml", "ob1", 1);
    setenv("OMPI_MCA_btl", "self", 1);
    setenv("OMPI_MCA_mca_base_param_files", "/dev/null", 1);
}
