#pragma once

#include "deadpoint/crankshaft/cycle.hpp"
#include "deadpoint/crankshaft/modes.hpp"
#include "deadpoint/crankshaft/response/harmonic_response.hpp"
#include "deadpoint/crankshaft/shaft/shaft_loads.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/warning.hpp"
#include "deadpoint/mechanism/cycle.hpp"
#include "deadpoint/tribology/friction/duty.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

/// Motion, joint forces and crankshaft loads of a case over one turn at one operating point.
namespace deadpoint::press {

/// Load of a guide's faces besides the net force: from the gib, and from a moment on the guide's
/// ends.
struct GuideLoad {
    int joint = 0;  ///< in LoadsResult::linkage
    tribology::GuideFaces faces;
    double mean_normal = 0;  ///< of the sum of the faces' normal forces (tribology::guide_normal_force) [N]
    double peak_moment = 0;  ///< largest, either way; counts only with a length [N m]
    bool balanced = false;   ///< no net force and no moment: balanced by symmetry
};

/// Bearings that share a seat, as one.
struct SeatCycles {
    std::vector<BearingCycle> rigid;
    std::vector<BearingCycle> flexible;  ///< empty with the rigid model
};

struct CrankshaftLoads {
    std::string model;  ///< "rigid" or "flexible", as the case asks
    crankshaft::Shaft shaft;
    crankshaft::ShaftLoads loads;
    crankshaft::ShaftCycle rigid;
    std::optional<crankshaft::ShaftCycle> flexible;
    std::vector<std::string> seats;
    SeatCycles by_seat;
    crankshaft::StaticState sag;
    std::vector<double> campbell_speeds;                  ///< [rad/s], from standstill on
    std::vector<std::vector<crankshaft::Mode>> campbell;  ///< per speed
    std::vector<crankshaft::Mode> modes;                  ///< at the operating speed
    std::vector<crankshaft::CriticalSpeed> critical_speeds;
    crankshaft::UnbalanceResponse unbalance;  ///< at the operating speed
    double belt_force = 0;                    ///< [N]

    /// The cycle of the model that the case states.
    [[nodiscard]] const crankshaft::ShaftCycle& cycle() const { return flexible ? *flexible : rigid; }
    [[nodiscard]] const std::vector<BearingCycle>& seat_cycles() const
    {
        return flexible ? by_seat.flexible : by_seat.rigid;
    }
};

struct LoadsResult {
    int segment = 0;
    double speed = 0;           ///< of the crank [rad/s]
    double force = 0;           ///< of the process, at its peak [N]
    std::string process_force;  ///< kind
    Linkage linkage;            ///< whole, with the images of what exists twice
    std::vector<bool> images;   ///< per joint: image of another
    std::vector<std::string> freed_guides;
    std::vector<BodyMass> masses;
    std::vector<std::string> mass_origins;
    mechanism::CycleRequest request;
    CycleHistory history;
    mechanism::StrokeFigures stroke;
    mechanism::DriveFigures drive;
    std::vector<mechanism::ForceRatio> force_ratios;
    std::vector<LengthSensitivity> lengths;  ///< of the case's own linkage
    std::vector<GuideLoad> guides;
    double throw_at_bottom = 0;  ///< direction of the crank throw at bottom dead point, from the x axis [rad]
    std::optional<CrankshaftLoads> crankshaft;
    std::vector<Warning> warnings;
    std::vector<std::pair<std::string, double>> timings;  ///< stage, wall time [s]
};

}  // namespace deadpoint::press
