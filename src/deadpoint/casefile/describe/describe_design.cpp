#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/casefile/files/design_section.hpp"

#include <array>

namespace deadpoint::casefile {
namespace {

constexpr Need required = Need::required;
constexpr std::array<std::string_view, 2> methods{"sobol", "morris"};

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

}  // namespace deadpoint::casefile
