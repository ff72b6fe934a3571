#include "deadpoint/casefile/describe/visitor.hpp"
#include "deadpoint/casefile/studies/study_file.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace deadpoint::casefile {
void describe(Visitor& v, StudyFile& f)
{
    v.about("The study file says which runs `deadpoint sweep` makes of a case, and what `deadpoint sensitivity` "
            "and `deadpoint optimise` vary. "
            "It is one TOML file; values of the case are written as for --set on the command line.");
    v.integer({"format", "version of this format; 1", required}, f.format, {1, 1, false});
    v.text({"name", "name in reports", required}, f.name);
    v.text({"note", "remarks for the reader"}, f.note);
    v.path({"base", "the case that is varied, relative to this file", required}, f.base);
    v.texts({"set", "changes to the case for all runs, each as for --set: \"operation.0.speed=300 rpm\""}, f.set);
    v.list({"sets", "sets of runs of a sweep; a run that belongs to several is computed once"}, f.sets);
    v.table({"limits", "allowed drift"}, f.limits);
    v.table({"sensitivity", "a study of sensitivity"}, f.sensitivity);
    v.table({"optimise", "a search for better values"}, f.optimise);
    v.expect(!f.sets.empty() || f.sensitivity || f.optimise, "sets", "the study has nothing to compute",
             "give `[[sets]]` for a sweep, `[sensitivity]` or `[optimise]`");
    v.expect(std::ranges::all_of(f.set, [](const auto& text) { return text.find('=') != std::string::npos; }), "set",
             "a setting is written path=value", "write it like \"operation.0.speed=300 rpm\"");
}

void describe(Visitor& v, StudySet& s)
{
    v.about(fmt::format("A set combines every step of every axis with every step of the other axes. A set without axes "
                        "is the base case. "
                        "All sets together may have {} points.",
                        most_study_points));
    v.text({"name", "name in reports and files", required}, s.name);
    v.list({"axes", "the quantities to vary"}, s.axes);
}

void describe(Visitor& v, StudyAxis& a)
{
    v.about("One key of the case, or several keys that change together, step by step.");
    v.text({"name", "name in tables and charts; default: the last word of its key"}, a.name);
    v.text({"key", "the key to vary, as for --set: \"operation.0.speed\""}, a.key);
    v.texts({"keys", "several keys instead of one"}, a.keys);
    v.settings({"values", "the steps. Each is one value, or with `keys` a list with one value for each key; a single "
                          "value holds for all keys"},
               a.values);
    v.setting({"from", "first step of a range of equal steps, instead of `values`: \"200 rpm\""}, a.from);
    v.setting({"to", "last step of the range, in the same unit"}, a.to);
    v.integer({"count", "number of steps, both ends included"}, a.count,
              {2, static_cast<double>(most_study_points), false});
    v.texts({"labels", "names of the steps in tables and charts, instead of their values"}, a.labels);
    v.expect(a.key.empty() != a.keys.empty(), a.key.empty() ? "" : "keys",
             a.key.empty() ? "the axis varies nothing" : "the axis has both `key` and `keys`",
             "give one of `key` and `keys`");
    const bool range = !a.from.empty() || !a.to.empty() || a.count != 0;
    const bool whole = !a.from.empty() && !a.to.empty() && a.count != 0;
    v.expect(!range || a.values.empty(), "values", "the axis has both `values` and a range",
             "give `values`, or `from`, `to` and `count`");
    v.expect(range || !a.values.empty(), "", "the axis has no steps", "give `values`, or `from`, `to` and `count`");
    v.expect(!range || whole, "", "the range is not complete", "give all of `from`, `to` and `count`");
}

void describe(Visitor& v, StudyLimits& l)
{
    v.about("Limits of the drift E_SW, opening or closing. With a limit the study finds in every set the widest "
            "window: neighbouring steps of each axis within which every run keeps the limits.");
    v.quantity({"largest", "limit of its largest magnitude"}, l.largest, Dimension::length, positive);
    v.quantity({"final", "limit of its magnitude at the end"}, l.final, Dimension::length, positive);
    v.expect(l.largest || l.final, "", "no limit is given", "give `largest`, `final` or both");
}

}  // namespace deadpoint::casefile
