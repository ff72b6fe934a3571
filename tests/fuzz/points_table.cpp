/// Requirement: whatever stands in points.csv, reading it gives rows of finite numbers, or an error of ours. In an
/// input that begins with '+' each row gets the checksum that fits.
#include "deadpoint/error.hpp"
#include "deadpoint/report/folder/point_table.hpp"
#include "input_file.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>

using namespace deadpoint;

namespace {

constexpr const char* study_mark = "0123456789abcdef";

std::string without_last_cell(const std::string& line) { return line.substr(0, line.rfind(',')); }

std::string with_checksums(const std::string& text)
{
    std::istringstream in(text);
    std::string result, headings;
    for (std::string line; std::getline(in, line);) {
        if (!line.empty() && !line.starts_with('#')) {
            if (headings.empty())
                headings = without_last_cell(line);
            else
                line = without_last_cell(line) + "," +
                       report::checksum_of_row(study_mark, headings, without_last_cell(line));
        }
        result += line + '\n';
    }
    return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".csv");
    std::string text(reinterpret_cast<const char*>(data), size);
    if (text.starts_with('+'))
        text = with_checksums(text.substr(1));
    file.write(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    try {
        for (const auto& row : report::read_points(file.path(), study_mark))
            if (row.record)
                for (const auto& [dimension, course] : row.record->chain)
                    for (const double value : course)
                        if (std::isinf(value))
                            std::abort();
    } catch (const Error&) {
    }
    return 0;
}
