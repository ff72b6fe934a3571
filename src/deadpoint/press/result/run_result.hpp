#pragma once

#include "deadpoint/exchange/drift.hpp"
#include "deadpoint/exchange/gaps.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/press/result/accuracy.hpp"
#include "deadpoint/press/result/frame_result.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/press/result/histories.hpp"
#include "deadpoint/press/result/press_compliance.hpp"
#include "deadpoint/press/result/reduced_result.hpp"
#include "deadpoint/press/result/sensitivities.hpp"
#include "deadpoint/press/result/view_data.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Results of a run of a case.
namespace deadpoint::press {

struct LoadsResult;

/// The adjoint's gap against the gap of the deformation solved directly at the last field time.
struct AdjointCheck {
    double time = 0;
    double by_adjoint = 0;
    double by_deformation = 0;
    double joint_opening = 0;  ///< largest distance of two centres of a joint after closing [m]
};

/// Results of a run. Its histories are by name; `thermal` holds the same numbers in the form of the
/// time steps.
struct RunResult : Histories {
    ThermalHistory thermal;                 ///< of the model: half of the press in a half model
    double symmetry_factor = 1;             ///< from the model to the whole press: 2 for a half model
    std::vector<FrictionSummary> friction;  ///< at every speed and force of the operation
    std::shared_ptr<const LoadsResult>
        loads;  ///< of the first segment in which the press runs, where the case has a linkage
    std::optional<BottomDeadPointSensitivity> sensitivity;
    std::optional<DriftSeries> drift;
    std::vector<DriftCauses> causes;  ///< at the largest |E_SW| of all steps, where that is not the end, and at the end
    GapSeries gaps;
    std::optional<PressCompliance> compliance;  ///< of a full run with a dimension chain
    std::optional<AdjointCheck> adjoint_check;
    std::optional<FrameResult> frame;  ///< where the case states a foundation, preload or wanted stress
    std::optional<ViewData> view;
    std::optional<AccuracyReport> accuracy;  ///< where the case asks for one
    std::optional<ReducedResult> reduced;    ///< of a run on a reduced model
    std::optional<Sensitivities> sensitivities;
    long long cells = 0;
    long long heat_unknowns = 0;
    long long deformation_cells = 0;  ///< the same as cells, or those of its own mesh; 0 without deformation
    long long deformation_unknowns = 0;
    int elastic_iterations = 0;
    int ranks = 1;
    double peak_memory = 0;                               ///< of all ranks together [byte]
    std::vector<std::pair<std::string, double>> timings;  ///< stage, wall time [s]
    std::vector<std::pair<double, std::string>> fields;   ///< time [s], file in the results folder
};

}  // namespace deadpoint::press
