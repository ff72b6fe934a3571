#include "results/open_page.hpp"

#include "output.hpp"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern char** environ;

namespace {

/// What a started program may write.
enum class Says { everything, no_errors };

/// Runs a program of the path; false if there is none or it fails.
bool run_program(std::vector<std::string> command, Says says)
{
    std::vector<char*> arguments;
    for (auto& argument : command) {
        arguments.push_back(argument.data());
    }
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (says != Says::everything) {
        posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    }
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) {
        return false;
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

void open_page(const std::filesystem::path& page)
{
    const auto shown = std::filesystem::absolute(page).lexically_normal().string();
    const char* browser = std::getenv("BROWSER");
    const auto opens = [&](const char* opener) {
        // A browser that the user names may say what is wrong with it. The others list what they lack.
        return run_program({opener, shown}, opener == browser ? Says::everything : Says::no_errors);
    };
    std::vector<const char*> openers{"xdg-open", "open", "wslview"};
    if (browser != nullptr && *browser != '\0') {
        openers.insert(openers.begin(), browser);
    }
    if (std::ranges::any_of(openers, opens)) {
        print_out("opened {}\n", shown);
    } else {
        print_out("found no browser to open; the page is {}\n", shown);
    }
}
