#include "deadpoint/twin/explore/figures.hpp"

#include "deadpoint/calibration/curves.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace deadpoint::twin {
namespace {

/// The last time at which a curve has a share of its change still before it.
struct Crossing {
    double time = 0;
    double share = 0;  ///< of the change: cold_share, or -cold_share for a curve that comes back
    std::size_t row = 0;
    double place = 0;  ///< between this row and the next, 0..1
    double slope = 0;  ///< of the curve there
};

std::optional<Crossing> crossing_of(const std::vector<double>& time, const std::vector<double>& value, double start)
{
    const double end = value.back(), change = start - end;
    if (change == 0)
        return std::nullopt;
    const auto left = [&](std::size_t row) { return (value[row] - end) / change; };
    for (std::size_t row = value.size() - 1; row-- > 0;) {
        if (std::abs(left(row)) <= cold_share || time[row + 1] == time[row])
            continue;
        const double share = std::copysign(cold_share, left(row));
        const double place = (left(row) - share) / (left(row) - left(row + 1));
        const double step = time[row + 1] - time[row];
        return Crossing{time[row] + place * step, share, row, place, (value[row + 1] - value[row]) / step};
    }
    return std::nullopt;
}

// Weights of rows in the values at the times of the figures; the last row for all others.
Eigen::MatrixXd weights_of(const Forecast& forecast, const std::vector<Figure>& figures)
{
    std::vector<double> times;
    for (const auto& figure : figures)
        times.push_back(figure.kind == Figure::Kind::at_time ? std::min(figure.time, forecast.time.back())
                                                             : forecast.time.back());
    return calibration::interpolation(forecast.time, times);
}

double weighted(const Eigen::MatrixXd& weights, std::size_t figure, const std::vector<double>& values)
{
    return weights.row(static_cast<Eigen::Index>(figure))
        .dot(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
}

}  // namespace

std::vector<double> figures_of(const ForwardModel& model, const Forecast& forecast, const std::vector<Figure>& figures)
{
    const auto weights = weights_of(forecast, figures);
    std::vector<double> result;
    for (std::size_t k = 0; k < figures.size(); ++k) {
        const auto& values = forecast.value[figures[k].output];
        if (figures[k].kind != Figure::Kind::warm) {
            result.push_back(weighted(weights, k, values));
            continue;
        }
        const auto found = crossing_of(forecast.time, values, model.start_of(model.outputs()[figures[k].output]));
        result.push_back(found ? found->time : 0);
    }
    return result;
}

std::vector<std::vector<double>> figure_slopes(const ForwardModel& model, const Forecast& forecast,
                                               const std::vector<Figure>& figures)
{
    const auto weights = weights_of(forecast, figures);
    std::vector<std::vector<double>> result;
    for (const auto& by_parameter : forecast.derivative) {
        auto& slopes = result.emplace_back();
        for (std::size_t k = 0; k < figures.size(); ++k) {
            const auto output = figures[k].output;
            const auto& slope = by_parameter[output];
            if (figures[k].kind != Figure::Kind::warm) {
                slopes.push_back(weighted(weights, k, slope));
                continue;
            }
            // y(t) = y_end + share (y_start - y_end): dt = ((1 - share) dy_end - dy(t)) / y'(t)
            const auto at = crossing_of(forecast.time, forecast.value[output], model.start_of(model.outputs()[output]));
            slopes.push_back(!at ? 0
                                 : ((1 - at->share) * slope.back() - (1 - at->place) * slope[at->row] -
                                    at->place * slope[at->row + 1]) /
                                       at->slope);
        }
    }
    return result;
}

}  // namespace deadpoint::twin
