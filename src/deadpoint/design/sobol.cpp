#include "deadpoint/design/sobol.hpp"

#include "deadpoint/error.hpp"

#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace deadpoint::design {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr double least_variation = 1e-10;  // of the mean: what rounding leaves of a constant

/// Values by row: A, B, AB_1, AB_2, ...
struct Rows {
    std::span<const double> values;
    std::size_t count;  ///< of the design
    [[nodiscard]] double at(std::size_t matrix, std::size_t row) const { return values[matrix * count + row]; }
};

bool is_whole(const Rows& rows, std::size_t row, std::size_t matrices)
{
    for (std::size_t m = 0; m < matrices; ++m)
        if (!std::isfinite(rows.at(m, row)))
            return false;
    return true;
}

struct Moments {
    double mean = 0, variance = 0;
};

Moments moments_of(const Rows& rows, const std::vector<std::size_t>& used)
{
    Moments result;
    const double count = 2 * static_cast<double>(used.size());
    for (const auto row : used)
        result.mean += (rows.at(0, row) + rows.at(1, row)) / count;
    for (const auto row : used)
        for (const std::size_t m : {0, 1})
            result.variance += std::pow(rows.at(m, row) - result.mean, 2) / (count - 1);
    return result;
}

struct Estimate {
    double first = missing, total = missing;
};

Estimate estimate(const Rows& rows, const std::vector<std::size_t>& used, std::size_t input, const Moments& moments)
{
    double first = 0, total = 0;
    for (const auto row : used) {
        const double change = rows.at(2 + input, row) - rows.at(0, row);
        first += (rows.at(1, row) - moments.mean) * change;
        total += change * change;
    }
    const double scale = moments.variance * static_cast<double>(used.size());
    return {first / scale, total / (2 * scale)};
}

bool varies(const Moments& moments)
{
    return std::sqrt(moments.variance) > least_variation * std::abs(moments.mean) && moments.variance > 0;
}

// The rows drawn as places in the list of those used.
std::vector<std::size_t> chosen(const std::vector<std::size_t>& used, const std::vector<std::size_t>& drawn)
{
    std::vector<std::size_t> result;
    result.reserve(drawn.size());
    for (const auto place : drawn)
        result.push_back(used[place]);
    return result;
}

}  // namespace

SobolDesign::SobolDesign(std::size_t inputs, std::size_t rows, unsigned seed)
    : inputs_(inputs), both_(sobol_points(2 * inputs, rows, seed))
{}

Point SobolDesign::point(std::size_t number) const
{
    const std::size_t matrix = number / rows();
    const auto& row = both_[number % rows()];
    const auto middle = row.begin() + static_cast<std::ptrdiff_t>(inputs_);
    if (matrix == 1)
        return {middle, row.end()};
    Point point(row.begin(), middle);
    if (matrix > 1)
        point[matrix - 2] = row[inputs_ + matrix - 2];
    return point;
}

SobolIndices sobol_indices(std::span<const double> values, std::size_t inputs, const Bootstrap& bootstrap)
{
    if (values.size() % (inputs + 2) != 0)
        throw DomainError(fmt::format("{} values are no multiple of {} inputs and 2", values.size(), inputs));
    const Rows rows{values, values.size() / (inputs + 2)};
    std::vector<std::size_t> used;
    for (std::size_t row = 0; row < rows.count; ++row)
        if (is_whole(rows, row, inputs + 2))
            used.push_back(row);
    SobolIndices result{missing, missing, used.size(), std::vector<SobolIndex>(inputs)};
    const auto constant = SobolIndex{{missing, missing, missing}, {missing, missing, missing}};
    result.inputs.assign(inputs, constant);
    if (used.size() < 2)
        return result;
    const auto moments = moments_of(rows, used);
    result.mean = moments.mean;
    result.variance = moments.variance;
    if (!varies(moments))
        return result;
    std::vector<std::vector<double>> first(inputs), total(inputs);
    for (const auto& drawn : resampled_rows(used.size(), bootstrap)) {
        const auto again = chosen(used, drawn);
        const auto moments_again = moments_of(rows, again);
        for (std::size_t i = 0; i < inputs; ++i) {
            const auto one = estimate(rows, again, i, moments_again);
            first[i].push_back(one.first);
            total[i].push_back(one.total);
        }
    }
    for (std::size_t i = 0; i < inputs; ++i) {
        const auto one = estimate(rows, used, i, moments);
        result.inputs[i] = {band_of(one.first, std::move(first[i]), bootstrap.probability),
                            band_of(one.total, std::move(total[i]), bootstrap.probability)};
    }
    return result;
}

double total_index_bound(std::span<const double> slopes, double variance)
{
    if (slopes.empty() || !(variance > 0))
        return missing;
    double mean = 0;
    for (const double slope : slopes)
        mean += slope * slope / static_cast<double>(slopes.size());
    return mean / (boost::math::constants::pi_sqr<double>() * variance);
}

}  // namespace deadpoint::design
