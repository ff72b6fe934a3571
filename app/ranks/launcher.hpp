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

/// How many ranks that program has started; 0 if it does not say.
int launched_ranks();

/// The environment of this process without the variables by which a launcher tells a rank its place. An mpirun that
/// gets it starts ranks on this machine.
std::vector<std::string> environment_of_no_launcher();
