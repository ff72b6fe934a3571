/// Requirement: whatever stands in a file of a results folder or of a study, its page is written or an error of ours
/// comes. The first byte of the input chooses the file; the others are sound.
#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/result_files.hpp"
#include "deadpoint/report/page/page.hpp"
#include "deadpoint/report/page/page_parts.hpp"
#include "deadpoint/report/page/sweep_page.hpp"
#include "input_file.hpp"

#include <array>
#include <filesystem>
#include <vector>

// A megabyte of scripts, the same on every page, is left out.
namespace deadpoint::report {

std::string_view page_style() { return {}; }
std::string_view page_libraries() { return {}; }
std::string_view page_licences() { return {}; }
std::string_view page_data_script() { return {}; }
std::string_view page_charts_script() { return {}; }
std::string_view page_shape_script() { return {}; }
std::string_view page_view_script() { return {}; }
std::string_view page_stage_script() { return {}; }
std::string_view page_linkage_script() { return {}; }
std::string_view page_flow_script() { return {}; }
std::string_view page_gaps_script() { return {}; }
std::string_view page_sections_script() { return {}; }
std::string_view page_main_script() { return {}; }
std::string_view page_sweep_script() { return {}; }
std::string_view page_sensitivity_script() { return {}; }
std::string_view page_plan_script() { return {}; }
std::string_view page_optimise_script() { return {}; }
std::string_view page_check_script() { return {}; }
std::string_view page_calibration_script() { return {}; }

}  // namespace deadpoint::report

namespace {

namespace fs = std::filesystem;

/// Paths below the folder, each with the sound file that belongs there; the study's point holds a run as well.
constexpr std::array<std::pair<const char*, const char*>, 7> files{{{"summary.json", "summary.json"},
                                                                    {"history.csv", "history.csv"},
                                                                    {"loads.json", "loads.json"},
                                                                    {"sweep.json", "sweep.json"},
                                                                    {"sweep.csv", "sweep.csv"},
                                                                    {"points/base/summary.json", "summary.json"},
                                                                    {"points/base/history.csv", "history.csv"}}};

void make_sound(const fs::path& folder, std::size_t index)
{
    fs::create_directories((folder / files[index].first).parent_path());
    fs::copy_file(fs::path(DEADPOINT_SOURCE_DIR "/tests/fuzz/sound") / files[index].second, folder / files[index].first,
                  fs::copy_options::overwrite_existing);
}

template <class Write>
void write_or_refuse(Write write)
{
    try {
        write();
    } catch (const deadpoint::Error&) {
        return;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file("");
    static const bool ready = [] {
        for (std::size_t i = 0; i < files.size(); ++i)
            make_sound(file.folder(), i);
        deadpoint::report::write_manifest(file.folder() / "points/base");
        return true;
    }();
    if (size == 0 || !ready)
        return 0;
    static std::size_t broken = 0;
    const auto chosen = data[0] % files.size();
    const auto& folder = file.folder();
    if (chosen != broken)
        make_sound(folder, broken);
    broken = chosen;
    InputFile::write(folder / files[chosen].first, data + 1, size - 1);
    deadpoint::report::write_manifest(
        (folder / files[chosen].first).parent_path());  // chance does not find the checksum
    const std::vector<fs::path> folders{folder};
    const auto page = folder / "page.html";
    if (chosen < 3)
        write_or_refuse([&] { deadpoint::report::write_report(page, deadpoint::report::report_sources(folders)); });
    else
        write_or_refuse([&] { deadpoint::report::write_sweep_report(page, folder); });
    return 0;
}
