#include "deadpoint/report/schema/keys.hpp"

namespace deadpoint::report::schema {

namespace {

Keys design_keys(const std::string& at)
{
    return below(at,
                 {{"drift_rms_um", "um", "root mean square of the change of E_SW since from_s"},
                  {"largest_change_um", "um", "largest size of this change"},
                  {"warm_after_h", "h", "time from which E_SW changes more slowly than the rate; null: not reached"},
                  {"ambient_um_per_K", "um/K", "root mean square change of E_SW per kelvin of the ambient"},
                  {"limits", "degC or um", "per limit the value nearest to it, or farthest beyond it"}});
}

}  // namespace

Keys sensitivity_study_keys()
{
    const std::string of_figure = "figures/[]/parameters/{parameter}", of_course = "course/[]/parameters/{parameter}";
    return joined(
        {head_keys(),
         {{"study/name", "", ""},
          {"study/note", "", "from the study file"},
          {"study/base", "", "case file whose keys vary"},
          {"study/overrides", "", "changes to the case in all runs"},
          {"reduced_model", "", "file of the reduced model"},
          {"warnings", "", ""},
          {"method", "", "sobol or morris"},
          {"rows", "", "points of the design of Sobol' indices, or trajectories"},
          {"seed", "", "of the random numbers"},
          {"runs", "", "number of runs"},
          {"failed", "", "runs without a result; they are left out"},
          {"seconds", "s", "computing time"},
          {"parameters/[]/name", "", ""},
          {"parameters/[]/keys", "", "keys of the case that change together"},
          {"parameters/[]/range", "", "both ends, as text"},
          {"figures/[]/output", "", "probe, dimension of the chain or corner"},
          {"figures/[]/figure", "", "end, a time, or time to warm: 95 % of the change"},
          {"figures/[]/unit", "", "of differences of the figure"},
          {"figures/[]/mean_unit", "", "of the mean"},
          {"figures/[]/mean", "{mean_unit}", "over all runs"},
          {"figures/[]/deviation", "{unit}", "standard deviation over all runs"}},
         below(of_figure, {{"first", "", "Sobol' index of first order, and both ends of its band of 90 %"},
                           {"total", "", "total Sobol' index, and both ends of its band of 90 %"},
                           {"bound", "", "upper bound of the total index by derivatives"},
                           {"strength", "{unit}", "mu*: mean size of the effect, and both ends of its band of 90 %"},
                           {"mean", "{unit}", "mu: mean effect, with its sign"},
                           {"deviation", "{unit}", "sigma: standard deviation of the effect"}}),
         {{"course/[]/output", "", "probe, dimension of the chain or corner"},
          {"course/[]/unit", "", "of deviations and effects"},
          {"course/[]/hours", "h", "times of the lists"},
          {"course/[]/deviation", "{unit}", "standard deviation over all runs at each time"}},
         below(of_course, {{"first", "", "Sobol' index of first order at each time"},
                           {"total", "", "total Sobol' index at each time"},
                           {"strength", "{unit}", "mu* at each time"}})});
}

Keys optimise_keys()
{
    return joined(
        {head_keys(),
         {{"study/name", "", ""},
          {"study/note", "", "from the study file"},
          {"study/base", "", "case file whose keys vary"},
          {"study/overrides", "", "changes to the case"},
          {"reduced_model", "", "file of the reduced model"},
          {"warnings", "", ""},
          {"objective", "", "drift, warm-up or ambient"},
          {"unit", "", "of the objective"},
          {"rate_um_per_h", "um/h", "rate below which the press is warm"},
          {"from_s", "s", "time from which the change counts"},
          {"method", "", "slsqp, ccsa or cobyla"},
          {"seconds", "s", "computing time"},
          {"keeps_limits", "", "true if the optimum keeps all limits"},
          {"best_start", "", "start that led to the optimum; 1 is the case itself"},
          {"minima", "", "number of different minima among the starts"},
          {"variables/[]/name", "", ""},
          {"variables/[]/range", "", "both ends, as text"},
          {"variables/[]/unit", "", "of the values"},
          {"variables/[]/before", "{unit}", "value of the case, or the nearest in the range"},
          {"variables/[]/optimum", "{unit}", ""},
          {"profile_ends_s", "s", "ends of the intervals of the speed profile, whose speeds are the first variables"},
          {"limits/[]/output", "", ""},
          {"limits/[]/most", "", "largest allowed value, as in the study file"},
          {"limits/[]/least", "", "least allowed value, as in the study file"},
          {"limits/[]/from_s", "s", "from this time on"},
          {"starts/[]/value", "{unit}", "least objective"},
          {"starts/[]/keeps_limits", "", "true if it keeps all limits"},
          {"starts/[]/evaluations", "", ""},
          {"starts/[]/end", "", "why the search ended"},
          {"starts/[]/from", "", "variables at the start"},
          {"starts/[]/to", "", "variables at the minimum"}},
         design_keys("before"),
         design_keys("promised"),
         design_keys("full_run")});
}

}  // namespace deadpoint::report::schema
