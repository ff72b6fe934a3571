#include "deadpoint/press/run/run_record.hpp"

#include "deadpoint/core/table.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::press {

double value_at(const RunRecord& run, const std::vector<double>& values, double time)
{
    return interpolate_linear(run.time, values, time).value;
}

std::size_t largest_gap_row(const RunRecord& run)
{
    const auto& gap = run.chain.at("E_SW");
    return static_cast<std::size_t>(std::ranges::max_element(gap, {}, [](double e) { return std::abs(e); }) -
                                    gap.begin());
}

}  // namespace deadpoint::press
