#include "deadpoint/casefile/describe/choose.hpp"
#include "deadpoint/casefile/studies/reference_file.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <initializer_list>

namespace deadpoint::casefile {
namespace {

using D = Dimension;

void describe_note(Visitor& v, ReferenceNote& n)
{
    v.text({"point", "operating point of [points] to which it belongs; without it, the unchanged case"}, n.point);
    v.text({"note", "shown beside the comparison"}, n.note);
}

void describe_value(Visitor& v, ReferenceValue& n)
{
    v.text({"group", "values with the same group name form a separate set with its own error figures"}, n.group);
    v.flag({"calibrated", "a parameter was fitted to this value; it is then reported separately. This holds even if "
                          "the case does not say so"},
           n.calibrated);
    describe_note(v, n);
}

/// A key belongs to some kinds only; it is needed there, or allowed.
template <class E>
struct KindKeys {
    Visitor& v;
    std::string_view chooser;
    std::optional<E> kind;

    void allowed(bool given, std::string_view key, std::initializer_list<E> kinds) const
    {
        v.expect(!given || !kind || is(kinds), key, fmt::format("{} does not use '{}'", stated(), key),
                 fmt::format("remove it, or take another `{}`", chooser));
    }
    void needed(bool given, std::string_view key, std::initializer_list<E> kinds) const
    {
        allowed(given, key, kinds);
        v.expect(given || !is(kinds), chooser, fmt::format("'{}' is missing for {}", key, stated()),
                 fmt::format("add `{}`", key));
    }
    [[nodiscard]] bool is(std::initializer_list<E> kinds) const
    {
        return kind && std::ranges::find(kinds, *kind) != kinds.end();
    }
    [[nodiscard]] std::string stated() const { return fmt::format("{} = \"{}\"", chooser, kind ? name_of(*kind) : ""); }
};

}  // namespace

void describe(Visitor& v, ReferenceFile& f)
{
    v.about("Measured or published values that `deadpoint compare` compares with a result. The model does not use "
            "them. The file is TOML, with the same rules as a case: every quantity is text with its unit.");
    v.integer({"format", "version of this format; 1", required}, f.format, {1, 1, false});
    v.text({"name", "name in reports", required}, f.name);
    v.text({"source", "where the values are from", required}, f.source);
    v.text({"note", "remarks for the reader"}, f.note);
    v.named({"points", "other operating points for which the file has values"}, f.points, "name");
    v.list({"rises", "temperature rises at one time"}, f.rises);
    v.list({"curves", "columns of CSV files"}, f.curves);
    v.list({"chain", "changes of the dimension chain"}, f.chain);
    v.list({"times", "times of events"}, f.times);
    v.list({"loads", "figures of loads.json"}, f.loads);
    v.list({"claims", "statements in words"}, f.claims);
    const bool empty = f.rises.empty() && f.curves.empty() && f.chain.empty() && f.times.empty() && f.loads.empty() &&
                       f.claims.empty();
    v.expect(!empty, "", "there is nothing to compare",
             "add one of [[rises]], [[curves]], [[chain]], [[times]], [[loads]] and [[claims]]");
}

void describe(Visitor& v, ReferencePoint& p)
{
    v.about("An operating point other than that of the case. `deadpoint compare --point NAME` uses the values that "
            "name it, and warns if the result was computed with other settings.");
    v.text({"description", "for reports"}, p.description);
    v.texts({"set", "differences from the case, each as for --set: \"operation.0.speed=300 rpm\"", required}, p.set);
    v.expect(std::ranges::all_of(p.set, [](const auto& text) { return text.find('=') != std::string::npos; }), "set",
             "a setting is written path=value", "write it like \"operation.0.speed=300 rpm\"");
}

void describe(Visitor& v, ReferenceRises& r)
{
    v.about("Rises of several probes over the initial temperature, at one time of the run.");
    v.quantity({"time", "time at which they were read", required}, r.time, D::time, non_negative);
    v.quantities({"values", "rise by probe", required}, r.values, D::temperature_difference);
    describe_value(v, r);
}

void describe(Visitor& v, ReferenceCurve& c)
{
    v.about("A column of a CSV file over time. The file begins with a line of column names, with units in brackets if "
            "`unit` and `time_unit` do not state them: `time [s],top [degC]`. Times increase; every cell is a number.");
    v.text({"name", "name in reports; default: column and file"}, c.name);
    v.path({"file", "CSV file, relative to the file that names it", required}, c.file);
    v.text({"column", "the values", required}, c.column);
    v.text({"time_column", "the times"}, c.time_column);
    v.text({"unit", "unit of the values, instead of that in the heading"}, c.unit);
    v.text({"time_unit", "unit of the times, instead of that in the heading"}, c.time_unit);
    choose(v, {"measures", "temperature or rise of a probe, or a dimension of the chain", required}, c.measures);
    v.text({"probe", "probe to which the temperature or rise belongs"}, c.probe);
    v.quantity({"until", "rows after this time are left out"}, c.until, D::time, positive);
    v.flag({"opposite_sign", "for a dimension: the file has the opposite sign"}, c.opposite_sign);
    describe_value(v, c);
    using enum ReferenceCurve::Measures;
    const KindKeys<ReferenceCurve::Measures> keys{v, "measures", c.measures};
    keys.needed(!c.probe.empty(), "probe", {temperature, rise});
    keys.allowed(c.opposite_sign, "opposite_sign", {E_SW, E_BG, E_WG, E_CS, E_BC});
}

void describe(Visitor& v, ReferenceChain& c)
{
    v.about("A change of the dimension chain since the start. E_SW > 0 opens the gap between slide and table; state "
            "`opposite_sign` if the source has the opposite sign.");
    choose(v, {"dimension", "dimension of the chain", required}, c.dimension, {"E_SW", "E_BG", "E_WG", "E_CS", "E_BC"});
    choose(v,
           {"at", "`time`: at that time; `largest`: where it is largest in magnitude; `end`: at the end of the run",
            required},
           c.at);
    v.quantity({"time", "for at = \"time\""}, c.time, D::time, non_negative);
    v.quantity({"value", "value with the sign of the source", required}, c.value, D::length, any_value);
    v.flag({"opposite_sign", "the source has the opposite sign"}, c.opposite_sign);
    describe_value(v, c);
    KindKeys<ReferenceChain::At>{v, "at", c.at}.needed(c.time.has_value(), "time", {ReferenceChain::At::time});
}

void describe(Visitor& v, ReferenceTime& t)
{
    v.about("The time of an event, counted from the start of the run.");
    choose(v,
           {"of",
            "`largest_E_SW`: E_SW is largest in magnitude; `share_of_rise`: from then on a probe has at least this "
            "share of its rise at the end",
            required},
           t.of);
    v.text({"probe", "probe, for `share_of_rise`"}, t.probe);
    v.number({"share", "share, for `share_of_rise`"}, t.share, {0, 1, true});
    v.quantity({"value", "the time", required}, t.value, D::time, non_negative);
    describe_value(v, t);
    KindKeys<ReferenceTime::Of>{v, "of", t.of}.needed(!t.probe.empty(), "probe", {ReferenceTime::Of::share_of_rise});
}

void describe(Visitor& v, ReferenceLoad& l)
{
    v.about("A figure of loads.json, given by its path. It is skipped if the result has no loads.");
    v.text({"quantity",
            "path in loads.json with points between the names, like "
            "\"crankshaft.rigid.seats.front.peak_y_N\"",
            required},
           l.quantity);
    v.quantity({"force", "its value"}, l.force, D::force, any_value);
    v.quantity({"length", "its value"}, l.length, D::length, any_value);
    v.quantity({"power", "its value"}, l.power, D::power, any_value);
    v.quantity({"number", "its value, if it has another unit (as in its name) or none"}, l.number, D::none, any_value);
    describe_value(v, l);
    const int given = (l.force ? 1 : 0) + (l.length ? 1 : 0) + (l.power ? 1 : 0) + (l.number ? 1 : 0);
    v.expect(given == 1, "", "the figure needs one value", "give one of `force`, `length`, `power` and `number`");
}

void describe(Visitor& v, ReferenceClaim& c)
{
    v.about("A statement in words, in a form that the program can check. Times to a share of the rise refer to the "
            "rise at the end of the run, so they mean little in a run that is too short for equilibrium.");
    v.text({"text", "the statement", required}, c.text);
    choose(v,
           {"kind",
            "`hottest`: one of `probes` is the warmest of all; `warmer`: each of `probes` is warmer than each of "
            "`than`; `slower`: each of `probes` takes longer than each of `than` for a share of its rise; `steady`: "
            "the last of `probes` (or of all) reaches that share between `at_least` and `at_most`; `share_reached`: "
            "each of `probes` has at least that share of its rise at `time`; `peak_within`: E_SW is largest between "
            "`at_least` and `at_most`; `declines`: at the end E_SW is less than `share` of its largest value; `slows`: "
            "E_SW moves faster before `time` than after it; `closes`, `opens`: the sign of E_SW where it is largest; "
            "`unchecked`: one run cannot show it, for the `reason` given",
            required},
           c.kind);
    v.texts({"probes", "names of probes"}, c.probes);
    v.texts({"than", "the probes to compare with"}, c.than);
    v.quantity({"time", "time of the statement; default: the end of the run"}, c.time, D::time, positive);
    v.quantity({"at_least", "earliest time"}, c.at_least, D::time, non_negative);
    v.quantity({"at_most", "latest time"}, c.at_most, D::time, non_negative);
    v.quantity({"share", "share of the rise at the end (default 0.95) or of the largest E_SW (default 1)"}, c.share,
               D::none, {0, 1, false});
    v.text({"reason", "reason why it is not checked"}, c.reason);
    describe_note(v, c);
    using enum ReferenceClaim::Kind;
    const KindKeys<ReferenceClaim::Kind> keys{v, "kind", c.kind};
    keys.needed(!c.than.empty(), "than", {warmer, slower});
    if (keys.is({steady})) {
        keys.allowed(!c.probes.empty(), "probes", {steady});
    } else {
        keys.needed(!c.probes.empty(), "probes", {hottest, warmer, slower, share_reached});
    }
    if (keys.is({hottest, warmer})) {
        keys.allowed(c.time.has_value(), "time", {hottest, warmer});
    } else {
        keys.needed(c.time.has_value(), "time", {share_reached, slows});
    }
    keys.allowed(c.at_least.has_value(), "at_least", {steady, peak_within});
    keys.allowed(c.at_most.has_value(), "at_most", {steady, peak_within});
    keys.allowed(c.share.has_value(), "share", {slower, steady, share_reached, declines});
    keys.needed(!c.reason.empty(), "reason", {unchecked});
    v.expect(!keys.is({steady, peak_within}) || c.at_least || c.at_most, "kind", "the claim names no time to check",
             "add `at_least` or `at_most`");
    v.expect(!c.at_least || !c.at_most || *c.at_least <= *c.at_most, "at_most",
             "the latest time lies before the earliest", "exchange `at_least` and `at_most`");
}

}  // namespace deadpoint::casefile
