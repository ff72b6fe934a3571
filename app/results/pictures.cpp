#include "results/pictures.hpp"

#include "deadpoint/core/names/unique_name.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/io/write_file.hpp"
#include "deadpoint/report/folder/folder_claim.hpp"
#include "interrupt.hpp"
#include "system/private_folder.hpp"
#include "system/program.hpp"

#include <array>
#include <cctype>
#include <cstdlib>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <vector>

using namespace deadpoint;
namespace fs = std::filesystem;

namespace {

constexpr std::array poses{"oblique", "front", "side", "cut"};
constexpr double usual_limit = 120;                          // [s] for one picture, which takes a second or two
constexpr std::size_t profile_room = std::size_t{32} << 20;  // [byte]

fs::path picture_file(const fs::path& folder, std::string_view pose)
{
    return fs::absolute(folder / fmt::format("machine-{}.png", pose));
}

/// [s] @throws InputError
double time_limit()
{
    const char* text = std::getenv("DEADPOINT_BROWSER_SECONDS");
    if (text == nullptr || *text == '\0') {
        return usual_limit;
    }
    char* end = nullptr;
    const double seconds = std::strtod(text, &end);
    if (*end != '\0' || !(seconds > 0)) {
        throw InputError(fmt::format("DEADPOINT_BROWSER_SECONDS is '{}'\n  help: set it to a number of seconds, or not "
                                     "at all",
                                     text));
    }
    return seconds;
}

std::vector<std::string> command_of(const char* browser, const fs::path& profile, const fs::path& picture,
                                    const std::string& address)
{
    std::vector<std::string> command{browser,
                                     "--headless=new",
                                     "--no-first-run",
                                     "--use-gl=angle",
                                     "--use-angle=swiftshader",
                                     "--enable-unsafe-swiftshader",
                                     "--hide-scrollbars",
                                     "--force-color-profile=srgb",
                                     "--window-size=1600,1200",
                                     "--virtual-time-budget=2000",
                                     "--user-data-dir=" + profile.string(),
                                     "--screenshot=" + picture.string()};
    if (geteuid() == 0) {
        command.emplace_back("--no-sandbox");  // otherwise it refuses to start as root
    }
    command.push_back(address);
    return command;
}

/// Removes a file at the end of its life, whatever happens.
struct Scrap {
    fs::path path;
    ~Scrap()
    {
        std::error_code ignored;
        fs::remove(path, ignored);
    }
};

/// The first browser that is there decides. Its profile is new: with that of a running browser it would hand over to
/// that one and draw nothing. What else it leaves, in its home and among temporary files, lies in the same folder.
ProgramEnd draw(const std::string& address, const fs::path& picture)
{
    const PrivateFolder own(profile_room);
    std::vector<std::string> settings;
    for (const char* name : {"TMPDIR", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"}) {
        settings.push_back(fmt::format("{}={}", name, own.path().string()));
    }
    for (const char* browser : {"chromium", "chromium-browser", "google-chrome"}) {
        const auto end =
            run_limited(command_of(browser, own.path() / "profile", picture, address), settings, time_limit());
        if (end != ProgramEnd::missing) {
            return end;
        }
    }
    return ProgramEnd::missing;
}

[[noreturn]] void refuse(ProgramEnd end)
{
    constexpr const char* otherwise = "or open the page and use 'Save as picture'";
    if (end == ProgramEnd::missing) {
        throw IoError(fmt::format("pictures need Chromium, which was not found\n  help: install it (Debian: apt-get "
                                  "install chromium), {}",
                                  otherwise));
    }
    if (end == ProgramEnd::too_long) {
        throw IoError(
            fmt::format("Chromium took longer than {:g} s for a picture and was stopped\n  help: give it more "
                        "time, as by DEADPOINT_BROWSER_SECONDS=600, {}",
                        time_limit(), otherwise));
    }
    throw IoError(fmt::format("Chromium made no picture: it failed\n  help: see whether `chromium --headless=new "
                              "about:blank` starts, and whether the disk has room, {}",
                              otherwise));
}

}  // namespace

std::string file_address(const fs::path& file)
{
    std::string address = "file://";
    for (const char c : fs::absolute(file).lexically_normal().string()) {
        const auto byte = static_cast<unsigned char>(c);
        const bool plain =
            byte < 128 && (std::isalnum(byte) != 0 || std::string_view("-._~/").find(c) != std::string_view::npos);
        address += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
    }
    return address;
}

void require_new_pictures(const fs::path& folder, bool force)
{
    for (const char* pose : poses) {
        (void)report::if_there(picture_file(folder, pose), force);
    }
}

bool take_pictures(const fs::path& page, const fs::path& folder, Observer& observer)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw IoError(fmt::format("cannot create '{}': {}\n  help: name a folder you may write to", folder.string(),
                                  error.message()));
    }
    catch_interrupts();
    for (const char* pose : poses) {
        observer.stage(fmt::format("picture {}", pose));
        const auto file = picture_file(folder, pose);
        const Scrap part{unique_name(part_prefix(file)) + ".png"};
        const auto end = draw(fmt::format("{}#picture={}", file_address(page), pose), part.path);
        if (end == ProgramEnd::stopped) {
            return false;
        }
        if (end != ProgramEnd::done || !fs::exists(part.path)) {
            refuse(end);
        }
        fs::rename(part.path, file);
    }
    return true;
}
