#pragma once

#include "deadpoint/twin/calibrate/forward.hpp"

#include <string>
#include <vector>

/// Numbers that a study takes from curves.
namespace deadpoint::twin {

/// Share of a change that is left when a press counts as warm.
inline constexpr double cold_share = 0.05;

struct Figure {
    enum class Kind {
        end,      ///< value at the end of the run
        at_time,  ///< value at a time
        warm      ///< time from which the output stays within cold_share of its change, at the end of the run
    };
    Kind kind = Kind::end;
    std::size_t output = 0;  ///< place in ForwardModel::outputs()
    double time = 0;         ///< of at_time [s]
};

/// Figures of the run of a model, in SI units; times to warm are zero for an output that does not change.
/// Between rows curves are cubic (calibration::interpolation), and straight for times to warm.
std::vector<double> figures_of(const ForwardModel& model, const Forecast& forecast, const std::vector<Figure>& figures);

/// Their derivatives, [parameter][figure], from a forecast with derivatives.
std::vector<std::vector<double>> figure_slopes(const ForwardModel& model, const Forecast& forecast,
                                               const std::vector<Figure>& figures);

}  // namespace deadpoint::twin
