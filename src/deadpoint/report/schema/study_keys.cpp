#include "deadpoint/report/schema/keys.hpp"

namespace deadpoint::report::schema {
namespace {

/// Numbers of 16 bits: low + step * number.
Keys array_keys(const std::string& at, const std::string& unit, const std::string& of)
{
    return below(at, {{"low", unit, of + ": smallest value"},
                      {"step", unit, "value of one unit of the numbers in data"},
                      {"data", "", "numbers of 16 bits, little-endian, in base64"}});
}

Keys modal_keys(const std::string& at, const std::string& unit, const std::string& of)
{
    return joined({array_keys(at + "/base", unit, of), array_keys(at + "/modes/[]", unit, "mode of it")});
}

/// Errors of a set of values or of a curve, in its unit.
Keys figure_keys(const std::string& at)
{
    return below(at, {{"unit", "", "unit of these figures"},
                      {"values", "", "number of compared values"},
                      {"rms", "{unit}", "root mean square of the errors"},
                      {"bias", "{unit}", "mean error"},
                      {"largest_error", "{unit}", "largest in magnitude"},
                      {"rms_of_no_change", "{unit}", "root mean square error of predicting no change"},
                      {"rms_of_mean", "{unit}", "root mean square error of predicting the mean of the references"},
                      {"rms_of_baseline", "{unit}", "root mean square error of the baseline"}});
}

}  // namespace

Keys head_keys()
{
    return {{"version", "", "version of the program"},
            {"case/name", "", "name of the machine"},
            {"case/hash", "", "hash of the case; equal for equal cases, even if their files differ"}};
}

Keys view_keys()
{
    return joined(
        {head_keys(),
         {{"directions/front", "", "unit vector from the machine towards its operator"},
          {"directions/left", "", "unit vector to the left of the operator"},
          {"directions/up", "", "unit vector upwards"},
          {"half_model", "", "true if half of the press is shown"},
          {"merged_within_m", "m", "size of the boxes within which nodes were merged; 0: none"},
          {"initial_temperature_K", "K", ""},
          {"largest_rise_K", "K", "largest rise of any node at any stored time"},
          {"error_of_modes_K", "K", "largest error from the modes that are left out"},
          {"time_s", "s", "stored times"},
          {"coefficients", "", "coefficient of each mode at each time"},
          {"vertices", "", "number of vertices of the surface"}},
         array_keys("positions_m", "m", "x, y, z of every vertex"),
         modal_keys("temperature_K", "K", "temperature at every vertex"),
         modal_keys("displacement_m", "m", "displacement at every vertex"),
         {{"parts/[]/name", "", ""},
          {"parts/[]/body", "", ""},
          {"parts/[]/first_vertex", "", "number of its first vertex"},
          {"parts/[]/vertices", "", "number of its vertices"},
          {"parts/[]/triangles", "", "number of its triangles"},
          {"parts/[]/symmetry_triangles", "", "number of triangles in the plane of symmetry, which come last"},
          {"parts/[]/data", "", "corners of the triangles, counted from its first vertex, 16 bits in base64"},
          {"probes/[]/name", "", ""},
          {"probes/[]/part", "", ""},
          {"probes/[]/position_m", "m", "x, y, z"},
          {"probes/[]/note", "", "from the case"}}});
}

Keys sweep_keys()
{
    return {
        {"version", "", "version of the program"},
        {"study/name", "", ""},
        {"study/note", "", "from the study file"},
        {"study/base", "", "case file that the points change"},
        {"study/overrides", "", "changes to the case in all points"},
        {"warnings", "", ""},
        {"limits/largest_um", "um", "limit of the largest change of the gap; null: none"},
        {"limits/end_um", "um", "limit of its change at the end; null: none"},
        {"sets/[]/name", "", ""},
        {"sets/[]/axes/[]/name", "", ""},
        {"sets/[]/axes/[]/keys", "", "keys of the case that the axis sets"},
        {"sets/[]/axes/[]/values", "", "their values at each step"},
        {"sets/[]/axes/[]/labels", "", "name of each step"},
        {"sets/[]/axes/[]/unit", "", "of the numbers"},
        {"sets/[]/axes/[]/numbers", "{unit}", "the steps as numbers, if they are numbers"},
        {"sets/[]/window/text", "", "the largest block of neighbouring steps that keeps the limits"},
        {"sets/[]/window/points", "", "in it"},
        {"sets/[]/window/share_of_range", "", "of the set's points"},
        {"sets/[]/window/axes/{axis}", "", "labels of its steps"},
        {"points/[]/name", "", "folder below points/"},
        {"points/[]/state", "", "done, kept (computed before), failed or left (not computed)"},
        {"points/[]/seconds", "s", "computing time"},
        {"points/[]/reason", "", "why there is no result"},
        {"points/[]/overrides", "", "changes to the case in this point"},
        {"points/[]/places/[]/set", "", "set to which the point belongs"},
        {"points/[]/places/[]/steps/{axis}", "", "label of its step"},
        {"reduced_model", "", "file of the reduced model, where one computed the points; they have no folders then"},
        {"points/[]/case_hash", "", "as case/hash in its summary.json"},
        {"points/[]/interrupted", "", "true if it was stopped before its end"},
        {"points/[]/figures/E_SW/largest_um", "um", "change of the gap that is largest in magnitude"},
        {"points/[]/figures/E_SW/largest_at_s", "s", "time of that value"},
        {"points/[]/figures/E_SW/end_um", "um", "change of the gap at the end"},
        {"points/[]/figures/E_SW/first_hour_change_um", "um", "change over the first hour"},
        {"points/[]/figures/E_SW/range_um", "um", "largest less smallest value of the run"},
        {"points/[]/figures/E_SW/steady_from_s", "s", "time from which the gap drifts by less than the limit"},
        {"points/[]/figures/rises_at_end_K/{probe}", "K", ""},
        {"points/[]/figures/joint_heat_at_end_W", "W", "of all joints"},
        {"points/[]/figures/bearing_peak_forces_N/{bearing}", "N", "peak force on a bearing of the crankshaft"},
        {"points/[]/figures/keeps_limits", "", ""}};
}

Keys compare_keys()
{
    return joined({head_keys(),
                   {{"result", "", "folder that was compared"},
                    {"reference/name", "", ""},
                    {"reference/source", "", ""},
                    {"reference/point", "", "operating point of the reference; empty: values without one"},
                    {"baseline", "", "folder of the baseline; null: none"},
                    {"warnings", "", ""},
                    {"calibrated_on", "", "keys of the case that were fitted"},
                    {"agreement", "",
                     "1 - sqrt(mean over the sets of (rms / rms_of_no_change)^2): 1 as measured, 0 as far off as no "
                     "change; null: no set counts"},
                    {"agreement_sets", "", "sets and curves that count in it, each once"},
                    {"sets/[]/kind", "", "rises, chain, times or loads"},
                    {"sets/[]/group", "", "of the reference file"},
                    {"sets/[]/calibrated", "", "true if the case was fitted to these values"},
                    {"sets/[]/largest_error_of", "", "value that has the largest error"}},
                   figure_keys("sets/[]"),
                   below("values/[]", {{"kind", "", "rises, chain, times or loads"},
                                       {"group", "", "of the reference file"},
                                       {"name", "", ""},
                                       {"unit", "", "unit of these figures"},
                                       {"reference", "{unit}", "stated"},
                                       {"computed", "{unit}", ""},
                                       {"error", "{unit}", "computed value less reference"},
                                       {"baseline", "{unit}", "computed by the baseline"},
                                       {"relative_error", "", "error divided by reference"},
                                       {"calibrated", "", "true if the case was fitted to this value"},
                                       {"note", "", "from the reference file"}}),
                   below("curves/[]", {{"name", "", "column and file"},
                                       {"measures", "", "measured quantity"},
                                       {"calibrated", "", "true if the case was fitted to this value"},
                                       {"largest_error_at_s", "s", "time of the largest error"},
                                       {"note", "", "from the reference file"},
                                       {"time_s", "s", "times of the lists below"},
                                       {"reference", "{unit}", "stated"},
                                       {"computed", "{unit}", ""},
                                       {"baseline", "{unit}", "computed by the baseline"}}),
                   figure_keys("curves/[]/figures"),
                   below("claims/[]", {{"text", "", ""},
                                       {"kind", "", "kind of claim"},
                                       {"verdict", "", "holds, does not hold or not checked"},
                                       {"evidence", "", "figures of the result behind the verdict"},
                                       {"note", "", "from the reference file"}})});
}

Keys manifest_keys()
{
    return {{"written_by", "", "deadpoint"},
            {"format", "", "number of the format of the folder; it changes when an older program could not read it"},
            {"version", "", "version of the program"},
            {"checksum", "", "checksum of the list of files"},
            {"files/{file}/bytes", "byte", "size"},
            {"files/{file}/checksum", "", "checksum of its bytes"}};
}

}  // namespace deadpoint::report::schema
