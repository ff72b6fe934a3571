#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

/// Broken cases of a folder: NAME.toml is broken in the way its name says, NAME.txt holds the message it must give.
namespace broken {

namespace fs = std::filesystem;

inline std::vector<fs::path> cases(const fs::path& folder)
{
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() == ".toml") {
            paths.push_back(entry.path());
        }
    }
    std::ranges::sort(paths);
    return paths;
}

inline std::string replace_all(std::string text, const std::string& from, const std::string& to)
{
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

inline std::string expected(const fs::path& path)
{
    std::ifstream stream(fs::path(path).replace_extension(".txt"));
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Lines of `expected` that do not follow in `message` in this order; "..." at the end of a line stands for the rest.
inline std::string missing_line(const std::string& message, const std::string& expected)
{
    std::istringstream lines(expected);
    std::size_t from = 0;
    for (std::string line; std::getline(lines, line);) {
        const bool open = line.ends_with("...");
        const std::string wanted = open ? line.substr(0, line.size() - 3) : line + "\n";
        const auto found = (message + "\n").find(wanted, from);
        if (found == std::string::npos) {
            return line;
        }
        from = found + wanted.size();
    }
    return "";
}

}  // namespace broken
