/// Requirement: whatever stands in a checkpoint, reading it gives values, which are the same once written and read
/// back, or an error of ours. An input that begins with '+' gets the first line, length and checksum that fit, since
/// chance does not find them; all others are a file as they are.
#include "deadpoint/fem/conduction/checkpoint.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/io/binary_file.hpp"
#include "input_file.hpp"
#include "signed_file.hpp"

#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace {

constexpr std::string_view kind = "deadpoint-checkpoint-1\n";

struct Source {
    std::vector<double> heat;
    bool in_range = true;
};
constexpr auto members(const Source*) { return std::tuple{&Source::heat, &Source::in_range}; }

/// One of each kind of value in a checkpoint, in lists as deep as there.
struct Values {
    deadpoint::fem::CheckpointHead head;
    std::vector<std::vector<double>> columns;
    std::vector<Source> sources;
    std::vector<bool> flags;
    std::vector<float> field;
    std::size_t row = 0;
    int solves = 0;
};
constexpr auto members(const Values*)
{
    return std::tuple{&Values::head,  &Values::columns, &Values::sources, &Values::flags,
                      &Values::field, &Values::row,     &Values::solves};
}

std::string written(const Values& values)
{
    std::ostringstream out;
    deadpoint::BinaryWriter writer(out, kind);
    writer(values);
    writer.finish();
    return out.str();
}

Values read(const InputFile& file, std::string_view bytes)
{
    file.write(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    deadpoint::BinaryReader reader(file.path(), kind, "start anew");
    Values values;
    reader(values);
    return values;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".bin");
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    Values values;
    try {
        values = input.starts_with('+') ? read(file, signed_file(kind, input.substr(1))) : read(file, input);
    } catch (const deadpoint::IoError&) {
        return 0;
    }
    const auto text = written(values);
    if (written(read(file, text)) != text)
        std::abort();
    return 0;
}
