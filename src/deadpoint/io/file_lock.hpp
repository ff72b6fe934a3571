#pragma once

#include <filesystem>
#include <string>

namespace deadpoint {

/// What only one process at a time may do, by a file beside that which it is about. The kernel lifts the lock when the
/// process ends, however it ends; the file says who holds it, and goes with the lock unless the process was killed.
class FileLock {
public:
    /// @param file  the file of the lock, made where there is none; its folder must exist
    /// @param what  what it is about, begins the message: "'results' is being written"
    /// @throws IoError if another process holds it: which one, on which host, since when; if the file is not a lock, or
    ///         cannot be made
    FileLock(std::filesystem::path file, const std::string& what);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// False where the file system knows no locks: others are not kept out.
    [[nodiscard]] bool held() const { return held_; }

private:
    [[nodiscard]] bool is_still_there() const;
    [[nodiscard]] bool take(const std::string& what);

    std::filesystem::path file_;
    int descriptor_ = -1;
    int owner_ = 0;  ///< process that made it; a child shares the lock and must not lift it
    bool held_ = false;
};

}  // namespace deadpoint
