#pragma once

#include "deadpoint/exchange/deformation.hpp"
#include "deadpoint/exchange/laws/material.hpp"
#include "deadpoint/exchange/stress.hpp"
#include "deadpoint/fem/space/fields.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace deadpoint {

class Observer;
struct CellCorner;
struct HeatCauses;
struct HeatProbe;
struct HeatProblem;
struct Machine;
struct ThermalHistory;
}  // namespace deadpoint

namespace deadpoint::fem {

class HeatProjector;    // reduction/heat_projector.hpp
class StateFields;      // reduction/field_file.hpp
struct CheckpointPlan;  // checkpoint.hpp

/// Finite elements on the whole machine: transient heat conduction with contact layers in joints,
/// and the thermo-elastic deformation of each body by itself.
///
/// Every part has its own mesh and shares no unknown with another: interfaces couple parts by their
/// contact conductances. Bonds (perfect contact) conduct by Nitsche's method (symmetric and
/// consistent: a linear field passes exactly on any two meshes) and hold by mortar ties: the finer
/// side's nodes follow the coarser side's cells. Bodies are free except for the symmetry plane and
/// the feet; remaining rigid motions are held without force and removed from all results.
///
/// The deformation may have a separate mesh. Temperatures are then transferred by a least-squares
/// fit, and displacements return by their values. Functionals and feet belong to the machine of the
/// deformation, everything else to that of the heat.
///
/// Every member function is collective: all ranks call it with the same arguments.
class Model {
public:
    /// @param materials  per part of the machine
    /// @param orders     of the elements, 1 or 2, per part of the machine
    /// @param deformation  the same parts meshed for the deformation; none: the same mesh. Outlives the model.
    /// @param deformation_orders  of the elements on that mesh; empty: those of the heat
    /// @throws InputError if ranks built different meshes or a material constant is not positive
    /// and finite
    Model(const Machine& machine, std::vector<Material> materials, std::vector<int> orders, Observer& observer,
          const Machine* deformation = nullptr, std::vector<int> deformation_orders = {});
    Model(const Machine& machine, std::vector<Material> materials, int order, Observer& observer,
          const Machine* deformation = nullptr);
    ~Model();
    Model(Model&&) noexcept;

    [[nodiscard]] ModelSize size() const;

    /// Builds the matrices of a heat problem, which must outlive the next heat(). Matrices that
    /// were built before and not used yet are kept if they can be used for this problem too.
    void assemble_heat(const HeatProblem& problem);
    /// Temperature field of the assembled problem over the operation's segments: TR-BDF2 (second order, L-stable, error
    /// estimate of third order; Hosea and Shampine 1996), each stage by Newton with the joint heat's dependence on the
    /// joint temperature included. The fluxes of the stages close the energy balance exactly.
    /// @param attribution  the adjoints whose values are split by part, or -1
    /// @param checkpoints  where the run saves its state, and whether it continues from there;
    /// null: nowhere
    /// @throws ConvergenceError, DomainError for a non-finite temperature; as open_checkpoint where it resumes
    ThermalHistory heat(const std::vector<Adjoint>& adjoints, double reference_temperature, Attribution attribution,
                        Observer& observer, const StepCallback& on_step, const FieldCallback& on_field,
                        const CheckpointPlan* checkpoints = nullptr);

    /// Contributions of the heat sources to a functional of the last heat()'s temperatures, by
    /// running backward over its steps. Its problem must still exist, and release_heat() must not
    /// have been called.
    /// @param weights  need not be an adjoint of heat(): value = sum of weight (T - T_reference)
    /// @param row      of the history that heat() returned: the time
    HeatCauses heat_causes(const Adjoint& weights, std::size_t row);
    /// The same on a basis of a few fields, which takes a fraction of the time (reduce/causes/reduced_adjoint.hpp).
    HeatCauses heat_causes_on_basis(const Adjoint& weights, std::size_t row);
    /// Frees matrices and steps of the last heat().
    void release_heat();
    /// The heat terms of a problem for a reduced model. The model must outlive it.
    /// @param observed        recorded besides the functionals of the heat balance, as heat() does
    /// @param largest_factor  see HeatProjector
    std::unique_ptr<HeatProjector> projector(const HeatProblem& problem, const std::vector<Adjoint>& observed,
                                             Attribution attribution, long long largest_factor);
    /// The fields of a reduced model's states, as HeatProjector::write_fields() wrote them. Errors as read_fields()
    /// (reduction/field_file.hpp).
    [[nodiscard]] StateFields read_fields(const std::string& file, const std::string& model, std::size_t states) const;

    /// Starts the assembled problem from a state that write_state() wrote, on any number of ranks.
    /// @throws IoError if the file cannot be read or is cut short; InputError if it belongs to another mesh
    void start_from(const std::string& file);
    /// Writes the final state of the last heat() to a file.
    void write_state(const std::string& file) const;

    /// Sets the supports of the machine; a surface without more stays in its plane, whose normal is
    /// along an axis. Call it before the functions below.
    void support(const Foundation& foundation);
    void support(int feet_surface) { support(Foundation{feet_surface}); }
    /// Temperature weights of displacement functionals, one elastic solve each.
    std::vector<Adjoint> adjoints(const std::vector<Functional>& functionals);
    /// The same for forces.
    std::vector<Adjoint> adjoints(const std::vector<ForceGauge>& gauges);
    /// The deformation for a temperature field, each body apart from a rigid motion.
    Displacement displacement(const Field& temperature, double reference_temperature);
    /// The deformation by weights and initial strain.
    Displacement displacement(const RestLoads& loads);
    std::vector<double> evaluate(const std::vector<Functional>& functionals, const Displacement& displacement);
    /// Forces due to those loads [N], of the whole machine if the symmetry plane cuts it.
    std::vector<double> forces(const std::vector<ForceGauge>& gauges, const RestLoads& loads,
                               const Displacement& displacement);
    double apply(const Adjoint& adjoint, const Field& temperature, double reference_temperature);
    /// True if the deformation is linear in the temperature: no material has a table of its
    /// expansion.
    [[nodiscard]] bool expands_linearly() const;
    /// The rise [K] in which the deformation is linear: T - T_reference if the expansion is
    /// constant, else the rise that gives the same strain with the part's expansion_scale()
    /// (exchange/laws/material).
    [[nodiscard]] Field expansion_rise(const Field& temperature, double reference_temperature) const;
    /// The deformation for such a rise.
    Displacement displacement_of_rise(const Field& rise);
    /// Several at once, which takes far less time each where a sparse factor fits into memory.
    std::vector<Displacement> displacements_of_rises(const std::vector<Field>& rises);
    /// Weights that give the same value with T - T_reference itself at this temperature:
    /// weight (eps(T) - eps(T_reference)) / (scale (T - T_reference)).
    Adjoint secant(const Adjoint& adjoint, const Field& temperature, double reference_temperature);
    /// Thermal stress of a deformation at all nodes of the parts, each part recovered by itself (StressRecovery).
    std::vector<PartStress> stress(const std::vector<int>& parts, const Displacement& displacement,
                                   const Field& temperature, double reference_temperature) const;
    /// Stress of the deformation by weights and initial strain.
    std::vector<PartStress> stress(const std::vector<int>& parts, const Displacement& displacement,
                                   const RestLoads& loads) const;
    /// Thermal stress at points of parts.
    std::vector<Tensor6> stress_at(const std::vector<HeatProbe>& points, const Displacement& displacement,
                                   const Field& temperature, double reference_temperature) const;
    /// Frees matrices and preconditioner of the deformation.
    void release_elasticity();
    [[nodiscard]] int elastic_iterations() const;

    /// Adjoint (DWR) solutions: change of functionals of the temperature at a time by one watt at
    /// any place since the start of the run, z of (M / time + K) z = weights, per functional [its
    /// unit / W]. Joints, convection coefficients and the slopes of their laws are those at that
    /// time; the oil has its initial temperatures.
    /// @param time  since the start of the run, > 0 [s]
    std::vector<Field> heat_adjoints(const HeatProblem& problem, double time, const Field& temperature,
                                     const std::vector<Adjoint>& weights);
    /// The temperature at a point as a functional. @throws InputError if the point is off its part
    Adjoint probe_weights(const HeatProbe& probe);
    /// Displacement under the weights of a functional as forces [m/N].
    Displacement deformation_adjoint(const Functional& functional);
    /// Estimated change of functionals by finer parts, per adjoint solution and part
    /// (error_estimate.hpp).
    std::vector<std::vector<double>> conduction_errors(const Field& temperature, const std::vector<Field>& duals);
    std::vector<std::vector<double>> deformation_errors(const Displacement& displacement,
                                                        const std::vector<Displacement>& duals);
    std::vector<double> interpolation_errors(const Field& temperature, const std::vector<HeatProbe>& probes);

    /// Temperature at points of parts.
    std::vector<double> sample(const std::vector<HeatProbe>& probes, const Field& field);
    /// Temperature [K] or displacement [m] at nodes of the mesh.
    std::vector<double> at_corners(const std::vector<CellCorner>& corners, const Field& field) const;
    std::vector<Vec3> at_corners(const std::vector<CellCorner>& corners, const Displacement& displacement) const;
    Field constant_field(double temperature) const;
    Field interpolate_field(const std::function<double(const Vec3&)>& temperature) const;

    /// One time of the animation: folder/name.vtu (or .pvtu with pieces) with temperature [degC], and displacement [mm]
    /// where one is given, after adding each part's rigid motion. Returns the file name to list in a .pvd.
    std::string write_fields(const std::string& folder, const std::string& name, const Field& temperature,
                             const Displacement* displacement, const std::vector<RigidMotion>& motion_of_part,
                             const std::vector<int>& body_of_part, const std::vector<std::string>& comments,
                             const std::vector<PointData>& point_data = {});

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace deadpoint::fem
