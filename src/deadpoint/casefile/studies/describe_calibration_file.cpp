#include "deadpoint/casefile/describe/choose.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"

#include <algorithm>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

void expect_settings(Visitor& v, const std::vector<std::string>& set)
{
    v.expect(std::ranges::all_of(set, [](const auto& text) { return text.find('=') != std::string::npos; }), "set",
             "a setting is written path=value", "write it like \"operation.0.speed=300 rpm\"");
}

}  // namespace

void describe(Visitor& v, CalibrationFile& f)
{
    v.about(
        "The calibration file says what is unknown in a case and what was measured. `deadpoint calibrate` finds the "
        "unknowns, and says which of them the measurements determine. It is one TOML file; quantities are text with "
        "their unit, as in a case.");
    v.integer({"format", "version of this format; 1", required}, f.format, {1, 1, false});
    v.text({"name", "name in reports", required}, f.name);
    v.text({"note", "remarks for the reader"}, f.note);
    v.list({"parameters", "the unknowns", required}, f.parameters);
    v.list({"runs", "the measured or planned runs", required}, f.runs);
    v.list({"sensors", "how exact the sensors are", required}, f.sensors);
    v.list({"candidates", "for --plan: what could be measured besides; default: each probe, and E_SW"}, f.candidates);
    v.list({"alternatives", "other models of the same press, whose difference is what the model may be off"},
           f.alternatives);
    v.table({"options", "how the fit is made"}, f.options);
    v.expect(!f.parameters.empty() && !f.runs.empty() && !f.sensors.empty(), "", "there is nothing to calibrate",
             "add [[parameters]], [[runs]] and [[sensors]]");
}

void describe(Visitor& v, CalibrationParameter& p)
{
    v.about("One unknown. It multiplies the values of its keys by a factor, or shifts them. The case states the value "
            "that is likeliest before any measurement.");
    v.text({"name", "name in reports", required}, p.name);
    v.texts({"keys", "keys of the case, as for --set; * stands for any letters: \"oil.*\"", required}, p.keys);
    choose(v, {"kind", "`factor`: the values are multiplied by the unknown; `shift`: the unknown is added to them"},
           p.kind);
    v.number({"factor",
              "for `factor`: uncertainty before any measurement; with 2 two thirds of all presses lie between "
              "half and twice the value, and 95 % between a quarter and four times"},
             p.factor, {1, 1e6, true});
    v.setting({"sigma", "for `shift`: standard deviation before any measurement, with its unit: \"2 K\""}, p.sigma);
    v.setting({"lower", "smallest allowed factor, or shift with its unit"}, p.lower);
    v.setting({"upper", "largest allowed factor, or shift with its unit"}, p.upper);
    using enum CalibrationParameter::Kind;
    v.expect(p.kind != factor || p.factor > 1, "", "the uncertainty is missing", "add `factor`, such as factor = 2");
    v.expect(p.kind != factor || p.sigma.empty(), "sigma", "kind = \"factor\" does not use 'sigma'", "give `factor`");
    v.expect(p.kind != shift || !p.sigma.empty(), "", "the uncertainty is missing", "add `sigma`, such as \"2 K\"");
    v.expect(p.kind != shift || p.factor == 0, "factor", "kind = \"shift\" does not use 'factor'", "give `sigma`");
}

void describe(Visitor& v, CalibrationRun& r)
{
    v.about(
        "A run of the press with what was measured in it. Values come from a reference file, which `deadpoint "
        "compare` reads as well, or from a CSV file with a column for each sensor. A held-out run is predicted, and "
        "never fitted.");
    v.text({"name", "name in reports", required}, r.name);
    v.texts({"set", "differences from the case, each as for --set: operation, ambient, start"}, r.set);
    v.flag({"hold_out", "the run is predicted only"}, r.hold_out);
    v.path({"reference", "reference file; its rises, curves, and dimensions at a time are used"}, r.reference);
    v.text({"point", "operating point of the reference file"}, r.point);
    v.path({"data", "CSV file with a heading of names and units: `time [min],P1 [degC],E_SW [um]`"}, r.data);
    v.text({"time_column", "the times in it"}, r.time_column);
    choose(v, {"shows", "whether its temperatures are temperatures or rises above the start"}, r.shows);
    choose(v, {"gaps", "`leave_out`: empty cells and nan in it are left out"}, r.gaps);
    v.texts({"ignore", "columns that are not used; * stands for any letters"}, r.ignore);
    v.quantity({"until", "later values are left out"}, r.until, D::time, positive);
    v.quantity({"interval", "least time between values that are used; of planned ones the time between them, 10 min by "
                            "default"},
               r.interval, D::time, positive);
    v.texts({"measure", "for --plan, without values: probes and dimensions that will be measured"}, r.measure);
    v.expect(r.point.empty() || !r.reference.empty(), "point", "there is no reference file", "add `reference`");
    expect_settings(v, r.set);
}

void describe(Visitor& v, CalibrationSensor& s)
{
    v.about(
        "The errors of one sensor, or of several alike. Every measured column needs one. Values of one sensor are not "
        "independent of each other: state a correlation time, or have it estimated; otherwise intervals come out "
        "too narrow.");
    v.texts({"columns", "columns, probes and dimensions; * stands for any letters", required}, s.columns);
    v.text({"probe", "probe or dimension that it measures, where its column has another name"}, s.probe);
    v.setting({"noise", "standard deviation of a value, with its unit: \"0.2 K\", \"1 um\"", required}, s.noise);
    v.setting({"bias", "standard deviation of a constant error, which is then fitted as well: \"0.5 K\""}, s.bias);
    v.setting({"model_error",
               "standard deviation of what the model may be off in a slow course, besides the stated error "
               "of the reduced model: \"0.3 K\". Residuals cannot show what the unknowns can imitate, so "
               "that without it intervals are those of a perfect model"},
              s.model_error);
    v.quantity({"correlation_time", "time over which the noise changes; 0: every value has its own"},
               s.correlation_time, D::time, non_negative);
    v.flag({"estimate_correlation", "the correlation time is estimated from the residuals"}, s.estimate_correlation);
    v.quantity({"time_constant", "the sensor follows the temperature with this lag (first order)"}, s.time_constant,
               D::time, positive);
    v.number({"time_constant_factor", "uncertainty of the lag, which is then fitted as well; 1: it is known"},
             s.time_constant_factor, {1, 1e3, false});
    v.expect(s.time_constant_factor == 1 || s.time_constant, "time_constant_factor", "there is no time constant",
             "add `time_constant`");
    v.expect(!s.columns.empty(), "columns", "the list is empty", "name the columns, such as [\"P*\"]");
}

void describe(Visitor& v, CalibrationCandidate& c)
{
    v.about("For --plan: sensors that could be added to a run, or a further run.");
    v.text({"name", "name in reports", required}, c.name);
    v.text({"run", "run to which the sensors are added; default: all runs"}, c.run);
    v.texts({"set", "a further run, with these differences from the case"}, c.set);
    v.texts({"measure", "probes and dimensions; for a further run by default all that the others measure"}, c.measure);
    v.expect(!c.set.empty() || !c.measure.empty(), "", "the candidate measures nothing", "add `measure` or `set`");
    v.expect(c.run.empty() || c.set.empty(), "set", "the candidate has both `run` and `set`",
             "give `run` for sensors of a planned run, `set` for a further run");
    expect_settings(v, c.set);
}

void describe(Visitor& v, CalibrationAlternative& a)
{
    v.about("Another model of the same press that may be as good as that of the case: of another mesh, or with other "
            "laws. Its "
            "difference from the case's model is what the model may be off: a share of it is added to every "
            "prediction, the "
            "same in all runs, and fitted with the unknowns.");
    v.text({"name", "name in reports", required}, a.name);
    v.path({"reduced", "its reduced model, such as one built with `deadpoint reduce --size 1.5`; default: that of the "
                       "calibration"},
           a.reduced);
    v.texts({"set", "other laws, each as for --set"}, a.set);
    v.number(
        {"share",
         "standard deviation of the share; 1: the other model is as likely as this one. By default 1 for other laws; "
         "for another mesh h / |h' - h| with both cell sizes h, the error of a method of first order"},
        a.share, {0, 100, true});
    v.expect(!a.reduced.empty() || !a.set.empty(), "", "the alternative is the case itself",
             "give `reduced`, a model of another mesh, or `set`, other laws");
    v.expect(a.reduced.empty() || a.set.empty() || a.share > 0, "", "another mesh with other laws has no usual share",
             "give `share`, or make two alternatives of it");
    expect_settings(v, a.set);
}

void describe(Visitor& v, CalibrationOptions& o)
{
    v.about("How the fit is made.");
    v.integer({"starts", "starting points besides the prior's centre, to see whether fits differ"}, o.starts,
              {0, 1000, false});
    v.integer({"samples", "draws of the posterior (DRAM); 0: none"}, o.samples, {0, 1e6, false});
    v.number({"level", "probability of intervals and bands"}, o.level, {0.5, 0.999, false});
    v.quantity({"fixed_step", "time step of the model; 0: by accuracy"}, o.fixed_step, D::time, non_negative);
    v.flag({"profiles", "intervals are found by the profile of the likelihood, which takes several fits each"},
           o.profiles);
    v.path({"reduced", "the reduced model, where --reduced does not name it"}, o.reduced);
}

}  // namespace deadpoint::casefile
