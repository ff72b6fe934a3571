#pragma once

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/observer.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/fem/model.hpp"

#include <optional>
#include <string>
#include <vector>

/// Supports, weights and preload of the machine, and their results: forces of rods, closed bonds,
/// stress.
namespace deadpoint::study {

/// A preloaded rod.
struct RodForce {
    std::string part;
    std::string preload;    ///< name of its table in the case
    double start = 0;       ///< [N]
    Series change;          ///< by warming, at the steps [N]
    double held_share = 0;  ///< of the process force
};

/// Opening at one time of a bond that only preload holds together.
struct Opening {
    double time = 0;
    double largest = 0;  ///< tension [Pa]; negative: pressure everywhere
    Vec3 place{};        ///< of it
    double share = 0;    ///< of the bond's area under tension
};

/// A bond that only preload holds together.
struct ClosedBond {
    std::string name;  ///< "part|part"
    std::string preload;
    double area = 0;                ///< in this model [m2]
    double start = 0;               ///< force across it, tension positive [N]
    Series change;                  ///< by warming, at the steps [N]
    std::vector<Opening> openings;  ///< at the field times
};

/// The largest stress of a part at one time.
struct StressPeak {
    double time = 0;
    std::string part;
    double von_mises = 0;  ///< [Pa]
    Vec3 place{};
    std::array<double, 3> principal{};  ///< at that place, largest first [Pa]
    double highest_principal = 0;       ///< of the part [Pa]
    double lowest_principal = 0;        ///< of the part [Pa]
};

struct FrameResult {
    std::vector<RodForce> rods;
    std::vector<ClosedBond> bonds;
    std::optional<double> support_force;  ///< upwards on the feet, of the whole machine, where weights act [N]
    std::vector<StressPeak> stress;
};

/// True if the case requests results of the deformation that need no dimension chain.
bool has_frame_state(const casefile::Case& input);

/// The supports of the feet.
Foundation describe_foundation(const casefile::Case& input, const Machine& machine);

/// Gauges of a machine with preload: its rods, and the bonds that they close.
struct FrameGauges {
    std::vector<ForceGauge> rods, bonds;
    std::vector<double> wanted;  ///< preload of each rod [N]
    FrameResult start;           ///< names and stated values of each
};

/// @throws CaseError for all preloads without a rod, rods that are preloaded twice and pairs that are not bonded
FrameGauges frame_gauges(const casefile::Case& input, const Machine& machine);

/// The machine under weights and preload, and its recorded forces. Collective, as fem::Model.
class FrameState {
public:
    /// @throws InputError for rods without supports, pairs that are not bonded, or weights without
    /// support
    FrameState(const casefile::Case& input, const Machine& machine, fem::Model& model);

    /// Of rods and closed bonds, in this order.
    [[nodiscard]] const std::vector<fem::Adjoint>& adjoints() const { return adjoints_; }
    /// Forces at the start of a run.
    [[nodiscard]] FrameResult start() const { return gauges_.start; }
    /// Adds stress and openings at one time; returns the data for the field file.
    std::vector<fem::PointData> add_time(const casefile::Case& input, double time, const fem::Field& temperature,
                                         const fem::Displacement& displacement, FrameResult& result) const;

private:
    [[nodiscard]] int finer_part(int bond) const;
    [[nodiscard]] std::vector<int> stressed_parts(const casefile::Case& input) const;
    [[nodiscard]] Opening opening(int bond, const PartStress& stress, double time) const;

    const Machine& machine_;
    fem::Model& model_;
    FrameGauges gauges_;
    RestLoads loads_;
    std::optional<fem::Displacement> at_rest_;
    std::vector<fem::Adjoint> adjoints_;
};

/// Reads the courses of rods and bonds from the history's functionals from index `first` on.
void read_courses(const ThermalHistory& history, std::size_t first, FrameResult& result);

/// Warns of rods whose force is too small and of closed bonds that would open.
void warn_about_frame(const casefile::Case& input, const ThermalHistory& history, const FrameResult& result,
                      Observer& observer);

}  // namespace deadpoint::study
