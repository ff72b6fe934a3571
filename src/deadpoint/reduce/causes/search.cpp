#include "deadpoint/reduce/causes/search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace deadpoint::reduce {
namespace {

constexpr std::size_t most_fields = 100;
constexpr double wanted_change = 1e-3;      // of each cause
constexpr double share_that_counts = 5e-3;  // of all causes together

std::vector<double> values_of(const HeatCauses& causes)
{
    std::vector<double> values{causes.start};
    for (const auto* list : {&causes.friction, &causes.oil, &causes.surfaces, &causes.body_heat})
        values.insert(values.end(), list->begin(), list->end());
    return values;
}

}  // namespace

bool CausesSearch::wants_more(std::size_t fields) const { return relative_ > wanted_change && fields < most_fields; }

void CausesSearch::add(HeatCauses causes)
{
    const auto before = std::exchange(causes_, std::move(causes));
    if (!before)
        return;
    const auto old = values_of(*before), values = values_of(*causes_);
    double all = 0;
    for (const double value : values)
        all += std::abs(value);
    before_ = std::exchange(change_, 0);
    relative_ = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double change = std::abs(values[i] - old[i]);
        change_ = std::max(change_, change);
        if (change > 0)
            relative_ = std::max(relative_, change / std::max(std::abs(values[i]), share_that_counts * all));
    }
}

HeatCauses CausesSearch::result(std::size_t fields) const
{
    auto result = causes_.value_or(HeatCauses{});
    result.fields = static_cast<int>(fields);
    result.change = std::max(change_, before_);
    return result;
}

}  // namespace deadpoint::reduce
