#include "deadpoint/press/drift/series_sum.hpp"

#include "deadpoint/exchange/heat.hpp"

namespace deadpoint::press {

Series combined(const std::vector<std::pair<double, const Series*>>& terms)
{
    Series sum = *terms.front().second;
    for (auto values : {&Series::value, &Series::rate})
        for (std::size_t i = 0; i < (sum.*values).size(); ++i) {
            (sum.*values)[i] = 0;
            for (const auto& [factor, series] : terms)
                (sum.*values)[i] += factor * (series->*values)[i];
        }
    return sum;
}

}  // namespace deadpoint::press
