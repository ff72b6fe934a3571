#include "deadpoint/report/schema/keys.hpp"

namespace deadpoint::report::schema {
namespace {

Keys model_keys()
{
    return {{"cells", "", "number of cells of the mesh"},
            {"heat_unknowns", "", ""},
            {"deformation_cells", "",
             "number of cells of the deformation mesh, which may be a separate mesh; 0 without deformation"},
            {"deformation_unknowns", "", ""},
            {"element_order", "", "order of elements stated in the case, 1 or 2"},
            {"second_order_parts", "", "parts with elements of second order"},
            {"half_model", "", "true if half of the press is computed"},
            {"ranks", "", "processes"}};
}

Keys solution_keys()
{
    return {{"steps", "", "time steps"},
            {"rejected_steps", "", "steps that were repeated with a smaller size"},
            {"heat_solves", "", "linear systems of the heat"},
            {"heat_iterations", "", "iterations of the linear solver, in total"},
            {"deformation_iterations", "", "iterations of the linear solver, in total"}};
}

Keys energy_keys()
{
    return {{"generated", "J", "heat of joints and heat sources"},
            {"from_surfaces", "J", "heat from surfaces with prescribed temperature or flux"},
            {"to_air", "J", "heat to the air through all surfaces with convection"},
            {"to_oil", "J", "heat from the joints to the oil"},
            {"stored", "J", "heat stored in the parts and in enclosed air"},
            {"relative_mismatch", "",
             "mismatch of the balance divided by the heat that passed; null if there was no heat"}};
}

Keys flow_keys()
{
    return {{"sources_W/{source}", "W", "heat source"},
            {"bonds_W/{bond}", "W", "heat that crosses a bond with a conductance, from its first part to the second"},
            {"oil/{circuit}/inlet_degC", "degC", "temperature of the oil at the first joint"},
            {"oil/{circuit}/outlet_degC", "degC", "temperature of the oil after the last joint"},
            {"oil/{circuit}/sump_degC", "degC", "temperature of the oil in the sump"},
            {"oil/{circuit}/heat_W", "W", "heat that the oil takes up"},
            {"oil/{circuit}/cooler_W", "W", "heat that the cooler removes; below zero a heater adds it"},
            {"enclosures/{enclosure}/temperature_degC", "degC", "temperature of the enclosed air"},
            {"enclosures/{enclosure}/from_surfaces_W", "W", "heat from its surfaces to the air"},
            {"enclosures/{enclosure}/power_W", "W", "heat generated in the enclosure"},
            {"enclosures/{enclosure}/to_room_W", "W", "heat from the air to the room"}};
}

Keys drift_keys()
{
    return {
        {"largest_E_SW", "um", "change of the gap that is largest in magnitude; above zero it opens"},
        {"time_of_largest_s", "s", "time of that value"},
        {"final_E_SW", "um", "change of the gap at the end"},
        {"final/{dimension}", "um", "change of each dimension of the chain at the end"},
        {"final_by_part/{part}", "um", "contribution of each part's warming to E_SW, at the end"},
        {"by_cause/[]/time_s", "s", "time of this list; there is one for the largest change and one for the end"},
        {"by_cause/[]/E_SW", "um", "change of the gap at that time, the sum of all contributions below"},
        {"by_cause/[]/fields", "", "number of fields on which they were computed; 0: in all unknowns"},
        {"by_cause/[]/change", "um",
         "largest change of a contribution by the last two or four of these fields: how far one may be off"},
        {"by_cause/[]/friction/{joint}", "um", "contribution of the joint's friction heat"},
        {"by_cause/[]/heat source/{source}", "um", "contribution of the heat source"},
        {"by_cause/[]/surface/{surface}", "um", "contribution of a prescribed temperature or flux"},
        {"by_cause/[]/oil", "um", "contribution of oil that is warmer or colder than the machine at the start"},
        {"by_cause/[]/air", "um", "contribution of an ambient that is warmer or colder than the machine at the start"},
        {"by_cause/[]/start", "um", "contribution of the temperatures of --from"},
        {"by_cause/[]/remainder", "um",
         "remainder, from coefficients that depend on temperature and from the fields that are left out"}};
}

/// Largest and last value of a course.
Keys extreme_keys(const std::string& at, const std::string& ending, const std::string& unit, const std::string& of)
{
    return below(at, {{"largest_" + ending, unit, of + ", largest in magnitude"},
                      {"time_of_largest_s", "s", "time of that value"},
                      {"final_" + ending, unit, of + ", at the end"}});
}

Keys static_keys()
{
    return {{"terms", "", "what is in it and what is left out, in words"},
            {"opening_um_per_kN", "um/kN", "opening of the gap under a force on the middle of the slide"},
            {"stiffness_kN_per_mm", "kN/mm", "its inverse: of the solid parts in series"},
            {"corners_um_per_kN/{corner}", "um/kN", "opening at this corner of the slide under the same force"},
            {"left_to_right_um_per_m_per_kN", "um/m/kN", "slope, above zero opens to the right"},
            {"front_to_back_um_per_m_per_kN", "um/m/kN", "slope, above zero opens to the back"},
            {"segments/[]/name", "", "segment of the operation"},
            {"segments/[]/force_N", "N", "peak of its process force"},
            {"segments/[]/opening_um", "um", "opening of the gap at that force"}};
}

Keys gap_keys()
{
    const std::string corner = "parallelism/corners/{corner}";
    return joined({
        {{"parallelism/terms", "", "meaning of positive signs, in words"},
         {"parallelism/directions", "", "where front and left are, as \"front is z > 0, left is x < 0\""}},
        extreme_keys(corner, "um", "um", "change of the gap at this corner of the slide"),
        {{corner + "/x_mm", "mm", "position of the corner"}, {corner + "/z_mm", "mm", "position of the corner"}},
        extreme_keys("parallelism/left_to_right", "um_per_m", "um/m", "slope, above zero opens to the right"),
        extreme_keys("parallelism/front_to_back", "um_per_m", "um/m", "slope, above zero opens to the back"),
        {{"clearance_terms", "", "meaning of positive signs, in words"},
         {"clearances/[]/name", "", "joint, with the bearing if it has several"},
         {"clearances/[]/kind", "", "guide or bearing"},
         {"clearances/[]/final_change_um", "um", "change at the end; below zero it closes"},
         {"clearances/[]/least_change_um", "um", "smallest change"},
         {"clearances/[]/time_of_least_s", "s", "time of that value"},
         {"clearances/[]/initial_um", "um", "clearance at the start, if the case states it"},
         {"clearances/[]/least_um", "um", "smallest clearance"},
         {"clearances/[]/final_um", "um", "clearance at the end"},
         {"clearances/[]/used_up_s", "s", "time at which it first reaches zero; null: never"},
         {"left_out", "", "joints whose clearance cannot be computed, with the reason"}},
        extreme_keys("force", "kN", "kN", "change of the force at a fixed die height"),
        {{"force/press_stiffness_N_per_m", "N/m", "stiffness used for it"}},
    });
}

/// Change over a first stretch, and over the run, in the style of ISO 230-3.
Keys course_keys(const std::string& at, const std::string& unit)
{
    Keys keys;
    for (const std::string stretch : {"first_hour", "four_hours"}) {
        keys = joined({keys, below(stretch, {{"change_" + unit, unit, "change from the start to the end of this span"},
                                             {"range_" + unit, unit, "largest less smallest value"},
                                             {"span_s", "s", "length of the span"},
                                             {"run_was_shorter", "", "true if the run ended earlier"}})});
    }
    return below(at, joined({keys,
                             {{"range_" + unit, unit, "largest less smallest value of the run"},
                              {"largest_rate_" + unit + "_per_h", unit + "/h", "fastest change"},
                              {"largest_rate_from_s", "s", "begin of that window"},
                              {"rate_window_s", "s", "length of the window for rates"}}}));
}

Keys course_summary_keys()
{
    return joined({{{"terms", "", "correspondence of the figures to ISO 230-3, in words"}},
                   course_keys("E_SW", "um"),
                   {{"E_SW/steady_from_s", "s", "as warm_up_s"}},
                   course_keys("probes/{probe}", "K"),
                   {{"probes/{probe}/within_5_percent_of_end_from_s", "s", "as time_to_95_percent_s"}}});
}

Keys accuracy_keys()
{
    return {{"of", "", "E_SW or probe_rises"},
            {"unit", "", "unit of all figures here whose name has none"},
            {"wanted", "{unit}", "the requested accuracy"},
            {"reached", "", "true if it was reached"},
            {"why_not", "", "reason why the refinement ended earlier"},
            {"meshes/[]/cells", "", "number of cells of the mesh"},
            {"meshes/[]/finer_parts", "", "parts that were meshed again for it"},
            {"meshes/[]/value", "{unit}", "E_SW at the end, or the largest rise of a probe"},
            {"meshes/[]/change", "{unit}", "largest change from the previous mesh, at any time of the run"},
            {"meshes/[]/estimate", "{unit}", "estimated error of this mesh"},
            {"meshes/[]/worst_part", "", "part with the largest share of the estimate"},
            {"meshes/[]/seconds", "s", "computing time"},
            {"time_steps/time_tolerance_K", "K", "tolerance of the time steps"},
            {"time_steps/max_step_s", "s", "largest step allowed"},
            {"time_steps/change_by_halving", "{unit}", "change of the figure by halved time steps"},
            {"time_steps/seconds", "s", "computing time of this comparison"},
            {"parts/{part}/size_mm", "mm", "cell size at the end"},
            {"parts/{part}/first_size_mm", "mm", "cell size at the start"},
            {"parts/{part}/cells", "", "cells of the part at the end"},
            {"parts/{part}/estimate", "{unit}", "share of the part in the estimate"},
            {"seconds", "s", "total computing time"}};
}

Keys reduced_keys()
{
    const auto error = [](const std::string& path, const std::string& meaning, const std::string& play = "") -> Keys {
        return {{path + "/of", "", meaning},
                {path + "/temperature_K", "K", "largest, of probes and sides of joints, after the first minute"},
                {path + "/E_SW_um", "um", "largest of E_SW" + play + ", after the first minute"}};
    };
    return joined(
        {{{"model", "", "file of the reduced model"}, {"states", "", "number of its states"}},
         error("estimate", "what it compares: the large model and this run"),
         error("full_run", "what it compares: a full run and this run, by run --full-run"),
         {{"certified/E_SW_um", "um", "bound of the difference to the full model at the end of the run"},
          {"certified/probes_K/{probe}", "K", "the same of a probe"},
          {"certified/refused", "", "why there is no bound"}},
         error("errors/[]", "what it compares, when the model was built", " without the play of the bearings"),
         {{"outside", "", "coefficients outside the range of the model, each with its value and range"}}});
}

Keys sensitivity_keys()
{
    return {{"time_s", "s", "time to which they refer, the end of the run"},
            {"strongest/[]/coefficient", "", "as in sensitivities.csv; the ten with the largest effect on E_SW"},
            {"strongest/[]/value", "{unit}", "its value in the first segment; 1 for a factor on several values"},
            {"strongest/[]/unit", "", "unit of the value; empty: a factor"},
            {"strongest/[]/change", "{unit}", "a tenth of the value; 1 K for temperatures"},
            {"strongest/[]/E_SW_um", "um", "effect of this change on E_SW, by the derivative"},
            {"strongest/[]/largest_probe_K", "K", "the same on the probe that changes most"}};
}

Keys frame_keys()
{
    return {{"support_force_kN", "kN", "upward force on the feet, if weights act"},
            {"rods/{part}/preload", "", "name of the preload in the case"},
            {"rods/{part}/start_kN", "kN", "force at the start"},
            {"rods/{part}/change_at_end_kN", "kN", "change of the force at the end"},
            {"rods/{part}/change_at_end_percent", "%", "the same as a percentage of the force at the start"},
            {"rods/{part}/least_kN", "kN", "smallest force"},
            {"rods/{part}/time_of_least_s", "s", "time of that value"},
            {"closed/{bond}/preload", "", "name of the preload in the case"},
            {"closed/{bond}/start_kN", "kN", "force across the bond at the start, tension above zero"},
            {"closed/{bond}/change_at_end_kN", "kN", "change of the force at the end"},
            {"closed/{bond}/openings/[]/time_s", "s", "time of this entry, one for each field file"},
            {"closed/{bond}/openings/[]/largest_tension_MPa", "MPa", "largest tension across the bond"},
            {"closed/{bond}/openings/[]/place_mm", "mm", "x, y, z of that place"},
            {"closed/{bond}/openings/[]/share_under_tension", "", "share of the area under tension"},
            {"stress/[]/part", "", "part of this entry"},
            {"stress/[]/time_s", "s", "time of this entry"},
            {"stress/[]/von_mises_MPa", "MPa", "largest equivalent stress"},
            {"stress/[]/place_mm", "mm", "x, y, z of that place"},
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
            {"rms_null_K", "K", "the same for a prediction of no rise"},
            {"calibrated_on", "", "keys of the case that were fitted to these values"}};
}

}  // namespace

Keys friction_keys(const std::string& at)
{
    const std::string row = "rows/{friction law}";
    return below(
        at, {{"speed_rpm", "rpm", "crank speed of this operating point"},
             {"force_N", "N", "peak of its process force"},
             {row + "/law", "", "kind of the friction law"},
             {row + "/joints", "", "joints with this friction law"},
             {row + "/{temperature}/heat_W", "W", "friction heat of all these joints at 20 and at 40 degC"},
             {row + "/{temperature}/viscous_part_W", "W", "part of it that depends on the viscosity"},
             {row + "/load_part_W", "W", "part of it that depends on the load"},
             {row + "/load_duty_over_reference", "", "load duty divided by the duty at the reference of the case"},
             {"load_part_rigid_over_flexible/{bearing}/by_mean", "", "ratio of load duties from mean(F^1.33)"},
             {"load_part_rigid_over_flexible/{bearing}/by_peak", "", "the same from max(F)^1.33"},
             {"same_process_force", "", "true if both shaft models have the same process force"},
             {"power_W/drive_mean", "W", "mean power of the drive without friction"},
             {"power_W/process_mean", "W", "mean power into the process"},
             {"power_W/drive_less_process", "W", "their difference, 0 except for rounding"},
             {"power_W/drive_mean_magnitude", "W", "mean of the magnitude of the drive's power"},
             {"power_W/mismatch", "", "difference divided by that magnitude"},
             {"power_W/mismatch_allowed", "", "limit above which the program warns"},
             {"power_W/motor_stated", "W", "rated power in the case"},
             {"power_W/with_friction/{temperature}/friction", "W", "friction with all joints at 20 and 40 degC"},
             {"power_W/with_friction/{temperature}/motor", "W", "power of the motor with process and friction"},
             {"power_W/with_friction/{temperature}/crank_torque_N_m", "N m", "torque of the friction at the crank"},
             {"power_W/with_friction/{temperature}/share_of_motor", "", "motor power divided by its rated power"}});
}

Keys summary_keys()
{
    return joined(
        {head_keys(),
         {{"interrupted", "", "true if the run was stopped before its end"},
          {"initial_temperature_degC", "degC", "temperature from which rises count"},
          {"warnings", "", "all warnings of the run"}},
         below("model", model_keys()),
         below("solution", solution_keys()),
         {{"timings_s/{stage}", "s", "wall time of each stage"},
          {"peak_memory_bytes", "byte", "peak memory of all processes together"}},
         below("accuracy", accuracy_keys()),
         below("reduced", reduced_keys()),
         below("sensitivities", sensitivity_keys()),
         below("energy_J", energy_keys()),
         below("heat_flows_at_end", flow_keys()),
         {{"probe_rises_K/{probe}/{time}", "K", "rise after 0.5 h, 1 h, 2 h, 3 h and at the end"},
          {"time_to_95_percent_s/{probe}", "s",
           "time from which the probe stays near its value at the end, within 5 % of its change over the run"}},
         below("drift_um", drift_keys()),
         below("gaps", gap_keys()),
         below("static_opening", static_keys()),
         {{"warm_up_s", "s", "time from which the gap drifts by less than chain.drift_rate_limit; null: not reached"}},
         below("drift_summary", course_summary_keys()),
         friction_keys("friction/[]"),
         below("frame", frame_keys()),
         {{"adjoint_check/time_s", "s", "time of the last field"},
          {"adjoint_check/E_SW_um_by_adjoint", "um", "value from adjoints, as in all results"},
          {"adjoint_check/E_SW_um_by_deformation", "um", "value from the deformation at that time"},
          {"adjoint_check/largest_joint_opening_um", "um",
           "distance of the two centres of a joint, 0 except for rounding"}},
         below("reference", reference_keys()),
         {{"left_out", "", "effects that the model leaves out"}}});
}

}  // namespace deadpoint::report::schema
