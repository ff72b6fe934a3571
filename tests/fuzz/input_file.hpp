#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

/// A fuzzer's input as a file in memory, for readers that take paths.
class InputFile {
public:
    explicit InputFile(const std::string& ending)
    {
        const std::filesystem::path memory("/dev/shm");
        folder_ = (std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path()) /
                  ("deadpoint-fuzz-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
        path_ = folder_ / ("input" + ending);
    }
    ~InputFile() { std::filesystem::remove_all(folder_); }
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    void write(const std::uint8_t* data, std::size_t size) const { write(path_, data, size); }
    static void write(const std::filesystem::path& path, const std::uint8_t* data, std::size_t size)
    {
        std::FILE* file = std::fopen(path.c_str(), "wb");
        if (file == nullptr || std::fwrite(data, 1, size, file) != size)
            std::abort();
        std::fclose(file);
    }
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
    std::filesystem::path folder_;
    std::filesystem::path path_;
};
