#pragma once

#include "deadpoint/twin/calibrate/calibration_result.hpp"

/// A calibration and a plan in which nothing is missing.
namespace everything {

inline deadpoint::twin::FittedParameter factor_of(const std::string& name, double estimate, double shrinkage)
{
    deadpoint::twin::FittedParameter p;
    p.name = name;
    p.values = {{"oil." + name, "300.0 W/m^2/K", "330.0 W/m^2/K"}};
    p.estimate = estimate;
    p.lower = 0.9 * estimate;
    p.upper = 1.1 * estimate;
    p.prior_lower = 0.5;
    p.prior_upper = 2;
    p.shrinkage = shrinkage;
    p.known = shrinkage < 0.2 ? deadpoint::twin::Knowledge::prior : deadpoint::twin::Knowledge::data;
    p.profile = {{0.9 * estimate, 2.7}, {estimate, 0}};
    return p;
}

inline deadpoint::twin::FittedParameter bias_of_gap()
{
    deadpoint::twin::FittedParameter p;
    p.name = "bias of E_SW";
    p.kind = deadpoint::twin::FittedParameter::Kind::bias;
    p.unit = "m";
    p.estimate = 2e-6;
    p.lower = 1e-6;
    p.upper = 3e-6;
    p.shrinkage = 0.5;
    p.known = deadpoint::twin::Knowledge::if_model_right;
    return p;
}

inline deadpoint::twin::FittedCurve curve_of(const std::string& run, const std::string& output, bool gap, bool hold_out)
{
    const double s = gap ? 1e-6 : 1;
    deadpoint::twin::FittedCurve c;
    c.run = run;
    c.column = c.output = output;
    c.of_gap = gap;
    c.hold_out = hold_out;
    c.time = {0, 3600};
    c.measured = {s * 293, s * 303};
    c.before = {s * 293, s * 297};
    c.predicted = {s * 293, s * 302};
    c.lower = {s * 292, s * 301};
    c.upper = {s * 294, s * 303.5};
    c.rms = s * 0.7;
    c.rms_before = s * 4;
    c.rms_nothing = s * 7;
    c.rms_mean = s * 2;
    c.inside = 1;
    c.model_error = hold_out ? 0 : s * 0.5;
    return c;
}

inline deadpoint::twin::Calibration calibration_of_all()
{
    deadpoint::twin::Calibration c;
    c.name = "shop, May";
    c.case_name = "press";
    c.case_hash = "0123456789abcdef";
    c.parameters = {factor_of("pins", 1.1, 0.95), factor_of("gibs", 1, 0.05), bias_of_gap()};
    using enum deadpoint::twin::Knowledge;
    c.parameters.front().known = if_model_right;
    c.before = c.after = {{12, if_model_right, "pins", {1, 0, 0}}, {0.3, prior, "gibs", {0, 1, 0}}};
    c.correlation = {{1, 0.2, 0}, {0.2, 1, 0}, {0, 0, 1}};
    c.curves = {curve_of("slow", "top", false, false), curve_of("fast", "E_SW", true, true)};
    c.predictions = {{"slow", false, {0, 3600}, {{"top", false, {293.15, 297}, {293.15, 302}, {293, 301}, {294, 303}}}},
                     {"fast run", true, {0, 60}, {{"E_SW", true, {0, 1e-6}, {0, 2e-6}, {0, 1e-6}, {0, 3e-6}}}}};
    c.cost_before = 50;
    c.cost = 3;
    c.other_minima = {{4, {1, 2, 3}}};
    c.model_differs = true;
    c.model_probability = 0.001;
    c.samples = deadpoint::twin::PosteriorSamples{{{1, 2, 3e-6}}, 0.3, 0.01, {{1, 2}, {1, 2}, {1, 2}}};
    c.full_run = {0.02, 1e-7};
    c.warnings = {"be careful"};
    c.settings = {R"(oil.pins="330.0 W/m^2/K")"};
    return c;
}

inline deadpoint::twin::CalibrationPlan plan_of_all()
{
    deadpoint::twin::CalibrationPlan p;
    p.name = "plan";
    p.case_name = "press";
    p.parameters = {factor_of("pins", 1, 0.95), factor_of("gibs", 1, 0.05)};
    using enum deadpoint::twin::Knowledge;
    p.combinations = {{12, data, "pins", {1, 0}}, {0.3, prior, "gibs", {0, 1}}};
    p.candidates = {{"sensor at gib", 1.5, "gibs", 0.7, 0.21}};
    return p;
}

}  // namespace everything
