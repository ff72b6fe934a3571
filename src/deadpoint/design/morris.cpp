#include "deadpoint/design/morris.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace deadpoint::design {
namespace {

constexpr int levels = 4;  // 0, 1/3, 2/3, 1
constexpr int jump = 2;    // levels that an input moves

using Random = boost::random::mt19937_64;

int any_below(int end, Random& random) { return boost::random::uniform_int_distribution<int>(0, end - 1)(random); }

// Fisher and Yates; std::shuffle gives another order with each library.
std::vector<std::size_t> shuffled(std::size_t count, Random& random)
{
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = count; k > 1; --k)
        std::swap(order[k - 1], order[static_cast<std::size_t>(any_below(static_cast<int>(k), random))]);
    return order;
}

Point share_of(const std::vector<int>& place)
{
    Point point;
    for (const int level : place)
        point.push_back(static_cast<double>(level) / (levels - 1));
    return point;
}

double mean_of(const std::vector<double>& values)
{
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double deviation_of(const std::vector<double>& values)
{
    if (values.size() < 2)
        return 0;
    const double mean = mean_of(values);
    double sum = 0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

MorrisEffect effect_of(const std::vector<double>& effects, const Bootstrap& bootstrap)
{
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    if (effects.empty())
        return {{missing, missing, missing}, missing, missing};
    std::vector<double> sizes, resampled;
    for (const double effect : effects)
        sizes.push_back(std::abs(effect));
    for (const auto& rows : resampled_rows(sizes.size(), bootstrap)) {
        double sum = 0;
        for (const auto row : rows)
            sum += sizes[row];
        resampled.push_back(sum / static_cast<double>(sizes.size()));
    }
    return {band_of(mean_of(sizes), std::move(resampled), bootstrap.probability), mean_of(effects),
            deviation_of(effects)};
}

}  // namespace

MorrisDesign::MorrisDesign(std::size_t inputs, std::size_t trajectories, unsigned seed) : inputs_(inputs)
{
    Random random(seed);
    for (std::size_t t = 0; t < trajectories; ++t) {
        std::vector<int> place(inputs);
        std::ranges::generate(place, [&] { return any_below(levels, random); });
        points_.push_back(share_of(place));
        for (const auto input : shuffled(inputs, random)) {
            place[input] += place[input] < jump ? jump : -jump;
            points_.push_back(share_of(place));
        }
    }
}

std::vector<MorrisEffect> morris_effects(std::span<const double> values, const MorrisDesign& design,
                                         const Bootstrap& bootstrap)
{
    if (values.size() != design.size())
        throw DomainError(fmt::format("{} values for {} points", values.size(), design.size()));
    std::vector<std::vector<double>> effects(design.inputs());
    for (std::size_t n = 1; n < design.size(); ++n) {
        if (n % (design.inputs() + 1) == 0)
            continue;
        const auto& from = design.point(n - 1);
        const auto& to = design.point(n);
        const auto moved = static_cast<std::size_t>(std::ranges::mismatch(from, to).in1 - from.begin());
        const double effect = (values[n] - values[n - 1]) / (to[moved] - from[moved]);
        if (std::isfinite(effect))
            effects[moved].push_back(effect);
    }
    std::vector<MorrisEffect> result;
    for (const auto& of_input : effects)
        result.push_back(effect_of(of_input, bootstrap));
    return result;
}

}  // namespace deadpoint::design
