#pragma once

#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

class PrivateFolder;

/// Places for the ranks of one parallel program on this machine. mpirun starts a small process for each, which holds
/// the place: it hands its environment to this process and waits. Whoever starts MPI with that environment is that
/// rank. The ranks can so be forked from this process: they share its memory, its terminal and its signals, and this
/// process sees how they end.
class Places {
public:
    /// Why there are none.
    struct None {
        std::string reason;  ///< in a few words
        std::string log;     ///< what mpirun has said
    };

    /// @throws None  if mpirun is missing, fails, or does not start all within half a minute
    explicit Places(int count);
    /// Ends the holders and mpirun, in the process that made them.
    ~Places();
    Places(const Places&) = delete;
    Places& operator=(const Places&) = delete;

    /// Gives this process, a child of the one that made the places, the environment of one of them.
    /// @param place  from 0; not the number of the rank
    void take(std::size_t place);
    /// True as long as mpirun and all holders live. Without them ranks cannot go on.
    [[nodiscard]] bool held();

    /// Standard output and error lead to the log for the life of this object.
    class Quiet {
    public:
        explicit Quiet(const Places& places);
        ~Quiet();
        Quiet(const Quiet&) = delete;
        Quiet& operator=(const Quiet&) = delete;

    private:
        int out_, err_;
    };
    /// What mpirun and silenced ranks have written so far.
    [[nodiscard]] std::string log() const;

private:
    void start_mpirun(int count, const std::string& socket);
    void accept_holders(int count, int socket);
    [[noreturn]] void give_up(const std::string& reason);
    void end();

    pid_t owner_;
    std::unique_ptr<PrivateFolder> folder_;  ///< for what mpirun and MPI write
    pid_t mpirun_ = 0;
    int log_ = -1;
    std::vector<int> holders_;  ///< a socket to each
    std::vector<std::string>
        environments_;  ///< of each: "NAME=value", each with a zero behind it, and one more at the end
};

/// What the program does in a process that mpirun has started for Places. @return its exit code
int hold_place(const char* socket);

/// The first argument of such a process; its second is the socket.
inline constexpr const char* hold_place_argument = "--hold-place";
