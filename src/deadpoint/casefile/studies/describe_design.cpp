#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/casefile/studies/design_section.hpp"

#include <algorithm>
#include <array>
#include <functional>

namespace deadpoint::casefile {
namespace {

constexpr std::array<std::string_view, 2> methods{"sobol", "morris"};
constexpr std::array<std::string_view, 3> objectives{"drift", "warm-up", "ambient"};
constexpr std::array<std::string_view, 3> optimisers{"slsqp", "ccsa", "cobyla"};

}  // namespace

void describe(Visitor& v, VariedKeys& k)
{
    v.about("Keys of the case that change together within a range: a `factor`, a `shift`, or `from` and `to`.");
    v.text({"name", "name in tables and charts; default: the last word of its first key"}, k.name);
    v.texts({"keys",
             "keys of the case, as for --set; `*` stands for any characters: \"oil.*\". Items of lists are named by "
             "number or by their name",
             required},
            k.keys);
    v.number({"factor", "the range is from 1/factor to factor times the value of the case; all ratios are equally "
                        "likely"},
             k.factor, {1, 1000, true});
    v.setting({"shift", "the range is from the value less shift to the value plus shift: \"3 K\""}, k.shift);
    v.setting({"from", "least value, instead of that of the case: \"250 rpm\""}, k.from);
    v.setting({"to", "largest value"}, k.to);
    const int ways = (k.factor > 0 ? 1 : 0) + (k.shift.empty() ? 0 : 1) + (k.from.empty() && k.to.empty() ? 0 : 1);
    v.expect(ways == 1, "", ways == 0 ? "the range is missing" : "the range is given twice",
             "give `factor`, or `shift`, or `from` and `to`");
    v.expect(k.from.empty() == k.to.empty(), "", "the range has one end only", "give both `from` and `to`");
}

void describe(Visitor& v, SensitivitySection& s)
{
    v.about("What `deadpoint sensitivity` computes: which parameters matter for which output, when all of them vary "
            "together within their ranges.");
    v.choice({"method", "`sobol`: shares of the variance; `morris`: a screening with few runs"}, s.method_name,
             methods);
    v.integer({"points",
               "rows of the design for Sobol' indices, best a power of two; there are points x (parameters + 2) runs"},
              s.points, {8, 65536, false});
    v.integer({"trajectories", "trajectories of Morris screening; there are trajectories x (parameters + 1) runs"},
              s.trajectories, {2, 10000, false});
    v.integer({"seed", "of the random numbers; the same seed gives the same points"}, s.seed, {0, 2147483647, false});
    v.integer({"gradients", "points at which derivatives are also computed, for an upper bound of each total index; "
                            "0: none"},
              s.gradients, {0, 4096, false});
    v.texts({"outputs", "dimensions of the chain (\"E_SW\"), probes and \"corner ...\"; `*` stands for any characters; "
                        "default: E_SW and all probes"},
            s.outputs);
    v.quantities({"times", "times of figures besides the end of the run"}, s.times, Dimension::time, positive);
    v.integer({"course_times", "number of times, evenly over the run, of the indices over time; 0: none"},
              s.course_times, {0, 1000, false});
    v.flag({"samples", "also write all points with their figures, as samples.csv"}, s.samples);
    v.list({"parameters", "what varies", required}, s.parameters);
    v.expect(!s.parameters.empty(), "parameters", "nothing varies", "list at least one parameter");
}

void describe(Visitor& v, SpeedProfile& p)
{
    v.about("A speed for each interval from the start of a segment, as variables; behind the last interval the segment "
            "keeps its own speed.");
    v.integer({"segment", "segment of the operation, counted from 0"}, p.segment, {0, 9999, false});
    v.quantities(
        {"ends", "ends of the intervals from the start of the segment, ascending: [\"20 min\", \"1 h\"]", required},
        p.ends, Dimension::time, positive);
    v.quantity({"from", "least speed", required}, p.least, Dimension::angular_velocity, positive);
    v.quantity({"to", "largest speed", required}, p.most, Dimension::angular_velocity, positive);
    v.quantity({"least_mean", "least mean speed over the intervals"}, p.least_mean, Dimension::angular_velocity,
               positive);
    v.expect(p.least < p.most, "to", "the range has no extent", "let `from` be less than `to`");
    v.expect(std::ranges::is_sorted(p.ends, std::less_equal<>()), "ends", "the ends do not ascend",
             "give each interval an end after the one before");
}

void describe(Visitor& v, OptimiseLimit& l)
{
    v.about("A limit of an output at all times: `most`, `least` or both.");
    v.text({"output", "probe, dimension of the chain or corner", required}, l.output);
    v.setting({"most", "largest allowed value: \"60 degC\" of a probe, \"80 um\" of a dimension"}, l.most);
    v.setting({"least", "least allowed value"}, l.least);
    v.quantity({"from", "from this time of the run on"}, l.from, Dimension::time, non_negative);
    v.expect(!l.most.empty() || !l.least.empty(), "", "no limit is given", "give `most`, `least` or both");
}

void describe(Visitor& v, OptimiseSection& s)
{
    v.about("What `deadpoint optimise` looks for: the variables within their limits that make the objective least.");
    v.choice({"objective",
              "`drift`: root mean square of the change of E_SW since `from`; `warm-up`: time from which E_SW "
              "changes more slowly than `rate`; `ambient`: root mean square from `from` on of the change of "
              "E_SW per kelvin of the ambient"},
             s.objective_name, objectives);
    v.quantity({"from", "time from which drift and ambient count"}, s.from, Dimension::time, non_negative);
    v.quantity({"rate", "rate of E_SW below which the press is warm; default: drift_rate_limit of the chain"}, s.rate,
               Dimension::velocity, non_negative);
    v.quantity({"ambient_step", "change of the ambient up and down by which its effect is computed"}, s.ambient_step,
               Dimension::temperature_difference, positive);
    v.quantity({"warm_within", "latest time to warm that is allowed, by `rate`"}, s.warm_within, Dimension::time,
               positive);
    v.choice({"method", "`slsqp` and `ccsa` use derivatives, `cobyla` does not"}, s.method_name, optimisers);
    v.integer({"starts", "number of starts: the case itself, then points spread over the ranges"}, s.starts,
              {1, 1000, false});
    v.integer({"evaluations", "most evaluations per start"}, s.evaluations, {1, 10000, false});
    v.integer({"seed", "of the starts"}, s.seed, {0, 2147483647, false});
    v.quantity({"step", "time step of the runs, which is fixed so that results change smoothly"}, s.step,
               Dimension::time, positive);
    v.table({"speed_profile", "speeds at the start of a segment"}, s.speed_profile);
    v.list({"variables", "further variables; their ranges are their limits"}, s.variables);
    v.list({"limits", "limits of outputs"}, s.limits);
    v.expect(s.speed_profile || !s.variables.empty(), "", "nothing may change",
             "give [[optimise.variables]] or [optimise.speed_profile]");
}

}  // namespace deadpoint::casefile
