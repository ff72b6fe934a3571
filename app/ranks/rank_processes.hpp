#pragma once

#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

/// How a set of ranks has ended.
struct RanksEnd {
    int exit_code = 0;    ///< of the program
    std::string message;  ///< of a rank that was ended from outside; empty: the ranks have said all
};

/// Child processes of this one that are the ranks of one program. They share some words with this process, which waits
/// for them, passes a wish to stop on to them, and ends all when one fails, since the others would wait for it forever.
class RankProcesses {
public:
    explicit RankProcesses(int count);
    /// Kills those that live, in the process that started them.
    ~RankProcesses();
    RankProcesses(const RankProcesses&) = delete;
    RankProcesses& operator=(const RankProcesses&) = delete;

    /// Starts the next one. @return true in it, false in this process
    /// @throws IoError if no process can be started
    bool start();

    // In a rank:
    /// Says that MPI runs, and waits for the others.
    void opened(int rank);
    /// For a rank that cannot go on: returns in the first of them, which then shows the error. Others wait for their
    /// end.
    void require_first_failure();
    /// Ends this rank, and so all, after the error was shown.
    [[noreturn]] void fail(int exit_code);

    // In this process:
    /// Waits until all have opened MPI, and lets them begin their work.
    /// @return false if one has ended before, or within a minute not all have; all are killed then
    bool wait_until_opened();
    /// Waits for their end. @param can_go_on  false once they never can
    RanksEnd wait(const std::function<bool()>& can_go_on);

private:
    struct Shared;

    [[nodiscard]] bool reap_one(RanksEnd& end);
    void kill_all();
    void tell_all(int signal) const;

    int count_;
    pid_t owner_;
    Shared* shared_;  ///< of all
    std::vector<pid_t> living_;
    bool killed_ = false;  ///< by this process
};
