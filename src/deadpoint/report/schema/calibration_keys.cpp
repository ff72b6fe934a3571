#include "deadpoint/report/schema/keys.hpp"

namespace deadpoint::report::schema {
namespace {

Keys parameter_keys()
{
    return below(
        "parameters/[]",
        {{"name", "", "of the calibration file, or bias or lag of a sensor, or an alternative"},
         {"kind", "", "factor, shift, bias, lag or alternative"},
         {"unit", "",
          "of these figures; empty: a factor; share: a multiple of the error that an "
          "alternative allows for"},
         {"estimate", "{unit}", "likeliest value"},
         {"lower", "{unit}", "lower end of the interval with probability level"},
         {"upper", "{unit}", "upper end of it"},
         {"open_below", "", "true: the data give no lower end within the allowed values"},
         {"open_above", "", "true: they give no upper end"},
         {"by_profile", "", "true: interval by the profile of the likelihood"},
         {"prior_lower", "{unit}", "lower end of the interval before any measurement"},
         {"prior_upper", "{unit}", "upper end of it"},
         {"at_limit", "", "true: it ends at a limit of the calibration file"},
         {"shrinkage", "", "1 - variance after / variance before"},
         {"known", "", "by the data, in part, prior only, or only if the model were right (model/differs is true)"},
         {"expected_shrinkage", "", "the same at the case's values, before the fit"},
         {"influence", "",
          "change of all measured values by one standard deviation of the "
          "prior, in standard deviations of their errors"},
         {"keys/[]/key", "", "of the case"},
         {"keys/[]/before", "", "value of the case"},
         {"keys/[]/after", "", "calibrated value"},
         {"profile/values", "{unit}", "values at which the others were fitted"},
         {"profile/rise", "", "twice the cost above the least"}});
}

Keys combination_keys(const std::string& at)
{
    return below(at, {{"words", "", "product or ratio of unknowns"},
                      {"singular_value", "", "above 1 the data say more than the prior"},
                      {"known", "", "by the data, prior only, or only if the model were right"},
                      {"weights", "", "by unknown, in standard deviations of the prior"}});
}

Keys common_keys()
{
    return joined({head_keys(),
                   {{"calibration/name", "", "of the calibration file"},
                    {"calibration/note", "", "of the calibration file"},
                    {"reduced_model", "", "file of the reduced model"},
                    {"level", "", "probability of intervals and bands"},
                    {"warnings", "", ""},
                    {"notes", "", "what was not used, and why"},
                    {"conclusions", "", "what the data say, in words"}},
                   parameter_keys(),
                   combination_keys("combinations/[]")});
}

Keys curve_keys()
{
    return below("curves/[]", {{"run", "", "of the calibration file"},
                               {"quantity", "", "probe or dimension"},
                               {"column", "", "of the measured file"},
                               {"unit", "", "unit of these figures"},
                               {"held_out", "", "true: predicted, not fitted"},
                               {"values", "", "number of values"},
                               {"rms", "{unit}", "root mean square of measured less calibrated"},
                               {"bias", "{unit}", "their mean"},
                               {"rms_of_case", "{unit}", "root mean square of measured less the case as it was"},
                               {"rms_of_no_change", "{unit}", "of predicting the value at the start"},
                               {"rms_of_mean", "{unit}", "of predicting the mean of the other fitted runs; null: none"},
                               {"inside_band", "", "share of values in the band in which they are expected"},
                               {"chi_square", "", "mean square of whitened residuals, before a model error was added"},
                               {"lag_one", "", "correlation of neighbouring whitened residuals"},
                               {"probability", "", "of residuals as unlike the stated errors as these"},
                               {"correlation_time_s", "s", "of the noise"},
                               {"model_error", "{unit}", "that was added to the noise"}});
}

}  // namespace

Keys calibration_keys()
{
    return joined({common_keys(),
                   {{"fit/converged", "", ""},
                    {"fit/model_runs", "", "runs of all cases with derivatives"},
                    {"fit/seconds", "s", "wall time of the fits"},
                    {"fit/starts", "", "starting points"},
                    {"fit/cost_before", "", "at the case's values"},
                    {"fit/cost", "", "at the fit"},
                    {"fit/other_minima/[]/cost_above", "", "cost of another fit above that of the best"},
                    {"fit/other_minima/[]/values", "", "its values, by unknown"},
                    {"model/differs", "", "true: model and stated errors do not explain the data"},
                    {"model/probability", "", "of residuals as unlike the stated errors as these"},
                    {"model/reduced_error_K", "K", "error that the reduced model states"},
                    {"model/reduced_error_um", "um", "the same of the gap"},
                    {"model/step_error_K", "K", "change at the fit by steps of controlled accuracy"},
                    {"model/step_error_um", "um", "the same of dimensions"},
                    {"model/outside", "", "coefficients of the fit outside of the reduced model's range"}},
                   combination_keys("combinations_before/[]"),
                   {{"correlation", "", "of the unknowns after the fit, a row for each"}},
                   curve_keys(),
                   {{"full_run/difference_K", "K", "largest difference of a full run of the calibrated case"},
                    {"full_run/difference_um", "um", "the same of the gap"},
                    {"samples/count", "", "number of draws"},
                    {"samples/accepted", "", "share of steps that moved"},
                    {"samples/surrogate_error", "",
                     "largest root mean square error of the stand-in model, in standard deviations of the errors"},
                    {"samples/intervals", "", "by unknown, with probability level"}}});
}

Keys plan_keys()
{
    return joined({common_keys(),
                   {{"runs", "", "number of planned runs"},
                    {"values", "", "number of their values"},
                    {"candidates/[]/name", "", ""},
                    {"candidates/[]/information_nat", "nat", "that it is expected to give"},
                    {"candidates/[]/most_about", "", "unknown whose uncertainty it lowers most"},
                    {"candidates/[]/deviation_before", "", "its standard deviation with the planned runs"},
                    {"candidates/[]/deviation_after", "", "and with the candidate"}}});
}

}  // namespace deadpoint::report::schema
