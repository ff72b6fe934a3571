#pragma once

#include <filesystem>
#include <string>

namespace deadpoint {

/// A lock by a file, so that only one process at a time does some work. The kernel releases the
/// lock when the process ends in any way. The file states the holder, and is removed with the lock
/// unless the process was killed.
class FileLock {
public:
    /// @param file the file of the lock, created if missing; its folder must exist
    /// @param what the protected work, begins the message: "'results' is being written"
    /// @throws IoError if another process holds it: which one, on which host, since when; if the file is not a lock, or
    ///         cannot be made
    FileLock(std::filesystem::path file, const std::string& what);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// False if the file system has no locks; other processes are then not excluded.
    [[nodiscard]] bool held() const { return held_; }

private:
    [[nodiscard]] bool is_still_there() const;
    [[nodiscard]] bool take(const std::string& what);

    std::filesystem::path file_;
    int descriptor_ = -1;
    int owner_ = 0;  ///< process that made it; a child shares the lock and must not release it
    bool held_ = false;
};

}  // namespace deadpoint
