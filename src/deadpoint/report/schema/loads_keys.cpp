#include "deadpoint/report/schema/keys.hpp"

namespace deadpoint::report::schema {
namespace {

Keys bearing_keys()
{
    return {{"peak_N", "N", "largest force"},
            {"peak_x_N", "N", "largest magnitude along x, either way"},
            {"peak_y_N", "N", "largest magnitude up or down"},
            {"mean_N", "N", "mean force, x and y"},
            {"mean_magnitude_N", "N", "mean of the magnitude"},
            {"rms_N", "N", "root mean square"},
            {"mean_F_to_1.33_N1.33", "N^1.33", "mean of F^1.33, to which rolling friction is proportional"}};
}

Keys crankshaft_keys()
{
    const auto model = [](const std::string& name) {
        return joined(
            {below(name + "/bearings/{bearing}", bearing_keys()), below(name + "/seats/{seat}", bearing_keys())});
    };
    return joined({{{"model", "", "rigid or flexible, as the case asks"},
                    {"modal_damping", "", "share of critical damping"},
                    {"belt_force_N", "N", "force of the belt on the shaft"}},
                   model("rigid"),
                   model("flexible"),
                   {{"flexible/stiffness_over_given", "", "used stiffness of each bearing divided by that of the case"},
                    {"static/bearing_force_N/{bearing}", "N", "at rest, x and y"},
                    {"static/largest_deflection_um", "um", "largest deflection of the shaft at rest"},
                    {"static/position_mm", "mm", "position along the shaft"},
                    {"static/deflection_um", "um", "deflection at that position, x and y"},
                    {"modes_at_speed/[]/frequency_Hz", "Hz", "natural frequency at the operating speed"},
                    {"modes_at_speed/[]/whirl", "", "forward or backward"},
                    {"modes_at_speed/[]/damping_ratio_of_bearings", "", "damping ratio of the mode by the bearings"},
                    {"critical_speeds/[]/speed_rpm", "rpm", "speed that excites a natural frequency by unbalance"},
                    {"critical_speeds/[]/whirl", "", "forward or backward"},
                    {"unbalance_response_at_speed/largest_deflection_um", "um", "amplitude of the shaft"},
                    {"unbalance_response_at_speed/bearing_force_amplitude_N/{bearing}", "N", "x and y"}}});
}

Keys slide_keys()
{
    return {
        {"stroke_mm", "mm", ""},
        {"bottom_dead_point_deg", "deg", "crank angle from the drawn position"},
        {"crank_angle_at_bottom_dead_point_deg", "deg", "angle of the throw, counter-clockwise from the x axis"},
        {"top_dead_point_deg", "deg", "crank angle from the drawn position"},
        {"dwell_within_10_um_share_of_turn", "", "share of the turn with the slide within 10 um of bottom dead point"},
        {"dwell_within_100_um_share_of_turn", "", "the same for 100 um"},
        {"largest_speed_m_per_s", "m/s", "of the slide"},
        {"largest_acceleration_m_per_s2", "m/s2", "of the slide"}};
}

Keys joint_keys()
{
    return {{"kind", "", "revolute or slide"},
            {"body_a", "", "body on which the force acts"},
            {"body_b", "", "body that exerts the force"},
            {"image", "", "true if the joint is the image of another across the plane of symmetry"},
            {"force_N/peak", "N", "largest magnitude over the turn"},
            {"force_N/mean", "N", "mean of the magnitude"},
            {"force_N/rms", "N", "root mean square"},
            {"force_N/peak_x", "N", "largest magnitude along x, either way"},
            {"force_N/peak_y", "N", "largest magnitude up or down"},
            {"force_N/at_bottom_x", "N", "at bottom dead point, along x"},
            {"force_N/at_bottom_y", "N", "at bottom dead point, upwards"},
            {"peak_moment_N_m", "N m", "of a guide"},
            {"mean_sliding_speed_m_per_s", "m/s", "of a guide"},
            {"mean_sliding_speed_rad_per_s", "rad/s", "of a pin"},
            {"mean_force_times_speed_W", "W", "for a guide: mean of force times sliding speed"},
            {"mean_force_times_speed_N_rad_per_s", "N rad/s", "for a pin: mean of force times rotational speed"}};
}

}  // namespace

Keys loads_keys()
{
    return joined(
        {head_keys(),
         {{"warnings", "", ""},
          {"conventions", "", "directions and signs, in words"},
          {"operation/segment", "", "segment of the operation, from 0"},
          {"operation/speed_rpm", "rpm", "speed of the crank at bottom dead point"},
          {"operation/mean_speed_rpm", "rpm", "mean over the turn"},
          {"operation/process_force_kind", "", "as the case states it"},
          {"operation/process_force_peak_N", "N", "largest process force"}},
         below("slide", slide_keys()),
         {{"mechanical_advantage/[]/past_bottom_dead_point_deg", "deg", "crank angle of this entry"},
          {"mechanical_advantage/[]/height_mm", "mm", "height of the slide above bottom dead point"},
          {"mechanical_advantage/[]/slide_force_over_pin_force", "",
           "force of the slide divided by the force at the crank pin"},
          {"mechanical_advantage/[]/slide_force_over_torque_1_per_m", "1/m",
           "force of the slide divided by the crank torque"},
          {"drive/peak_torque_N_m", "N m", "torque of the drive on the crank"},
          {"drive/mean_torque_N_m", "N m", ""},
          {"drive/rms_torque_N_m", "N m", ""},
          {"drive/mean_power_W", "W", "without friction"},
          {"bodies/{body}/mass_kg", "kg", ""},
          {"bodies/{body}/centre_of_mass_m", "m", "x and y at the drawn position"},
          {"bodies/{body}/inertia_kg_m2", "kg m2", "about the centre of mass"},
          {"bodies/{body}/from", "", "source of these values: parts or case"}},
         below("joints/{joint}", joint_keys()),
         {{"guides/{joint}/preload_per_face_N", "N", "of the gib"},
          {"guides/{joint}/mean_normal_force_N", "N", "on both faces together"},
          {"guides/{joint}/peak_moment_N_m", "N m", ""},
          {"guides/{joint}/balanced_by_symmetry", "", "true if the other half takes the force"},
          {"guides/{joint}/guide_length_mm", "mm", "length over which the moment is carried"},
          {"guides_whose_rotation_the_halves_hold", "",
           "guides whose body is already held against rotation by both halves"},
          {"height_by_length/[]/body", "", ""},
          {"height_by_length/[]/from", "", "joint that stays in place"},
          {"height_by_length/[]/to", "", "joint that moves away from the other"},
          {"height_by_length/[]/length_mm", "mm", "distance of the two"},
          {"height_by_length/[]/slide_height_by_length", "", "motion of the slide per growth of that length"}},
         below("crankshaft", crankshaft_keys()),
         {{"timings_s/{stage}", "s", "wall time of each stage"}}});
}

Keys heat_keys()
{
    const auto values = [](const std::string& at) -> Keys {
        return below("films/{surface}/" + at + "/[]",
                     {{"rise_K", "K", "rise of the surface above the ambient"},
                      {"speed", "rad/s or m/s", "speed of a rotating or moving surface"},
                      {"convection_W_per_m2_K", "W/m2/K", "convection coefficient"},
                      {"radiation_W_per_m2_K", "W/m2/K", "the same for radiation"},
                      {"in_range", "", "false: outside the range in which the law was tested"}});
    };
    return joined(
        {head_keys(),
         {{"warnings", "", ""},
          {"conventions", "", "conventions for heat and areas, in words"},
          {"operation/segment", "", "segment of the operation, from 0"},
          {"operation/speed_rpm", "rpm", "of the crank"},
          {"friction/{friction law}/law", "", "kind of the friction law"},
          {"friction/{friction law}/lubricant", "", ""},
          {"friction/{friction law}/joints", "", "joints with this friction law"},
          {"friction/{friction law}/heat/[]/temperature_degC", "degC", "of the joints"},
          {"friction/{friction law}/heat/[]/heat_W", "W", "friction heat of all these joints"},
          {"friction/{friction law}/heat/[]/in_range", "", "false: outside the range in which the law was tested"}},
         friction_keys("operating_points/[]"),
         below("conductances/[]", {{"joint", "", "empty: a bond"},
                                   {"interface", "", "of the joint; of a bond its two parts"},
                                   {"law", "", "law of the contact conductance"},
                                   {"area_m2", "m2", "contact area, of the modelled half"},
                                   {"pressure_Pa", "Pa", "contact pressure used by the law"},
                                   {"pressure_from", "", "loads or case"},
                                   {"resistance_m2_K_per_W", "m2 K/W", "resistance of both sides together"},
                                   {"side_a_W_per_m2_K", "W/m2/K", "conductance from side a to the contact layer"},
                                   {"side_b_W_per_m2_K", "W/m2/K", "conductance from side b to the contact layer"},
                                   {"in_range", "", "false: outside the range in which the law was tested"},
                                   {"notes", "", "remarks of the law"}}),
         below("films/{surface}", {{"law", "", "law of the convection coefficient"},
                                   {"area_m2", "m2", "of the modelled half"},
                                   {"length_m", "m", "characteristic length used by the law"},
                                   {"ambient_degC", "degC", ""}}),
         values("at_rest"),
         values("running")});
}

Keys motion_keys()
{
    return {{"version", "", "version of the program"},
            {"past_bottom_deg", "deg", "crank angles of all lists below"},
            {"slide_height_m", "m", "above bottom dead point"},
            {"bodies/[]/name", "", ""},
            {"bodies/[]/ground", "", "true if it stands still"},
            {"bodies/[]/slide", "", "true if it carries the tool"},
            {"bodies/[]/poses", "m, m, rad", "x, y and angle from the drawn position"},
            {"joints/[]/name", "", ""},
            {"joints/[]/kind", "", "revolute or slide"},
            {"joints/[]/body_a", "", "number of the body, from 0"},
            {"joints/[]/body_b", "", "number of the body, from 0"},
            {"joints/[]/direction", "", "of travel of a slide"},
            {"joints/[]/places", "m", "x and y"}};
}

}  // namespace deadpoint::report::schema
