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
    return below(at, {{"unit", "", "of the figures here"},
                      {"values", "", "how many are compared"},
                      {"rms", "{unit}", "root mean square of the errors"},
                      {"bias", "{unit}", "mean error"},
                      {"largest_error", "{unit}", "largest in magnitude"},
                      {"rms_of_no_change", "{unit}", "root mean square if no change were predicted"},
                      {"rms_of_mean", "{unit}", "the same if the mean of the references were predicted"},
                      {"rms_of_baseline", "{unit}", "the same of the baseline's result"}});
}

}  // namespace

Keys head_keys()
{
    return {{"version", "", "of the program"},
            {"case/name", "", "of the machine"},
            {"case/hash", "", "of the case: the same for the same case, whatever its files"}};
}

Keys view_keys()
{
    return joined(
        {head_keys(),
         {{"half_model", "", "whether half of the press is shown"},
          {"merged_within_m", "m", "boxes within which nodes were merged; 0: none"},
          {"initial_temperature_K", "K", ""},
          {"largest_rise_K", "K", "of any node at any time kept"},
          {"error_of_modes_K", "K", "largest, of leaving out further modes"},
          {"time_s", "s", "times that were kept"},
          {"coefficients", "", "of each mode at each time"},
          {"vertices", "", "of the surface"}},
         array_keys("positions_m", "m", "x, y, z of every vertex"),
         modal_keys("temperature_K", "K", "temperature at every vertex"),
         modal_keys("displacement_m", "m", "displacement at every vertex"),
         {{"parts/[]/name", "", ""},
          {"parts/[]/body", "", ""},
          {"parts/[]/first_vertex", "", "number of its first vertex"},
          {"parts/[]/vertices", "", "how many"},
          {"parts/[]/triangles", "", "how many"},
          {"parts/[]/symmetry_triangles", "", "how many of them, the last ones, lie in the plane of symmetry"},
          {"parts/[]/data", "", "corners of the triangles, counted from its first vertex, 16 bits in base64"},
          {"probes/[]/name", "", ""},
          {"probes/[]/part", "", ""},
          {"probes/[]/position_m", "m", "x, y, z"},
          {"probes/[]/note", "", "from the case"}}});
}

Keys sweep_keys()
{
    return {{"version", "", "of the program"},
            {"study/name", "", ""},
            {"study/note", "", "from the study file"},
            {"study/base", "", "case file that the points change"},
            {"study/overrides", "", "what is changed in all points"},
            {"warnings", "", ""},
            {"limits/largest_um", "um", "of the largest change of the gap; null: none"},
            {"limits/end_um", "um", "of its change at the end; null: none"},
            {"sets/[]/name", "", ""},
            {"sets/[]/axes/[]/name", "", ""},
            {"sets/[]/axes/[]/keys", "", "keys of the case that the axis sets"},
            {"sets/[]/axes/[]/values", "", "their values at each step"},
            {"sets/[]/axes/[]/labels", "", "name of each step"},
            {"sets/[]/axes/[]/unit", "", "of the numbers"},
            {"sets/[]/axes/[]/numbers", "{unit}", "the steps as numbers, where they are"},
            {"sets/[]/window/text", "", "the largest block of neighbouring steps that keeps the limits"},
            {"sets/[]/window/points", "", "in it"},
            {"sets/[]/window/share_of_range", "", "of the set's points"},
            {"sets/[]/window/axes/{axis}", "", "labels of its steps"},
            {"points/[]/name", "", "folder below points/"},
            {"points/[]/state", "", "done, kept, failed or left"},
            {"points/[]/seconds", "s", "computing time"},
            {"points/[]/reason", "", "why there is no result"},
            {"points/[]/overrides", "", "what is changed in this point"},
            {"points/[]/places/[]/set", "", "in which it stands"},
            {"points/[]/places/[]/steps/{axis}", "", "label of its step"},
            {"points/[]/case_hash", "", "as case/hash in its summary.json"},
            {"points/[]/interrupted", "", "whether it was stopped before its end"},
            {"points/[]/figures/E_SW/largest_um", "um", "change of the gap that is largest in magnitude"},
            {"points/[]/figures/E_SW/largest_at_s", "s", "when that is"},
            {"points/[]/figures/E_SW/end_um", "um", "change of the gap at the end"},
            {"points/[]/figures/E_SW/first_hour_change_um", "um", "change over the first hour"},
            {"points/[]/figures/E_SW/range_um", "um", "largest less smallest value of the run"},
            {"points/[]/figures/E_SW/steady_from_s", "s", "from then on the gap drifts by less than the limit"},
            {"points/[]/figures/rises_at_end_K/{probe}", "K", ""},
            {"points/[]/figures/joint_heat_at_end_W", "W", "of all joints"},
            {"points/[]/figures/bearing_peak_forces_N/{bearing}", "N", "on the bearings of the crankshaft"},
            {"points/[]/figures/keeps_limits", "", ""}};
}

Keys compare_keys()
{
    return joined({head_keys(),
                   {{"result", "", "folder that was compared"},
                    {"reference/name", "", ""},
                    {"reference/source", "", ""},
                    {"reference/point", "", "operating point of the reference; empty: those of none"},
                    {"baseline", "", "folder of the baseline; null: none"},
                    {"warnings", "", ""},
                    {"calibrated_on", "", "keys of the case that were fitted"},
                    {"sets/[]/kind", "", "rises, chain, times or loads"},
                    {"sets/[]/group", "", "of the reference file"},
                    {"sets/[]/calibrated", "", "whether the case was fitted to them"},
                    {"sets/[]/largest_error_of", "", "which value has it"}},
                   figure_keys("sets/[]"),
                   below("values/[]", {{"kind", "", "rises, chain, times or loads"},
                                       {"group", "", "of the reference file"},
                                       {"name", "", ""},
                                       {"unit", "", "of the figures here"},
                                       {"reference", "{unit}", "stated"},
                                       {"computed", "{unit}", ""},
                                       {"error", "{unit}", "computed less reference"},
                                       {"baseline", "{unit}", "computed by the baseline"},
                                       {"relative_error", "", "error over reference"},
                                       {"calibrated", "", "whether the case was fitted to it"},
                                       {"note", "", "from the reference file"}}),
                   below("curves/[]", {{"name", "", "column and file"},
                                       {"measures", "", "what it holds"},
                                       {"calibrated", "", "whether the case was fitted to it"},
                                       {"largest_error_at_s", "s", "when it is"},
                                       {"note", "", "from the reference file"},
                                       {"time_s", "s", "of the lists below"},
                                       {"reference", "{unit}", "stated"},
                                       {"computed", "{unit}", ""},
                                       {"baseline", "{unit}", "computed by the baseline"}}),
                   figure_keys("curves/[]/figures"),
                   below("claims/[]", {{"text", "", ""},
                                       {"kind", "", "of claim"},
                                       {"verdict", "", "holds, does not hold or not checked"},
                                       {"evidence", "", "what the result shows"},
                                       {"note", "", "from the reference file"}})});
}

Keys manifest_keys()
{
    return {{"written_by", "", "deadpoint"},
            {"format", "", "number of the format of the folder; it changes when an older program could not read it"},
            {"version", "", "of the program"},
            {"checksum", "", "of the list of files"},
            {"files/{file}/bytes", "byte", "size"},
            {"files/{file}/checksum", "", "of its bytes"}};
}

}  // namespace deadpoint::report::schema
