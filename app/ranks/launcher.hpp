#pragma once

#include <string>
#include <vector>

/// Who started this process, as its environment tells.
enum class Launcher {
    none,   ///< a shell, a script, a program
    queue,  ///< the script of a job in a queue (Slurm, PBS, LSF, Grid Engine)
    ranks   ///< mpirun, srun or another program that starts the ranks of a parallel program
};

Launcher launcher();

/// @throws InputError if variables say that mpirun started this process as a rank, and that mpirun is not there (any
/// more): MPI would wait for it, or compute as so many single processes
void require_launcher();

/// How many ranks that program has started; 0 if it does not say.
int launched_ranks();

/// The environment of this process without the variables by which a launcher tells a rank its place. An mpirun that
/// gets it starts ranks on this machine.
std::vector<std::string> environment_of_no_launcher();

/// Gives this process, which no launcher has started, the environment in which MPI begins without help: no helper
/// process, no folder for temporary files, no settings that are meant for other programs.
void leave_mpi_to_itself();
