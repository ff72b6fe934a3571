/// Requirement: whatever stands in a table, reading it and its columns gives finite numbers or an error of ours.
#include "deadpoint/io/csv_table.hpp"

#include "deadpoint/error.hpp"
#include "input_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const InputFile file(".csv");
    file.write(data, size);
    try {
        const auto table = deadpoint::read_csv(file.path());
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            if (!std::ranges::all_of(table.numbers(c), [](double v) { return std::isfinite(v); }))
                std::abort();
    } catch (const deadpoint::Error&) {
        return 0;
    }
    return 0;
}
