#include "deadpoint/casefile/studies/reference_file.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/press/compare/compare.hpp"
#include "deadpoint/press/drift/drift_summary.hpp"
#include "deadpoint/press/run/run_record.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>
#include <utility>

namespace deadpoint::press {
namespace {

using casefile::ReferenceClaim;
using ProbeValues = std::vector<std::pair<std::string, double>>;  ///< probe and its value

constexpr double usual_share = 0.95;

std::string hours(double time) { return fmt::format("{:.4g} h", time / 3600); }
std::string micrometres(double length) { return fmt::format("{:+.4g} um", micrometre * length); }

std::string listed(const ProbeValues& values, const auto& show)
{
    std::string text;
    for (const auto& [name, value] : values) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", name, show(value));
    }
    return text;
}

class Judge {
public:
    Judge(const RunRecord& run, const ReferenceClaim& claim) : run_(run), claim_(claim)
    {
        verdict_.text = claim.text;
        verdict_.kind = casefile::name_of(*claim.kind);
        verdict_.note = claim.note;
    }

    Verdict run()
    {
        using enum casefile::ReferenceClaim::Kind;
        switch (*claim_.kind) {
        case hottest:
            judge_hottest();
            break;
        case warmer:
            judge_warmer();
            break;
        case slower:
            judge_slower();
            break;
        case steady:
            judge_steady();
            break;
        case share_reached:
            judge_share_reached();
            break;
        case peak_within:
            judge_peak_within();
            break;
        case declines:
            judge_declines();
            break;
        case slows:
            judge_slows();
            break;
        case closes:
        case opens:
            judge_direction();
            break;
        case unchecked:
            judge_unchecked();
            break;
        }
        return std::move(verdict_);
    }

private:
    void decide(bool holds, std::string evidence)
    {
        verdict_.outcome = holds ? Verdict::Outcome::holds : Verdict::Outcome::fails;
        verdict_.evidence = std::move(evidence);
    }

    [[nodiscard]] double time() const { return claim_.time.value_or(run_.time.back()); }
    [[nodiscard]] double share() const { return claim_.share.value_or(usual_share); }
    [[nodiscard]] const std::vector<double>& gap() const { return run_.chain.at("E_SW"); }
    [[nodiscard]] double rise(const std::string& probe, double at) const
    {
        return value_at(run_, run_.rises.at(probe), at);
    }

    [[nodiscard]] ProbeValues rises(const std::vector<std::string>& probes) const
    {
        ProbeValues result;
        for (const auto& probe : probes) {
            result.emplace_back(probe, rise(probe, time()));
        }
        return result;
    }
    [[nodiscard]] ProbeValues times_to_share(const std::vector<std::string>& probes) const
    {
        ProbeValues result;
        for (const auto& probe : probes) {
            result.emplace_back(probe, time_to_share(run_.time, run_.rises.at(probe), share()));
        }
        return result;
    }

    /// Checks whether every value of the first is larger than every value of the second.
    void order(const ProbeValues& first, const ProbeValues& second, const char* greater, const std::string& when,
               const auto& show)
    {
        const auto by_value = [](const auto& v) { return v.second; };
        const auto least = std::ranges::min_element(first, {}, by_value);
        const auto most = std::ranges::max_element(second, {}, by_value);
        decide(least->second > most->second,
               fmt::format("{}: {}; to be {} than {}", when, listed(first, show), greater, listed(second, show)));
    }

    void judge_hottest()
    {
        auto all = rises(run_.probes);
        std::ranges::stable_sort(all, [](const auto& a, const auto& b) { return a.second > b.second; });
        const bool holds = std::ranges::find(claim_.probes, all.front().first) != claim_.probes.end();
        all.resize(std::min<std::size_t>(all.size(), 3));
        decide(holds, fmt::format("warmest after {}: {}", hours(time()),
                                  listed(all, [](double rise) { return fmt::format("{:.2f} K", rise); })));
    }

    void judge_warmer()
    {
        order(rises(claim_.probes), rises(claim_.than), "warmer", "rises after " + hours(time()),
              [](double rise) { return fmt::format("{:.2f} K", rise); });
    }

    void judge_slower()
    {
        order(times_to_share(claim_.probes), times_to_share(claim_.than), "later",
              fmt::format("{:.3g} % of the rise at the end after", 100 * share()), hours);
    }

    /// Whether a time lies between the claim's limits, and the limits as text.
    [[nodiscard]] bool within(double time) const
    {
        const double slack = 1e-9 * run_.time.back();
        return time >= claim_.at_least.value_or(0) - slack &&
               time <= claim_.at_most.value_or(std::numeric_limits<double>::infinity()) + slack;
    }
    [[nodiscard]] std::string limits() const
    {
        if (claim_.at_least && claim_.at_most) {
            return fmt::format("claimed between {} and {}", hours(*claim_.at_least), hours(*claim_.at_most));
        }
        return claim_.at_least ? "claimed not before " + hours(*claim_.at_least)
                               : "claimed by " + hours(*claim_.at_most);
    }

    void judge_steady()
    {
        const auto times = times_to_share(claim_.probes.empty() ? run_.probes : claim_.probes);
        const auto last = std::ranges::max_element(times, {}, [](const auto& t) { return t.second; });
        decide(within(last->second),
               fmt::format("the last is {}, which has {:.3g} % of its rise at the end after {}; {}", last->first,
                           100 * share(), hours(last->second), limits()));
    }

    void judge_share_reached()
    {
        ProbeValues shares;
        for (const auto& probe : claim_.probes) {
            const double end = run_.rises.at(probe).back();
            shares.emplace_back(probe, end == 0 ? 0 : rise(probe, time()) / end);
        }
        decide(std::ranges::all_of(shares, [&](const auto& s) { return s.second >= share(); }),
               fmt::format("share of the rise at the end after {}: {}; claimed {:.3g} % or more", hours(time()),
                           listed(shares, [](double s) { return fmt::format("{:.1f} %", 100 * s); }), 100 * share()));
    }

    void judge_peak_within()
    {
        const double when = run_.time[largest_gap_row(run_)];
        decide(within(when), fmt::format("E_SW is largest, {}, after {}; {}", micrometres(gap()[largest_gap_row(run_)]),
                                         hours(when), limits()));
    }

    void judge_declines()
    {
        const double peak = gap()[largest_gap_row(run_)];
        const double limit = claim_.share.value_or(1);
        decide(std::abs(gap().back()) < limit * std::abs(peak),
               fmt::format("E_SW is {} where it is largest and {} at the end", micrometres(peak),
                           micrometres(gap().back())));
    }

    void judge_slows()
    {
        const double middle = value_at(run_, gap(), time());
        const double rest = run_.time.back() - time();
        if (rest <= 0) {
            verdict_.evidence = fmt::format("the run ends after {}", hours(run_.time.back()));
            return;
        }
        const double before = (middle - gap().front()) / time();
        const double after = (gap().back() - middle) / rest;
        const auto per_hour = [](double rate) { return micrometres(3600 * rate) + "/h"; };
        decide(std::abs(before) > std::abs(after), fmt::format("E_SW moves by {} on average until {}, by {} after",
                                                               per_hour(before), hours(time()), per_hour(after)));
    }

    void judge_direction()
    {
        const double peak = gap()[largest_gap_row(run_)];
        decide(claim_.kind == casefile::ReferenceClaim::Kind::closes ? peak < 0 : peak > 0,
               fmt::format("E_SW is {} where it is largest (above zero it opens)", micrometres(peak)));
    }

    void judge_unchecked() { verdict_.evidence = claim_.reason; }

    const RunRecord& run_;
    const ReferenceClaim& claim_;
    Verdict verdict_;
};

}  // namespace

Verdict judge(const RunRecord& run, const casefile::ReferenceClaim& claim) { return Judge(run, claim).run(); }

}  // namespace deadpoint::press
