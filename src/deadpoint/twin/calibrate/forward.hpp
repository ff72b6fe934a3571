#pragma once

#include "deadpoint/twin/calibrate/parameter.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace deadpoint {
class Observer;
struct HeatProblem;
}  // namespace deadpoint
namespace deadpoint::drift {
struct BearingPlay;
}
namespace deadpoint::reduce {
struct RecordedRun;
}
namespace deadpoint::press {
class LoadsCache;
}

/// A press as a function from parameters to curves, on its reduced model.
namespace deadpoint::twin {

struct ReducedPress;

/// A curve that a run of a reduced press has.
struct ForwardOutput {
    enum class Kind { probe, dimension, corner };
    Kind kind = Kind::probe;
    std::string name;  ///< of the probe, of the dimension ("E_SW", "E_BG", "E_WG", "E_CS", "E_BC") or of the corner
    std::size_t index = 0;  ///< of the probe; place in that list of dimensions; of the corner
};

/// All outputs of a case on its reduced press.
std::vector<ForwardOutput> forward_outputs(const casefile::Case& input, const ReducedPress& press);

/// Thrown by a run that Observer::cancelled() stops; no error.
struct Stopped {};

/// Outputs of a run at its rows, with their derivatives.
struct Forecast {
    std::vector<double> time;                ///< of the rows [s]; equal times where segments meet
    std::vector<std::vector<double>> value;  ///< [output][row]: temperatures [K], changes of dimensions [m]
    /// [parameter][output][row], by theta of the parameter; empty if not asked for
    std::vector<std::vector<std::vector<double>>> derivative;
};

/// How runs of a forward model are made.
struct ForwardOptions {
    double fixed_step = 0;  ///< [s]; > 0: steps of this length, so that outputs are smooth functions of parameters
    int threads = 1;        ///< for derivatives
    press::LoadsCache* loads = nullptr;  ///< shared with other models; null: one of its own
};

/// A case with free parameters on its reduced press, from theta to outputs. Any number of threads may use it.
///
/// Derivatives are exact for the steps as they are (reduce/sensitivity): the heat problem is made at theta - h and
/// theta + h of each parameter, h = 1e-3 (of shifts 1e-3 of their unit), and the run is derived along the difference.
/// They hold the number and length of the steps, and the play of the crank's bearings as BearingPlay::slope() has it.
class ForwardModel {
public:
    /// @param press  must outlive this
    /// @throws InputError if the case is not that press, or if a parameter changes what a reduced model cannot
    ForwardModel(casefile::Case input, const ReducedPress& press, std::vector<CaseParameter> parameters,
                 ForwardOptions options = {});
    ~ForwardModel();
    ForwardModel(ForwardModel&&) noexcept;

    [[nodiscard]] const std::vector<ForwardOutput>& outputs() const;
    [[nodiscard]] const std::vector<CaseParameter>& parameters() const;
    [[nodiscard]] const casefile::Case& input() const;
    /// Duration of the operation [s].
    [[nodiscard]] double end() const;
    /// Temperature from which a probe's rise counts [K].
    [[nodiscard]] double start_of(const ForwardOutput& output) const;

    /// @param coarser  factor on ForwardOptions::fixed_step, for a quick look
    /// @throws InputError, CaseError as a run; Stopped
    [[nodiscard]] Forecast run(const std::vector<double>& theta, bool derivatives, Observer& observer,
                               double coarser = 1) const;
    /// Coefficients at theta outside of the range for which the press was reduced, as text.
    [[nodiscard]] std::vector<std::string> outside(const std::vector<double>& theta) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace deadpoint::twin
