/// Requirement: whatever stands in a file of a reduced press with a right checksum, reading it, and a short run where
/// it can be read, ends with values or an error of ours; and takes no more memory than four times the file and 200 MB.
///
///     signed_changes COUNT CASE PRESS [CERTIFICATE LARGE]   # changes of the press, or of the certificate
///
/// Changes are the same on every machine: bits, integers and floating-point numbers of extreme values, counts that are
/// off, words that change places, cuts. A file that breaks the program is left as "broke-signed_changes".
#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/model/certificate_file.hpp"
#include "deadpoint/twin/model/reduced_press.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"
#include "input_file.hpp"
#include "signed_file.hpp"

#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <sys/resource.h>
#include <sys/time.h>

using namespace deadpoint;

namespace {

constexpr std::size_t memory = 200'000'000;  // beside four times the file [byte]
constexpr time_t longest = 20;               // [s] of the processor for one file

std::string present;

[[noreturn]] void keep(const char* reason)
{
    const int file = open("broke-signed_changes", O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const bool kept = file >= 0 && write(file, present.data(), present.size()) == static_cast<ssize_t>(present.size());
    std::fprintf(stderr, "broken: %s; the file is %s\n", reason, kept ? "broke-signed_changes" : "lost");
    std::_Exit(1);
}

void keep_signal(int signal)
{
    keep(signal == SIGPROF ? "it takes too long" : signal == SIGSEGV ? "SIGSEGV" : "a signal");
}

void limit_time(time_t seconds)
{
    const itimerval limit{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
}

/// Address space now [byte].
std::size_t address_space()
{
    std::ifstream in("/proc/self/statm");
    std::size_t pages = 0;
    in >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

class Changes {
public:
    explicit Changes(std::string sound) : sound_(std::move(sound)) {}
    std::string next()
    {
        std::string text = sound_;
        for (auto count = 1 + below(3); count > 0; --count)
            change(text);
        return text;
    }

private:
    std::size_t below(std::size_t limit) { return limit == 0 ? 0 : static_cast<std::size_t>(engine_() % limit); }
    /// Most of a file are matrices; names, counts and indices stand before them.
    std::size_t place(std::size_t size)
    {
        const auto at = below(size);
        return below(2) == 0 ? at : at / (1 + below(64));
    }
    template <class Value, std::size_t count>
    void put(std::string& text, const std::array<Value, count>& values)
    {
        if (text.size() < sizeof(Value))
            return;
        const Value value = values[below(count)];
        std::memcpy(text.data() + place(text.size() - sizeof value + 1), &value, sizeof value);
    }
    void change_count(std::string& text)
    {
        for (int tries = 0; tries < 1000 && text.size() >= 8; ++tries) {
            std::uint64_t count = 0;
            const auto at = place(text.size() - 7);
            std::memcpy(&count, text.data() + at, sizeof count);
            if (count == 0 || count > text.size())
                continue;
            const std::array<std::uint64_t, 6> others{count + 1, count - 1, 2 * count, 0, count << 32, ~count};
            count = others[below(others.size())];
            std::memcpy(text.data() + at, &count, sizeof count);
            return;
        }
    }
    void swap_words(std::string& text)
    {
        if (text.size() < 16)
            return;
        std::array<char, 8> one{};
        const auto a = place(text.size() - 7), b = place(text.size() - 7);
        std::memcpy(one.data(), text.data() + a, 8);
        std::memmove(text.data() + a, text.data() + b, 8);
        std::memcpy(text.data() + b, one.data(), 8);
    }
    void change(std::string& text)
    {
        constexpr double infinite = std::numeric_limits<double>::infinity();
        switch (below(9)) {
        case 0:
        case 1:
            if (!text.empty()) {
                auto& byte = text[place(text.size())];
                byte = static_cast<char>(byte ^ (1 << below(8)));
            }
            return;
        case 2:
            return put(text, std::array<std::uint64_t, 6>{0, 1, ~std::uint64_t{0}, 1ULL << 31, 1ULL << 61, 1ULL << 20});
        case 3:
            return put(text, std::array<double, 8>{std::nan(""), infinite, -infinite, 1e308, -1e308, -1, 0, 5e-324});
        case 4:
            return put(text, std::array<float, 7>{std::nanf(""), 1e38F, -1e38F, -1, 0, 1e-45F, 1e6F});
        case 5:
        case 6:
            return change_count(text);
        case 7:
            return swap_words(text);
        default:
            if (below(4) == 0)
                text.resize(below(text.size() + 1));
            else
                text.erase(place(text.size()), 1 + below(16));
        }
    }

    std::string sound_;
    std::mt19937_64 engine_{7};
};

/// Ends a run that goes on and on after some hundred steps.
class Impatient : public Observer {
public:
    [[nodiscard]] bool cancelled() const override { return ++asked_ > 300; }

private:
    mutable int asked_ = 0;
};

std::string content(const std::filesystem::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// What follows the first line and precedes length and checksum.
std::string body_of(const std::string& file)
{
    const auto first = file.find('\n') + 1;
    return file.substr(first, file.size() - first - 16);
}

struct Counts {
    unsigned long refused = 0, run = 0, refused_later = 0;
};

class Trial {
public:
    Trial(const std::string& case_file, std::optional<twin::ReducedPress> large)
        : input_(casefile::read_case(case_file, {"operation.0.duration=600 s", "output.causes=false"}).value),
          large_(std::move(large))
    {}
    void operator()(const std::filesystem::path& file, Counts& counts) const
    {
        std::optional<twin::ReducedPress> press;
        std::shared_ptr<const reduce::ResidualTerms> residual;
        try {
            if (large_)
                residual = twin::read_certificate(file, *large_);
            else
                press = twin::read_reduced(file);
        } catch (const Error&) {
            ++counts.refused;
            return;
        }
        try {
            Impatient observer;
            if (large_)
                twin::run_reduced(input_, *large_, {&*large_, residual.get()}, twin::ReducedDetail::figures, observer);
            else
                twin::run_reduced(input_, *press, {}, twin::ReducedDetail::figures, observer);
            ++counts.run;
        } catch (const Error&) {
            ++counts.refused_later;
        }
    }

private:
    casefile::Case input_;
    std::optional<twin::ReducedPress> large_;
};

int try_changes(unsigned long count, const Trial& trial, const std::string& sound, std::string_view kind)
{
    const InputFile file(".rom");
    Changes changes(body_of(sound));
    Counts counts;
    const auto give = [&](const std::string& body) {
        present = signed_file(kind, body);
        file.write(reinterpret_cast<const std::uint8_t*>(present.data()), present.size());
        limit_time(longest);
        try {
            trial(file.path(), counts);
        } catch (const std::exception& error) {
            keep(error.what());
        }
        limit_time(0);
    };
    give(body_of(sound));
    if (counts.run != 1)
        keep("the sound file does not run");
    const rlim_t space = address_space() + 4 * sound.size() + memory;
    const rlimit limit{space, space};
    setrlimit(RLIMIT_AS, &limit);
    for (unsigned long k = 0; k < count; ++k)
        give(changes.next());
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    std::printf(
        "%lu changes of a file of %zu bytes: %lu refused when read, %lu refused by the run, %lu run; at most %ld MB "
        "resident\n",
        count, sound.size(), counts.refused, counts.refused_later, counts.run - 1, usage.ru_maxrss / 1000);
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc != 4 && argc != 6) {
        std::fprintf(stderr, "usage: %s COUNT CASE PRESS [CERTIFICATE LARGE]\n", argv[0]);
        return 2;
    }
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGPROF})
        std::signal(signal, keep_signal);
    const bool of_certificate = argc == 6;
    const Trial trial(argv[2], of_certificate ? std::optional(twin::read_reduced(argv[5])) : std::nullopt);
    return try_changes(std::strtoul(argv[1], nullptr, 10), trial, content(argv[of_certificate ? 4 : 3]),
                       of_certificate ? twin::certificate_kind : twin::reduced_kind);
}
