#pragma once

#include "deadpoint/core/observer.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/fem/conduction/coarse_matrices.hpp"
#include "deadpoint/fem/conduction/enclosed_air.hpp"
#include "deadpoint/fem/conduction/heat_surfaces.hpp"
#include "deadpoint/fem/conduction/run_place.hpp"
#include "deadpoint/fem/elastic/expansion.hpp"
#include "deadpoint/fem/fields.hpp"
#include "deadpoint/fem/space/discretisation.hpp"
#include "deadpoint/fem/space/shell_matrix.hpp"

/// Internal to fem/: transient heat conduction with joint films.
namespace deadpoint::fem {

struct CheckpointPlan;  // checkpoint.hpp

class HeatSolver {
public:
    HeatSolver(const Discretisation& space, const std::vector<Material>& materials, const HeatProblem& problem);

    /// Takes another problem over if the matrices serve it as they are. Not after run().
    bool adopt(const HeatProblem& problem);
    void start_from(const ThermalState& state);
    [[nodiscard]] ThermalState state() const;  ///< where the run ended
    /// z of (M / time + K) z = weights per functional, with the films, joints and slopes of the heat laws at `time`.
    /// Changes the state.
    std::vector<Field> duals(double time, const Field& temperature, const std::vector<Adjoint>& weights);
    ThermalHistory run(const std::vector<Adjoint>& adjoints, double reference_temperature, Attribution attribution,
                       Observer& observer, const StepCallback& on_step, const FieldCallback& on_field,
                       const CheckpointPlan* checkpoints = nullptr);

private:
    friend class HeatAdjoint;     ///< which runs backward over the same steps
    friend class HeatCheckpoint;  ///< which stores and restores what is between two steps
    using Interface = HeatInterface;
    using Film = HeatFilm;
    struct Step {
        double error = 0, from_prescribed = 0;
    };

    void prepare_parts();
    void prepare_interfaces();
    void prepare_sources();
    void prepare_load_zone(std::size_t interface);
    void leave_prescribed_alone();
    /// Visits the integration points of a part's cells with their weights [m3].
    void for_each_point(int part, const std::function<void(const Vec3&, double, const PointShape&)>& visit) const;
    void prepare_body_heat();
    void prepare_films();
    void prepare_rooms();
    [[nodiscard]] std::vector<double> irradiation(const double* values) const;
    void build_room_loads(const double* values);
    void multiply_rooms(Vec in, Vec out) const;
    void prepare_prescribed();
    void prepare_materials();
    void prepare_tangents();
    void prepare_solver();
    void prepare_observers(const std::vector<Adjoint>& adjoints, double reference, Attribution attribution);
    void add_interface_pattern(dealii::DynamicSparsityPattern& pattern) const;
    void create_pattern();
    void create_matrices();
    void assemble();
    void choose_laws(const HeatSegment& segment);
    void enter_segment(const HeatSegment& segment);
    void begin_segment(const HeatSegment& segment, double time);
    void start_segment(RunPlace& place, ThermalHistory& history);
    void assemble_cells(Mat mass, Mat stiffness, Mat variable) const;
    void assemble_bonds(Mat stiffness, Mat variable) const;
    void assemble_interfaces(Mat stiffness) const;
    void assemble_films(Mat stiffness) const;
    void build_system(double factor, Vec temperature);
    using PointCoefficient = std::function<double(const FilmPoint&)>;
    /// Films with a coefficient by point [W/m2/K], into variable_.
    void assemble_variable_films(const std::function<PointCoefficient(const Film&)>& coefficient_on);
    /// Without a temperature: by the constants of materials that follow it.
    void combine_system(double factor, Vec temperature);
    void build_aggregates();
    static double longest_segment(const HeatProblem& problem);
    void fill_system(double factor, Mat films, Vec temperature);
    void note_multigrid(Vec temperature);
    [[nodiscard]] bool system_follows_temperature() const { return variable_films_ || materials_vary(); }
    /// Whether the system is M + factor K for every unknown.
    [[nodiscard]] bool system_is_linear() const { return !system_follows_temperature() && !some_prescribed_; }
    /// The rate without K T.
    [[nodiscard]] HeatRate gains(double time, Vec temperature) const;
    /// K T with what follows the temperature [W].
    void conduct(Vec temperature, Vec conducted) const;
    /// M T, or M h(T) [J].
    void store(Vec temperature, Vec stored) const;
    void clear_prescribed(Vec residual) const;
    void add_sources(HeatRate& rate, const std::vector<double>& mean) const;
    void add_interfaces(HeatRate& rate, const std::vector<double>& mean) const;
    void add_body_heat(HeatRate& rate, double time) const;
    [[nodiscard]] double ring_difference(const HeatSource& source, const std::vector<double>& mean) const;
    /// Lets the oil flow past the films of a rate; sets its circuits and returns where it reaches each interface [K].
    std::vector<double> follow_oil(HeatRate& rate, double time, double factor, const std::vector<double>& known) const;
    double oil_outlet(std::size_t circuit, double inlet, const HeatRate& rate, std::vector<double>& reaches) const;
    void settle_oil(double time);
    double set_oil(const std::vector<double>& temperature);
    [[nodiscard]] double oil_error(double dt) const;
    void add_variable_films(HeatRate& rate, double time, Vec temperature) const;
    void add_enclosures(HeatRate& rate, double time) const;
    void build_air_loads(double factor, const double* values);
    [[nodiscard]] bool materials_vary() const { return capacity_varies_ || conduction_varies_; }
    /// What the mass matrix acts on: the temperature, or the one of equal heat [K].
    [[nodiscard]] Vec heat_of(Vec temperature) const;
    void heat_change(Vec from, Vec to, Vec change) const;
    using MaterialMap = double (*)(const Material& material, double temperature);
    void add_tangent(Mat matrix, Mat of, Mat scaled, MaterialMap slope, Vec temperature) const;
    void add_conduction_tangent(Mat matrix, Vec temperature) const;
    void add_capacity(Mat matrix, Vec temperature) const;
    void note_extremes();
    void extremes_of_ranks(ThermalHistory& history) const;
    void impose(double time, Vec temperature) const;
    void stage_residual(double factor, Vec temperature, const HeatRate& gained);
    void finish_stage(double factor, Vec temperature, HeatRate& gained, Vec stored);
    HeatRate solve_stage(double time, double factor, const std::vector<double>& sump, Vec temperature, Vec stored);
    [[nodiscard]] std::vector<double> first_known_sump(double factor) const;
    [[nodiscard]] std::vector<double> second_known_sump() const;
    Step step(double time, double dt);
    void warn_of_many_steps(const RunPlace& place, Observer& observer) const;
    bool try_step(RunPlace& place, double end, ThermalHistory& history, const FieldCallback& on_field);
    void accept_step(double dt, const Step& outcome, ThermalHistory& history);
    static void hermite(Vec start, Vec start_slope, Vec end, Vec end_slope, double h, double s, Vec result);
    double estimate_error(double dt);
    void set_tolerance(double relative, double absolute);
    [[nodiscard]] double ambient(const SurfaceCondition& condition, double time) const;
    [[nodiscard]] ThermalHistory empty_history() const;
    static void fill_first_rates(ThermalHistory& history, std::size_t start);
    void record(ThermalHistory& history, double time, const HeatRate& rate);
    void record_media(ThermalHistory& history, const HeatRate& rate, double dt) const;
    [[nodiscard]] std::vector<double> observed(Vec vector, bool is_rate) const;
    void write_fields_until(double from, double dt, const FieldCallback& on_field);
    [[nodiscard]] std::vector<double> tangent_less_law(const HeatRate& before, const HeatRate& after) const;
    void correct_heat(HeatRate& rate, const std::vector<double>& corrections) const;
    [[nodiscard]] double source_change(std::size_t source, const HeatRate& before, const HeatRate& after) const;
    double prescribed_heat(double dt);
    [[nodiscard]] double rungs(double error, int least, int most) const;
    void add_energy(EnergyBalance& energy, double dt, double from_prescribed);
    static bool depends_on_temperature(const SurfaceCondition& c) { return !c.laws.empty() || c.emissivity > 0; }
    /// Convection of a surface in the present segment.
    [[nodiscard]] FilmLaw film_at(const SurfaceCondition& condition, double surroundings) const;
    static double film_flux(const LawValue& film, double emissivity, double surface, double surroundings);
    static double film_slope(const LawValue& film, double emissivity, double surface, double surroundings);
    void multiply(Vec in, Vec out) const;
    /// Solves with the system of the stage and counts iterations.
    void solve_system(Vec right, Vec solution, const char* what);
    /// The largest term of the heat balance of a stage of `factor`, in words.
    [[nodiscard]] std::string largest_term() const;

    const Discretisation& space_;
    const std::vector<Material>& materials_;
    Expansion expansion_;
    const HeatProblem* problem_;
    const HeatSegment* segment_ = nullptr;
    const std::vector<InterfaceLaw>* laws_ = nullptr;  ///< of the interfaces in this segment

    std::vector<Interface> interfaces_;
    std::vector<SparseFunctional> source_loads_;  ///< b_r: watts of unit heat by unknown
    std::vector<SparseFunctional> shell_loads_;   ///< the same without prescribed unknowns
    std::vector<double> source_constant_;         ///< part of the film temperature from the oil [K]
    std::vector<double> source_self_;             ///< film temperature per watt of the row itself [K/W]
    std::vector<double> source_to_oil_;           ///< share of a row's heat that goes straight to the oil
    std::vector<SparseFunctional> body_loads_;    ///< watts of unit heat by unknown
    std::vector<double> oil_temperature_;         ///< per interface [K]
    std::vector<double> sump_;                    ///< per circuit, at the start of the step [K]
    std::unique_ptr<EnclosedAir> air_;
    std::vector<Film> films_;
    std::vector<HeatRoom> rooms_;
    bool variable_films_ = false;
    bool some_prescribed_ = false;      ///< on any rank
    std::vector<PetscInt> prescribed_;  ///< owned unknowns with given temperature, global numbers
    std::vector<std::pair<Vec3, const SurfaceCondition*>> prescribed_at_;

    OwnedMat mass_, stiffness_, variable_, system_;
    std::unique_ptr<ShellMatrix> shell_;
    OwnedMat conduction_;  ///< of parts whose conductivity follows the temperature
    OwnedMat scaled_mass_, scaled_conduction_;
    OwnedVec mapped_;
    bool capacity_varies_ = false, conduction_varies_ = false;
    OwnedKsp solver_;
    mutable std::unique_ptr<Everywhere> everywhere_;
    double system_factor_ = -1;
    bool aggregates_built_ = false;  ///< of the multigrid, for the laws and the length of the segments
    CoarseMatrices coarse_;          ///< where the system does not follow the temperature
    double multigrid_factor_ = -1;   ///< for which the multigrid hierarchy was built
    MultigridOrigin multigrid_origin_;
    OwnedVec multigrid_temperature_;  ///< where the matrix follows it, with multigrid_origin_
    std::vector<double> shell_slopes_;

    OwnedVec before_, now_, middle_, next_, slope_before_, slope_now_, slope_middle_, slope_next_, work_, work2_,
        error_;
    OwnedVec stored_now_, stored_middle_, stored_next_, known_;  ///< M T, and what it is known to be in a stage [J]
    OwnedVec capacities_;                                        ///< M 1 [J/K]
    HeatRate rate_now_, rate_middle_, rate_next_;
    bool have_previous_ = false;  ///< the slope at the start of the step is known
    double previous_dt_ = 0;      ///< between slope_before_ and slope_now_; 0: unknown [s]
    double time_ = 0;             ///< of the stage being solved

    std::vector<SparseFunctional> probes_, part_means_;
    std::vector<double> part_volume_;  ///< [m3]
    std::vector<const SparseFunctional*> watched_;
    const std::vector<Adjoint>* adjoints_ = nullptr;
    double reference_ = 0;
    Attribution attribution_ = -1;
    std::vector<std::uint32_t> part_of_unknown_;
    std::vector<StepRecord> steps_;         ///< accepted
    OwnedVec start_;                        ///< temperature from which the run started
    std::vector<double> lowest_, highest_;  ///< nodal temperature so far, per part, on this rank [K]
    int iterations_ = 0;
    int solves_ = 0;
    std::size_t next_field_ = 0;
};

}  // namespace deadpoint::fem
