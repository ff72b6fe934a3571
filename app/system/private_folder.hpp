#pragma once

#include <filesystem>
#include <sys/types.h>

/// A new folder for files that no other program needs, removed with the object. Only this user may open it (mode 0700),
/// and nobody can know its name beforehand, so that no link waits in it.
class PrivateFolder {
public:
    /// In the system's folder for temporary files: TMPDIR, else /tmp. If files of `room` bytes cannot be written there,
    /// in /tmp or in memory (/dev/shm).
    /// @throws IoError  if none of these folders takes it
    explicit PrivateFolder(std::size_t room);
    /// Removes it, in the process that made it.
    ~PrivateFolder();
    PrivateFolder(const PrivateFolder&) = delete;
    PrivateFolder& operator=(const PrivateFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    pid_t owner_;
};
