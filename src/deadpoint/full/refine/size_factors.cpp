#include "deadpoint/full/refine/refine.hpp"

#include <algorithm>
#include <cmath>

namespace deadpoint::full {
namespace {

constexpr double kept_above = 0.93;
/// Where not even the smallest factors reach the target, it is set this much above what they reach: parts of small
/// error would else be refined for nothing.
constexpr double slack = 1.25;

using SizeFactors = std::vector<double>;

// The factors for one price of a cell.
SizeFactors at_price(const std::vector<PartError>& parts, double price, double least)
{
    SizeFactors factors;
    for (const auto& part : parts) {
        const double free = part.error > 0 && !part.fixed
                                ? std::pow(price * part.cells / (part.order * part.error), 1 / (part.order + 3))
                                : 1;
        factors.push_back(std::clamp(free, least, 1.0));
    }
    return factors;
}

double error_left(const std::vector<PartError>& parts, const SizeFactors& factors)
{
    double sum = 0;
    for (std::size_t p = 0; p < parts.size(); ++p)
        sum += parts[p].error * std::pow(factors[p], parts[p].order);
    return sum;
}

double cells_then(const std::vector<PartError>& parts, const SizeFactors& factors)
{
    double sum = 0;
    for (std::size_t p = 0; p < parts.size(); ++p)
        sum += parts[p].cells * std::pow(factors[p], -3);
    return sum;
}

// The highest price at which `enough` holds; it holds at low prices.
template <class Enough>
double highest_price(const Enough& enough)
{
    double low = -80, high = 80;  // of the logarithm; prices are far inside
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (enough(std::exp(middle)) ? low : high) = middle;
    }
    return std::exp(low);
}

}  // namespace

std::vector<double> size_factors(const std::vector<PartError>& parts, double target, double least, double most_cells)
{
    SizeFactors smallest;
    for (const auto& part : parts)
        smallest.push_back(part.fixed ? 1 : least);
    const double reachable = std::max(target, slack * error_left(parts, smallest));
    double price = highest_price([&](double p) { return error_left(parts, at_price(parts, p, least)) <= reachable; });
    const double affordable =
        highest_price([&](double p) { return cells_then(parts, at_price(parts, p, least)) > most_cells; });
    auto factors = at_price(parts, std::max(price, affordable), least);
    for (double& factor : factors)
        if (factor > kept_above)
            factor = 1;
    return factors;
}

}  // namespace deadpoint::full
