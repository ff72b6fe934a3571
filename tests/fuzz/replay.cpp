/// Gives every file of a folder to a fuzzer's function, and then changes of them that are the same on every machine:
///     replay_NAME CHANGES FOLDER
/// An input that breaks the reader, or takes far too long, is left in the file "broke-replay_NAME".
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

namespace fs = std::filesystem;

constexpr time_t longest = 20;  // [s] of the processor for one input, however busy the machine
constexpr std::size_t least_room = 16384;

std::string kept_as;
std::string input;

void keep_input(int signal)
{
    const int file = open(kept_as.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const bool kept = file >= 0 && write(file, input.data(), input.size()) == static_cast<ssize_t>(input.size());
    std::fprintf(stderr, "%s by signal %d; the input is %s%s\n", signal == SIGPROF ? "stopped" : "broken", signal,
                 kept ? "in " : "lost, not in ", kept_as.c_str());
    std::_Exit(1);
}

void limit_time(time_t seconds)
{
    const itimerval limit{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}

void give(std::string bytes)
{
    input = std::move(bytes);
    limit_time(longest);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
    limit_time(0);
}

/// Numbers below a limit, by a generator that the language's standard fixes to the bit.
class Draw {
public:
    std::size_t below(std::size_t limit) { return limit == 0 ? 0 : static_cast<std::size_t>(engine_() % limit); }

private:
    std::mt19937_64 engine_{20};
};

std::string piece(const std::string& text, Draw& draw)
{
    const auto begin = draw.below(text.size());
    return text.substr(begin, 1 + draw.below(64));
}

/// One change: a bit, a byte, a part left out, repeated, or taken from another input.
void change(std::string& text, const std::vector<std::string>& inputs, std::size_t largest, Draw& draw)
{
    const auto at = draw.below(text.size() + 1);
    const bool inside = at < text.size();
    switch (draw.below(6)) {
    case 0:
        if (inside)
            text[at] = static_cast<char>(text[at] ^ (1 << draw.below(8)));
        break;
    case 1:
        if (inside)
            text[at] = static_cast<char>(draw.below(256));
        break;
    case 2:
        text.erase(at, 1 + draw.below(32));
        break;
    case 3:
        text.insert(at, piece(text, draw));
        break;
    case 4:
        text.insert(at, piece(inputs[draw.below(inputs.size())], draw));
        break;
    default: {
        const auto& other = inputs[draw.below(inputs.size())];
        text = text.substr(0, at) + other.substr(draw.below(other.size() + 1));
        break;
    }
    }
    text.resize(std::min(text.size(), largest));
}

std::vector<std::string> contents(const fs::path& folder)
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<std::string> texts;
    for (const auto& path : files) {
        std::ifstream in(path, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    }
    return texts;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 3) {
        std::fprintf(stderr, "usage: %s CHANGES FOLDER\n", argv[0]);
        return 2;
    }
    kept_as = "broke-" + fs::path(argv[0]).filename().string();
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGPROF})
        std::signal(signal, keep_input);
    const auto inputs = contents(argv[2]);
    if (inputs.empty()) {
        std::fprintf(stderr, "there is no input in %s\n", argv[2]);
        return 2;
    }
    for (const auto& text : inputs)
        give(text);
    Draw draw;
    const auto longest_input = std::ranges::max(inputs, {}, &std::string::size).size();
    const auto room = std::max(least_room, longest_input + longest_input / 8);
    const auto changes = std::strtoul(argv[1], nullptr, 10);
    for (std::size_t i = 0; i < changes; ++i) {
        std::string text = inputs[i % inputs.size()];
        for (auto count = 1 + draw.below(4); count > 0; --count)
            change(text, inputs, room, draw);
        give(std::move(text));
    }
    std::printf("%zu inputs and %lu changes of them\n", inputs.size(), changes);
    return 0;
}
