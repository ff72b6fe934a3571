#pragma once

#include "deadpoint/report/schema/column.hpp"

#include <array>

/// The columns of the tables of a calibration.
namespace deadpoint::report::schema::calibration {

inline constexpr Column parameter{"parameter", "unknown", "",
                                  "of the calibration file, or bias or lag of a sensor, or an alternative"};
inline constexpr Column kind{"kind", "kind", "", "factor, shift, bias, lag or alternative"};
inline constexpr Column unit{
    "unit", "unit", "",
    "of the values; empty: a factor; share: a multiple of the error that an alternative allows for"};
inline constexpr Column estimate{"estimate", "value", "", "likeliest value"};
inline constexpr Column lower{"lower", "lower", "", "lower end of the interval with the stated probability"};
inline constexpr Column upper{"upper", "upper", "", "upper end of it"};
inline constexpr Column prior_lower{"prior_lower", "lower before", "", "the same before any measurement"};
inline constexpr Column prior_upper{"prior_upper", "upper before", "", "the same before any measurement"};
inline constexpr Column shrinkage{"shrinkage", "shrinkage", "",
                                  "1 - variance after / variance before: 0 prior only, 1 data only"};
inline constexpr Column known{"known", "known", "",
                              "by the data; in part; prior only; or only if the model were right, which does not "
                              "explain these data"};
inline constexpr Column expected{"expected_shrinkage", "shrinkage expected", "",
                                 "before the fit, at the case's values"};
inline constexpr Column influence{
    "influence", "influence", "",
    "change of all measured values by one standard deviation of the prior, in standard deviations of their errors"};
inline constexpr std::array parameters{parameter,   kind,        unit,      estimate, lower,    upper,
                                       prior_lower, prior_upper, shrinkage, known,    expected, influence};

inline constexpr Column combination{"combination", "combination", "", "product or ratio of unknowns, in words"};
inline constexpr Column singular_value{"singular_value", "singular value", "",
                                       "above 1 the data say more than the prior"};
inline constexpr Column weight{"weight", "weight {parameter}", "",
                               "of the unknown's logarithm, in standard deviations of the prior"};
inline constexpr std::array combinations{combination, singular_value, known, weight};

inline constexpr Column correlation{"correlation", "{parameter}", "", "correlation of both unknowns after the fit"};
inline constexpr std::array correlations{parameter, correlation};

inline constexpr Column run{"run", "run", "", "of the calibration file"};
inline constexpr Column quantity{"quantity", "quantity", "", "probe or dimension"};
inline constexpr Column held_out{"held_out", "held out", "", "yes: predicted, not fitted"};
inline constexpr Column time{"time", "time", "s", "since the start of the run"};
inline constexpr Column measured{"measured", "measured", "", "in the unit of the row; temperatures in kelvin"};
inline constexpr Column predicted{"predicted", "calibrated", "",
                                  "by the calibrated case, with bias and lag of the sensor and shares of alternatives"};
inline constexpr Column before{"before", "before", "", "by the case as it was"};
inline constexpr Column band_lower{"band_lower", "lower", "",
                                   "lower end of the band in which measured values are expected"};
inline constexpr Column band_upper{"band_upper", "upper", "", "upper end of it"};
inline constexpr std::array residuals{run,      quantity,  unit,   held_out,   time,
                                      measured, predicted, before, band_lower, band_upper};

inline constexpr Column prediction{"prediction", "{quantity}", "{unit}",
                                   "by the calibrated case, with shares of alternatives"};
inline constexpr Column prediction_lower{"prediction_lower", "{quantity} lower", "{unit}",
                                         "lower end of the band of the true value"};
inline constexpr Column prediction_upper{"prediction_upper", "{quantity} upper", "{unit}", "upper end of it"};
inline constexpr Column prediction_before{"prediction_before", "{quantity} before", "{unit}", "by the case as it was"};
inline constexpr std::array predictions{time, prediction, prediction_lower, prediction_upper, prediction_before};

inline constexpr Column draw{"draw", "{parameter}", "{unit}", "value of the unknown; a row for each draw"};
inline constexpr std::array posterior{draw};

inline constexpr Column candidate{"candidate", "candidate", "", "sensor or run that could be added"};
inline constexpr Column information{"information", "information", "nat", "that it is expected to give"};
inline constexpr Column most_about{"most_about", "most about", "", "unknown whose uncertainty it lowers most"};
inline constexpr Column remaining{"remaining", "remaining", "",
                                  "share of that unknown's standard deviation that is left"};
inline constexpr std::array candidates{candidate, information, most_about, remaining};

}  // namespace deadpoint::report::schema::calibration
