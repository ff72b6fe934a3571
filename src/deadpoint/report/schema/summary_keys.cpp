#include "deadpoint/report/schema/keys.hpp"

namespace deadpoint::report::schema {
namespace {

Keys model_keys()
{
    return {{"cells", "", "of the mesh"},
            {"heat_unknowns", "", ""},
            {"deformation_cells", "", "of the mesh of the deformation, which may be another; 0 without"},
            {"deformation_unknowns", "", ""},
            {"element_order", "", "that the case asks for, 1 or 2"},
            {"second_order_parts", "", "parts with elements of second order"},
            {"half_model", "", "whether half of the press is computed"},
            {"ranks", "", "processes"}};
}

Keys solution_keys()
{
    return {{"steps", "", "time steps"},
            {"rejected_steps", "", "that were repeated with a smaller step"},
            {"heat_solves", "", "linear systems of the heat"},
            {"heat_iterations", "", "of the linear solver, all together"},
            {"deformation_iterations", "", "of the linear solver, all together"}};
}

Keys energy_keys()
{
    return {{"generated", "J", "heat of joints and heat sources"},
            {"from_surfaces", "J", "from surfaces of prescribed temperature or flux"},
            {"to_air", "J", "through all surfaces with convection"},
            {"to_oil", "J", "from the joints to the oil"},
            {"stored", "J", "in the parts"},
            {"relative_mismatch", "", "of the balance, over the heat that passed; null where nothing happens"}};
}

Keys flow_keys()
{
    return {{"sources_W/{source}", "W", "heat source"},
            {"oil/{circuit}/inlet_degC", "degC", "oil at the first joint"},
            {"oil/{circuit}/outlet_degC", "degC", "oil behind the last joint"},
            {"oil/{circuit}/sump_degC", "degC", "oil in the sump"},
            {"oil/{circuit}/heat_W", "W", "what the oil takes"},
            {"oil/{circuit}/cooler_W", "W", "what the cooler takes; below zero a heater gives it"},
            {"enclosures/{enclosure}/temperature_degC", "degC", "enclosed air"},
            {"enclosures/{enclosure}/from_surfaces_W", "W", "from the surfaces around the air"},
            {"enclosures/{enclosure}/power_W", "W", "made in the enclosure itself"},
            {"enclosures/{enclosure}/to_room_W", "W", "to the room"}};
}

Keys drift_keys()
{
    return {{"largest_E_SW", "um", "change of the gap that is largest in magnitude; above zero it opens"},
            {"time_of_largest_s", "s", "when that is"},
            {"final_E_SW", "um", "change of the gap at the end"},
            {"final/{dimension}", "um", "change of each dimension of the chain at the end"},
            {"final_by_part/{part}", "um", "share of E_SW that the warming of each part makes, at the end"},
            {"by_cause/[]/time_s", "s", "time of this list: the largest change, and the end"},
            {"by_cause/[]/E_SW", "um", "change of the gap then, the sum of all below"},
            {"by_cause/[]/friction/{joint}", "um", "share of the joint's friction heat"},
            {"by_cause/[]/heat source/{source}", "um", "share of the heat source"},
            {"by_cause/[]/surface/{surface}", "um", "share of a prescribed temperature or flux"},
            {"by_cause/[]/oil", "um", "share of oil warmer or colder than the start"},
            {"by_cause/[]/air", "um", "share of an ambient warmer or colder than the start"},
            {"by_cause/[]/start", "um", "share of the temperatures of --from"},
            {"by_cause/[]/remainder", "um", "what convection that follows the temperature leaves over"}};
}

/// Largest and last value of a course.
Keys extreme_keys(const std::string& at, const std::string& ending, const std::string& unit, const std::string& of)
{
    return below(at, {{"largest_" + ending, unit, of + ", largest in magnitude"},
                      {"time_of_largest_s", "s", "when that is"},
                      {"final_" + ending, unit, of + ", at the end"}});
}

Keys gap_keys()
{
    const std::string corner = "parallelism/corners/{corner}";
    return joined({
        {{"parallelism/terms", "", "what is positive, in words"}},
        extreme_keys(corner, "um", "um", "change of the gap at this corner of the slide"),
        {{corner + "/x_mm", "mm", "place of the corner"}, {corner + "/z_mm", "mm", "place of the corner"}},
        extreme_keys("parallelism/left_to_right", "um_per_m", "um/m", "slope, above zero opens to the right"),
        extreme_keys("parallelism/front_to_back", "um_per_m", "um/m", "slope, above zero opens to the back"),
        {{"clearance_terms", "", "what is positive, in words"},
         {"clearances/[]/name", "", "joint, with the bearing where it has several"},
         {"clearances/[]/kind", "", "guide or bearing"},
         {"clearances/[]/final_change_um", "um", "change at the end; below zero it closes"},
         {"clearances/[]/least_change_um", "um", "smallest change"},
         {"clearances/[]/time_of_least_s", "s", "when that is"},
         {"clearances/[]/initial_um", "um", "at the start, where the case states it"},
         {"clearances/[]/least_um", "um", "smallest clearance"},
         {"clearances/[]/final_um", "um", "clearance at the end"},
         {"clearances/[]/used_up_s", "s", "when it first reaches zero; null: never"},
         {"left_out", "", "joints whose clearance cannot be followed, with the reason"}},
        extreme_keys("force", "kN", "kN", "change of the force at a fixed die height"),
        {{"force/press_stiffness_N_per_m", "N/m", "with which it is computed"}},
    });
}

/// Change over a first stretch, and over the run, in the style of ISO 230-3.
Keys course_keys(const std::string& at, const std::string& unit)
{
    Keys keys;
    for (const std::string stretch : {"first_hour", "four_hours"}) {
        keys = joined({keys, below(stretch, {{"change_" + unit, unit, "from the start to its end"},
                                             {"range_" + unit, unit, "largest less smallest value"},
                                             {"span_s", "s", "its length"},
                                             {"run_was_shorter", "", "whether the run ended before"}})});
    }
    return below(at, joined({keys,
                             {{"range_" + unit, unit, "largest less smallest value of the run"},
                              {"largest_rate_" + unit + "_per_h", unit + "/h", "fastest change"},
                              {"largest_rate_from_s", "s", "when that begins"},
                              {"rate_window_s", "s", "time over which rates are taken"}}}));
}

Keys course_summary_keys()
{
    return joined({{{"terms", "", "how the figures correspond to ISO 230-3, in words"}},
                   course_keys("E_SW", "um"),
                   {{"E_SW/steady_from_s", "s", "as warm_up_s"}},
                   course_keys("probes/{probe}", "K"),
                   {{"probes/{probe}/within_5_percent_of_end_from_s", "s", "as time_to_95_percent_s"}}});
}

Keys accuracy_keys()
{
    return {{"of", "", "E_SW or probe_rises"},
            {"unit", "", "of all figures here without one in their name"},
            {"wanted", "{unit}", "the accuracy asked for"},
            {"reached", "", "whether it was reached"},
            {"why_not", "", "what ended the refinement before"},
            {"meshes/[]/cells", "", "of the mesh"},
            {"meshes/[]/finer_parts", "", "parts meshed anew for it"},
            {"meshes/[]/value", "{unit}", "E_SW at the end, or the largest rise of a probe"},
            {"meshes/[]/change", "{unit}", "from the mesh before, at any time of the run"},
            {"meshes/[]/estimate", "{unit}", "of the error of this mesh"},
            {"meshes/[]/worst_part", "", "part with the largest share of the estimate"},
            {"meshes/[]/seconds", "s", "computing time"},
            {"time_steps/time_tolerance_K", "K", "with which the time steps were chosen"},
            {"time_steps/max_step_s", "s", "largest step allowed"},
            {"time_steps/change_by_halving", "{unit}", "of the figure by steps half as long"},
            {"time_steps/seconds", "s", "computing time of that"},
            {"parts/{part}/size_mm", "mm", "cell size at the end"},
            {"parts/{part}/first_size_mm", "mm", "cell size at the start"},
            {"parts/{part}/cells", "", "of the part at the end"},
            {"parts/{part}/estimate", "{unit}", "share of the part in the estimate"},
            {"seconds", "s", "computing time of all"}};
}

Keys frame_keys()
{
    return {{"support_force_kN", "kN", "on the feet, upwards, where weights act"},
            {"rods/{part}/preload", "", "name of the preload in the case"},
            {"rods/{part}/start_kN", "kN", "force at the start"},
            {"rods/{part}/change_at_end_kN", "kN", "change of the force at the end"},
            {"rods/{part}/change_at_end_percent", "%", "the same over the force at the start"},
            {"rods/{part}/least_kN", "kN", "smallest force"},
            {"rods/{part}/time_of_least_s", "s", "when that is"},
            {"closed/{bond}/preload", "", "name of the preload in the case"},
            {"closed/{bond}/start_kN", "kN", "force across the bond at the start, tension above zero"},
            {"closed/{bond}/change_at_end_kN", "kN", "change of the force at the end"},
            {"closed/{bond}/openings/[]/time_s", "s", "time of this entry, one for each field file"},
            {"closed/{bond}/openings/[]/largest_tension_MPa", "MPa", "largest tension across the bond"},
            {"closed/{bond}/openings/[]/place_mm", "mm", "x, y, z of it"},
            {"closed/{bond}/openings/[]/share_under_tension", "", "share of the area under tension"},
            {"stress/[]/part", "", "part of this entry"},
            {"stress/[]/time_s", "s", "time of this entry"},
            {"stress/[]/von_mises_MPa", "MPa", "largest equivalent stress"},
            {"stress/[]/place_mm", "mm", "x, y, z of it"},
            {"stress/[]/principal_there_MPa", "MPa", "three principal stresses there, largest first"},
            {"stress/[]/highest_principal_MPa", "MPa", "of the whole part"},
            {"stress/[]/lowest_principal_MPa", "MPa", "of the whole part"}};
}

Keys reference_keys()
{
    return {{"rises_K/{probe}/computed", "K", "rise at the time of the reference"},
            {"rises_K/{probe}/reference", "K", "published or measured rise"},
            {"time_s", "s", "time of the reference"},
            {"source", "", "where the values are from"},
            {"rms_residual_K", "K", "root mean square of the differences"},
            {"rms_null_K", "K", "the same if no rise at all were predicted"},
            {"calibrated_on", "", "keys of the case that were fitted to these values"}};
}

}  // namespace

Keys friction_keys(const std::string& at)
{
    const std::string row = "rows/{friction law}";
    return below(at,
                 {{"speed_rpm", "rpm", "crank speed of this operating point"},
                  {"force_N", "N", "peak of its process force"},
                  {row + "/law", "", "kind of the friction law"},
                  {row + "/joints", "", "joints with this friction law"},
                  {row + "/{temperature}/heat_W", "W", "friction heat of all these joints at 20 and at 40 degC"},
                  {row + "/{temperature}/viscous_part_W", "W", "what depends on the viscosity of it"},
                  {row + "/load_part_W", "W", "what depends on the load of it"},
                  {row + "/load_duty_over_reference", "", "load duty over that at the reference of the case"},
                  {"load_part_rigid_over_flexible/{bearing}/by_mean", "", "ratio of load duties by mean(F^1.33)"},
                  {"load_part_rigid_over_flexible/{bearing}/by_peak", "", "the same by max(F)^1.33"},
                  {"same_process_force", "", "whether both shafts see the same process force"},
                  {"power_W/drive_mean", "W", "mean power of the drive without friction"},
                  {"power_W/process_mean", "W", "mean power into the process"},
                  {"power_W/drive_less_process", "W", "their difference, 0 but for rounding"},
                  {"power_W/drive_mean_magnitude", "W", "mean of the magnitude of the drive's power"},
                  {"power_W/mismatch", "", "difference over that magnitude"},
                  {"power_W/mismatch_allowed", "", "beyond it the program warns"},
                  {"power_W/motor_stated", "W", "rated power in the case"},
                  {"power_W/with_friction/{temperature}/friction", "W", "friction with all joints at 20 and 40 degC"},
                  {"power_W/with_friction/{temperature}/motor", "W", "power of the motor with process and friction"},
                  {"power_W/with_friction/{temperature}/crank_torque_N_m", "N m", "of the friction at the crank"},
                  {"power_W/with_friction/{temperature}/share_of_motor", "", "motor power over its rating"}});
}

Keys summary_keys()
{
    return joined(
        {head_keys(),
         {{"interrupted", "", "whether the run was stopped before its end"},
          {"initial_temperature_degC", "degC", "from which rises count"},
          {"warnings", "", "of the whole run"}},
         below("model", model_keys()),
         below("solution", solution_keys()),
         {{"timings_s/{stage}", "s", "wall time of each stage"},
          {"peak_memory_bytes", "byte", "of all processes together"}},
         below("accuracy", accuracy_keys()),
         below("energy_J", energy_keys()),
         below("heat_flows_at_end", flow_keys()),
         {{"probe_rises_K/{probe}/{time}", "K", "rise after 0.5 h, 1 h, 2 h, 3 h and at the end"},
          {"time_to_95_percent_s/{probe}", "s", "from then on within 5 % of the rise at the end"}},
         below("drift_um", drift_keys()),
         below("gaps", gap_keys()),
         {{"warm_up_s", "s", "from then on the gap drifts by less than chain.drift_rate_limit; null: not yet"}},
         below("drift_summary", course_summary_keys()),
         friction_keys("friction/[]"),
         below("frame", frame_keys()),
         {{"adjoint_check/time_s", "s", "of the last field"},
          {"adjoint_check/E_SW_um_by_adjoint", "um", "as in all results"},
          {"adjoint_check/E_SW_um_by_deformation", "um", "from the deformation solved then"},
          {"adjoint_check/largest_joint_opening_um", "um", "distance of two centres of a joint, 0 but for rounding"}},
         below("reference", reference_keys()),
         {{"left_out", "", "what the model does not contain"}}});
}

}  // namespace deadpoint::report::schema
