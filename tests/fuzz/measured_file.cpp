/// Requirement: whatever stands in a measured table, calibrate and compare take finite values at increasing times from
/// it, each column once, or give an error of ours.
#include "calibrated_case.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string_view>

namespace {

constexpr std::string_view calibration = R"(format = 1
name = "n"
[[parameters]]
name = "p"
keys = ["friction.pins.load_part"]
factor = 2
[[runs]]
name = "r"
data = "log.csv"
gaps = "leave_out"
ignore = ["text"]
[[sensors]]
columns = ["*"]
noise = "0.1 K"
)";
constexpr std::string_view reference = R"(format = 1
name = "n"
source = "s"
[[curves]]
file = "log.csv"
column = "slide"
measures = "temperature"
probe = "slide"
)";

void require(bool sound)
{
    if (!sound)
        std::abort();
}

void require_course(const std::vector<double>& time, const std::vector<double>& value)
{
    const auto finite = [](double v) { return std::isfinite(v); };
    require(time.size() == value.size() && std::ranges::all_of(time, finite) && std::ranges::all_of(value, finite));
    require(std::ranges::adjacent_find(time, [](double a, double b) { return !(a < b); }) == time.end());
}

void calibrate(const InputFile& file, const deadpoint::casefile::CalibratedCase& of)
{
    std::set<std::string> columns;
    const auto read = deadpoint::casefile::read_calibration(file.folder() / "calibration.toml", of, false);
    for (const auto& curve : read.runs.front().curves) {
        require_course(curve.time, curve.value);
        require(columns.insert(curve.column).second);
    }
}

void compare(const InputFile& file)
{
    const auto read = deadpoint::casefile::read_reference(file.folder() / "reference.toml");
    require_course(read.curves.front().time, read.curves.front().value);
}

template <class Read>
void attempt(const Read& read)
{
    try {
        read();
    } catch (const deadpoint::Error&) {
        return;
    }
}

void write(const std::filesystem::path& path, std::string_view text)
{
    InputFile::write(path, reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".csv");
    static const auto of = [] {
        write(file.folder() / "calibration.toml", calibration);
        write(file.folder() / "reference.toml", reference);
        return calibrated_case(file);
    }();
    InputFile::write(file.folder() / "log.csv", data, size);
    attempt([] { calibrate(file, of); });
    attempt([] { compare(file); });
    return 0;
}
