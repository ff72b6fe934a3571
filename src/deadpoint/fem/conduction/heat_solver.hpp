#pragma once

#include "deadpoint/fem/conduction/heat_system.hpp"
#include "deadpoint/fem/space/fields.hpp"

#include <memory>
#include <vector>

namespace deadpoint {

class Observer;
struct Material;
struct HeatCauses;
}  // namespace deadpoint

namespace deadpoint::heat {

template <class System>
class HeatRun;
template <class System>
class HeatAdjoint;

}  // namespace deadpoint::heat

namespace deadpoint::reduce {

template <class System>
class ReducedAdjoint;

}  // namespace deadpoint::reduce

/// Internal to fem/: transient heat conduction with contact layers.
namespace deadpoint::fem {

struct CheckpointPlan;  // checkpoint.hpp

/// One heat problem on the finite elements of a machine: its system, its run, and their results.
class HeatSolver {
public:
    HeatSolver(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem);
    ~HeatSolver();

    /// Adopts another problem if the matrices can be used for it.
    bool adopt(const HeatProblem& problem);
    void start_from(ThermalState state) { state_ = std::move(state); }
    /// State at the start of the run, or at its end.
    [[nodiscard]] ThermalState state() const;
    /// z of (M / time + K) z = weights per functional, with the convection coefficients, joints and
    /// slopes of the heat laws at `time`.
    std::vector<Field> duals(double time, const Field& temperature, const std::vector<Adjoint>& weights);
    ThermalHistory run(const std::vector<Adjoint>& adjoints, double reference_temperature, Attribution attribution,
                       Observer& observer, const StepCallback& on_step, const FieldCallback& on_field,
                       const CheckpointPlan* checkpoints = nullptr);
    /// Contributions of the heat sources to a functional of the temperatures at a time of the run.
    /// The run cannot continue afterwards.
    HeatCauses causes(const std::vector<double>& weights, std::size_t row);
    /// The same on a basis of a few fields, unless a temperature is prescribed.
    HeatCauses causes_on_basis(const std::vector<double>& weights, std::size_t row);

private:
    using Run = heat::HeatRun<HeatSystem>;
    void make_run(std::size_t functionals, std::size_t contributions);

    HeatSystem system_;
    const HeatProblem* problem_;
    ThermalState state_;  ///< at the start
    std::unique_ptr<Run> run_;
    std::unique_ptr<heat::HeatAdjoint<HeatSystem>> adjoint_;
    std::unique_ptr<reduce::ReducedAdjoint<HeatSystem>> reduced_adjoint_;
    double reference_ = 0;
};

}  // namespace deadpoint::fem
