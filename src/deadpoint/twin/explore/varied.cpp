#include "deadpoint/twin/explore/varied.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/numbers.hpp"

#include <cmath>
#include <map>

namespace deadpoint::twin {
namespace {

VariedRange range_of(const casefile::VariedKeys& keys)
{
    using Kind = VariedRange::Kind;
    VariedRange range{keys.name, keys.kind, keys.low, keys.high, keys.dimension, 1, true};
    if (range.kind == Kind::shift) {
        range.scaled = false;
        range.centre = 0;
    } else if (range.kind == Kind::value) {
        range.scaled = range.low > 0 && range.dimension != Dimension::temperature;
        range.centre = range.scaled ? std::sqrt(range.low * range.high) : 0.5 * (range.low + range.high);
    }
    return range;
}

}  // namespace

double VariedRange::value_at(double share) const
{
    return kind == Kind::factor ? low * std::pow(high / low, share) : low + share * (high - low);
}

double VariedRange::share_of(double value) const
{
    return kind == Kind::factor ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
}

double VariedRange::theta_of_value(double value) const { return scaled ? std::log(value / centre) : value - centre; }

double VariedRange::theta_by_value(double value) const { return scaled ? 1 / value : 1; }

double VariedRange::theta_slope(double share) const
{
    return kind == Kind::factor ? std::log(high / low) : (high - low) * theta_by_value(value_at(share));
}

VariedCase varied_case(casefile::Case& input, const std::vector<casefile::VariedKeys>& list)
{
    VariedCase result;
    std::map<std::string, casefile::NumberChange> changes;
    for (const auto& keys : list) {
        const auto range = range_of(keys);
        result.parameters.push_back(
            {keys.name, keys.keys, range.scaled ? CaseParameter::Kind::factor : CaseParameter::Kind::shift});
        if (range.kind == VariedRange::Kind::value)
            for (const auto& key : keys.keys)
                changes[key] = {0, range.centre};
        result.ranges.push_back(range);
    }
    casefile::change_numbers(input, changes);
    return result;
}

std::vector<double> thetas_at(const std::vector<VariedRange>& ranges, const std::vector<double>& shares)
{
    std::vector<double> result;
    for (std::size_t k = 0; k < ranges.size(); ++k)
        result.push_back(ranges[k].theta_at(shares[k]));
    return result;
}

}  // namespace deadpoint::twin
