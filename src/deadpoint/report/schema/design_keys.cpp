#include "deadpoint/report/schema/keys.hpp"

namespace deadpoint::report::schema {

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

}  // namespace deadpoint::report::schema
