#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What a calibration found, as plain data: temperatures [K], changes of dimensions [m], times [s].
namespace deadpoint::twin {

/// A value of the case before and after, as text for --set and case files.
struct ChangedKey {
    std::string key, before, after;
};

/// What data tell of an unknown or of a combination.
enum class Knowledge {
    prior,           ///< little or nothing: it is as uncertain as before
    partly,          ///< something
    data,            ///< nearly all that is known of it
    if_model_right,  ///< something or all if the model were right, but the model does not explain these data
};

/// An unknown. Its estimate and limits are factors, or shifts in SI units.
struct FittedParameter {
    enum class Kind { factor, shift, bias, lag, alternative };  ///< bias and lag belong to sensors
    std::string name;
    Kind kind = Kind::factor;
    std::string unit;   ///< SI unit of a shift or bias; "share" of an alternative's difference; empty: a factor
    std::string place;  ///< in the calibration file
    std::vector<ChangedKey> values;
    double prior = 0;                             ///< standard deviation of theta before
    double theta = 0;                             ///< ln of a factor, or shift
    double deviation = 0;                         ///< standard deviation of theta after
    double estimate = 0;                          ///< likeliest value
    double lower = 0, upper = 0;                  ///< interval with the probability Calibration::level
    bool open_below = false, open_above = false;  ///< the data give no limit within the allowed values
    bool by_profile = false;                      ///< else the interval is that of the normal distribution
    double prior_lower = 0, prior_upper = 0;      ///< the same interval before any measurement
    bool at_limit = false;
    double expected = 0;   ///< shrinkage that the data would give at the prior's centre
    double shrinkage = 0;  ///< 1 - variance after / variance before: 0 prior only, 1 data only
    Knowledge known = Knowledge::prior;
    double influence = 0;  ///< change of all values by one prior standard deviation, in standard deviations of noise
    std::vector<std::pair<double, double>> profile;  ///< value, twice the cost above the least
};

/// A combination of unknowns that data determine, or not.
struct KnownCombination {
    double singular_value = 0;  ///< above 1 the data say more than the prior
    Knowledge known = Knowledge::prior;
    std::string words;
    std::vector<double> direction;  ///< by parameter, in standard deviations of the prior
};

/// One measured curve beside the model.
struct FittedCurve {
    std::string run, column, output;
    bool of_gap = false;
    bool hold_out = false;
    std::vector<double> time, measured;
    std::vector<double> before;        ///< predicted by the unchanged case
    std::vector<double> predicted;     ///< with the bias and lag of the sensor
    std::vector<double> lower, upper;  ///< band in which measured values are expected
    double rms = 0, bias = 0;          ///< of measured - predicted
    double rms_before = 0;             ///< of the unchanged case
    double rms_nothing = 0;            ///< of predicting the value at the start
    std::optional<double> rms_mean;    ///< of predicting the mean of the fitted runs at the same time
    double inside = 0;                 ///< share of values in the band
    double chi_square = 0, lag_one = 0, probability = 1;  ///< of whitened residuals, before a model error was added
    double correlation_time = 0;                          ///< of the noise
    double model_error = 0;                               ///< that was added
};

/// A curve of a run over its time steps.
struct PredictedCurve {
    std::string output;
    bool of_gap = false;
    std::vector<double> before, value, lower, upper;  ///< band of the true value
};
struct PredictedRun {
    std::string name;
    bool hold_out = false;
    std::vector<double> time;
    std::vector<PredictedCurve> curves;
};

/// Draws of the posterior.
struct PosteriorSamples {
    std::vector<std::vector<double>> values;  ///< [draw][parameter], as FittedParameter::estimate
    double accepted = 0;
    double surrogate_error = 0;  ///< largest root mean square error of the stand-in, in standard deviations of noise
    std::vector<std::pair<double, double>> intervals;  ///< by parameter
};

struct Calibration {
    std::string name, note;
    std::string case_name, case_hash, reduced_file;
    double level = 0.9;
    std::vector<FittedParameter> parameters;
    std::vector<KnownCombination> before, after;  ///< combinations at the prior's centre and at the fit
    std::vector<std::vector<double>> correlation;
    std::vector<FittedCurve> curves;
    std::vector<PredictedRun> predictions;
    double cost_before = 0, cost = 0;
    bool converged = true;
    int evaluations = 0;
    double seconds = 0;  ///< of the fits
    std::size_t starts = 1;
    std::vector<std::pair<double, std::vector<double>>> other_minima;  ///< cost above the least, values
    bool model_differs = false;                                        ///< the model does not explain the data
    double model_probability = 1;
    double reduced_temperature = 0, reduced_gap = 0;  ///< stated error of the reduced model
    double step_temperature = 0, step_gap = 0;        ///< change at the fit by steps of controlled accuracy
    std::optional<PosteriorSamples> samples;
    std::optional<std::pair<double, double>> full_run;  ///< largest difference of a full run at the fit [K], [m]
    std::vector<std::string> outside;                   ///< coefficients outside of the reduced model's range
    std::vector<std::string> warnings;
    std::vector<std::string> notes;
    std::vector<std::string> settings;  ///< "key=value" of the calibrated case
};

/// What a further sensor or run would tell.
struct CandidateGain {
    std::string name;
    double information = 0;                            ///< [nat]; 0.69 halves the volume of what is possible
    std::string most_about;                            ///< the parameter whose uncertainty shrinks most
    double deviation_before = 0, deviation_after = 0;  ///< of theta of that parameter
};

/// What planned runs can determine.
struct CalibrationPlan {
    std::string name, note;
    std::string case_name, case_hash, reduced_file;
    double level = 0.9;
    std::size_t runs = 0, values = 0;
    std::vector<FittedParameter> parameters;  ///< without estimates
    std::vector<KnownCombination> combinations;
    std::vector<CandidateGain> candidates;  ///< the best first
    std::vector<std::string> warnings;
    std::vector<std::string> notes;
};

}  // namespace deadpoint::twin
