#include "deadpoint/design/points.hpp"

#include "deadpoint/error.hpp"

#include <algorithm>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/sobol.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>

namespace deadpoint::design {
namespace {

// The middle of the cell of 2^-53 in which a number of 64 bits lies: never 0 or 1.
double share_of(std::uint64_t bits) { return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53; }

double quantile(const std::vector<double>& sorted, double probability)
{
    const double place = probability * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

std::vector<Point> sobol_points(std::size_t coordinates, std::size_t count, unsigned seed)
{
    if (coordinates == 0 || coordinates > most_coordinates)
        throw DomainError(
            fmt::format("a Sobol' sequence has 1 to {} coordinates, not {}", most_coordinates, coordinates));
    boost::random::mt19937_64 random(seed);
    std::vector<std::uint64_t> shift(coordinates);
    std::ranges::generate(shift, [&] { return random(); });
    boost::random::sobol sequence(coordinates);  // without its zero point
    std::vector<Point> points(count, Point(coordinates));
    for (std::size_t n = 0; n < count; ++n)
        for (std::size_t k = 0; k < coordinates; ++k)
            points[n][k] = share_of((n == 0 ? 0 : sequence()) ^ shift[k]);
    return points;
}

Band band_of(double value, std::vector<double> resampled, double probability)
{
    std::erase_if(resampled, [](double one) { return !std::isfinite(one); });
    if (resampled.empty())
        return {value, value, value};
    std::ranges::sort(resampled);
    return {value, quantile(resampled, (1 - probability) / 2), quantile(resampled, (1 + probability) / 2)};
}

std::vector<std::vector<std::size_t>> resampled_rows(std::size_t rows, const Bootstrap& bootstrap)
{
    boost::random::mt19937_64 random(bootstrap.seed);
    std::vector<std::vector<std::size_t>> result(rows == 0 ? 0 : bootstrap.resamples);
    for (auto& drawn : result) {
        const boost::random::uniform_int_distribution<std::size_t> any(0, rows - 1);
        drawn.resize(rows);
        std::ranges::generate(drawn, [&] { return any(random); });
    }
    return result;
}

}  // namespace deadpoint::design
