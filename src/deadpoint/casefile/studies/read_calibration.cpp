#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/files/case_source.hpp"
#include "deadpoint/casefile/files/kind_of_file.hpp"
#include "deadpoint/casefile/files/numbers.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/studies/calibration_file.hpp"
#include "deadpoint/casefile/studies/measured_curves.hpp"
#include "deadpoint/casefile/syntax/reader.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/names/suggest.hpp"
#include "deadpoint/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <set>

namespace deadpoint::casefile {
namespace {

/// What is wrong with an error's text; nothing otherwise.
std::variant<double, QuantityProblem> plain_number(const std::string& text)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(value > 0) || !std::isfinite(value))
        return QuantityProblem{"not-a-number", fmt::format("'{}' is not a factor above 0", text),
                               "write it like lower = 0.1"};
    return value;
}

/// Dimension of a shift of a number.
Dimension shift_of(Dimension dimension)
{
    return dimension == Dimension::temperature ? Dimension::temperature_difference : dimension;
}

/// Checks what spans several values of the file, reads the cases of its runs and all curves.
class CalibrationChecker {
public:
    CalibrationChecker(CalibrationFile& file, const Document& document, Diagnostics& diagnostics,
                       const CalibratedCase& of, bool plan)
        : file_(file), document_(document), diagnostics_(diagnostics), of_(of), plan_(plan)
    {}

    void run()
    {
        base_ = read_base();
        unique("parameters", file_.parameters);
        unique("runs", file_.runs);
        unique("candidates", file_.candidates);
        unique("alternatives", file_.alternatives);
        for (std::size_t k = 0; k < file_.alternatives.size(); ++k)
            file_.alternatives[k].place = place_text(fmt::format("alternatives.{}.name", k));
        for (std::size_t k = 0; k < file_.parameters.size(); ++k)
            check_parameter(k);
        for (std::size_t k = 0; k < file_.parameters.size(); ++k)
            check_same_keys(k);
        for (std::size_t k = 0; k < file_.sensors.size(); ++k)
            check_sensor(k);
        if (diagnostics_.error_count() > 0)
            return;
        for (std::size_t k = 0; k < file_.runs.size(); ++k)
            read_run(k);
        check_use_of_sensors();
        for (std::size_t k = 0; k < file_.candidates.size(); ++k)
            check_candidate(k);
        if (diagnostics_.error_count() == 0)
            require_fitted_run();
    }

private:
    void report(std::string code, std::string path, std::string message, std::string help)
    {
        const Place place = place_of(document_.root, path);
        diagnostics_.add({Severity::error, std::move(code), place, std::move(path), std::move(message), std::move(help),
                          std::nullopt, ""});
    }

    [[nodiscard]] std::string place_text(const std::string& path) const
    {
        const Place place = place_of(document_.root, path);
        return place.file < 0 ? std::string() : fmt::format("{}:{}", diagnostics_.sources.name(place.file), place.line);
    }

    /// Mistakes of the case itself are listed as for a run.
    Case read_base() const { return read_case(of_.path, of_.overrides, of_.files).value; }

    template <class T>
    void unique(const std::string& list, const std::vector<T>& items)
    {
        std::set<std::string> names;
        for (std::size_t k = 0; k < items.size(); ++k)
            if (!names.insert(items[k].name).second)
                report("duplicate-name", fmt::format("{}.{}.name", list, k),
                       fmt::format("two {} are called '{}'", list, items[k].name), "give each its own name");
    }

    // ---------------------------------------------------------------- parameters

    void check_parameter(std::size_t k)
    {
        auto& p = file_.parameters[k];
        const std::string at = fmt::format("parameters.{}", k);
        p.place = place_text(at + ".name");
        try {
            p.keys = of_.keys_of(base_, p.keys);
        } catch (const InputError& error) {
            const auto said = split_help(error.what());
            return report("unknown-key", at + ".keys", said.message, said.help);
        }
        if (p.kind == CalibrationParameter::Kind::factor) {
            p.prior = std::log(p.factor);
            set_limits(p, at, plain_number, [](double value) { return std::log(value); });
        } else {
            check_shift(p, at);
        }
        if (p.least == 0 && p.most == 0)
            return;
        if (!(p.least < 0 && p.most > 0))
            report("prior", at + (p.lower.empty() ? ".upper" : ".lower"),
                   "the limits exclude the value that the case states, which is the likeliest one by the prior",
                   "widen the limits, or change the value in the case");
    }

    /// Two unknowns may share keys, such as a common factor beside one of each joint, but not all of them.
    void check_same_keys(std::size_t k)
    {
        const auto& p = file_.parameters[k];
        for (std::size_t i = 0; i < k; ++i) {
            const auto& other = file_.parameters[i];
            if (!p.keys.empty() && other.kind == p.kind && std::ranges::is_permutation(other.keys, p.keys))
                return report("duplicate-key", fmt::format("parameters.{}.keys", k),
                              fmt::format("'{}' changes the same values as '{}', so that no data can tell them apart",
                                          p.name, other.name),
                              "remove one of them, or give each its own keys");
        }
    }

    void check_shift(CalibrationParameter& p, const std::string& at)
    {
        const auto numbers = numbers_of(base_);
        std::set<Dimension> found;
        for (const auto& number : numbers)
            if (std::ranges::find(p.keys, number.path) != p.keys.end())
                found.insert(shift_of(number.dimension));
        if (found.size() != 1)
            return report("unit-mismatch", at + ".keys",
                          "the keys have different units, so that no one shift fits them",
                          "use several parameters, or kind = \"factor\"");
        p.dimension = *found.begin();
        const auto quantity = [&](const std::string& text) { return try_parse_quantity(text, p.dimension); };
        p.prior = number_of(quantity(p.sigma), at + ".sigma");
        if (!(p.prior > 0))
            report("out-of-range", at + ".sigma", "the uncertainty is not above zero", "write it like \"2 K\"");
        set_limits(p, at, quantity, [](double value) { return value; });
    }

    template <class Parse, class Change>
    void set_limits(CalibrationParameter& p, const std::string& at, const Parse& parse, const Change& change)
    {
        constexpr double none = 1e300;
        if (p.lower.empty() && p.upper.empty())
            return;
        p.least = p.lower.empty() ? -none : change(number_of(parse(p.lower), at + ".lower"));
        p.most = p.upper.empty() ? none : change(number_of(parse(p.upper), at + ".upper"));
    }

    double number_of(const std::variant<double, QuantityProblem>& found, const std::string& path)
    {
        if (const auto* problem = std::get_if<QuantityProblem>(&found)) {
            report(problem->code, path, problem->message, problem->help);
            return 1;
        }
        return std::get<double>(found);
    }

    // ---------------------------------------------------------------- sensors

    void check_sensor(std::size_t k)
    {
        auto& s = file_.sensors[k];
        const std::string at = fmt::format("sensors.{}", k);
        const auto as_temperature = try_parse_quantity(s.noise, Dimension::temperature_difference);
        const auto as_length = try_parse_quantity(s.noise, Dimension::length);
        s.dimension = std::holds_alternative<double>(as_length) ? Dimension::length : Dimension::temperature_difference;
        s.sigma = number_of(s.dimension == Dimension::length ? as_length : as_temperature, at + ".noise");
        if (!s.bias.empty())
            s.bias_sigma = number_of(try_parse_quantity(s.bias, s.dimension), at + ".bias");
        if (!s.model_error.empty())
            s.model_sigma = number_of(try_parse_quantity(s.model_error, s.dimension), at + ".model_error");
        if (s.model_sigma < 0)
            report("out-of-range", at + ".model_error", "the model error is below zero",
                   "state its size, such as \"0.3 K\"");
        if (!(s.sigma > 0))
            report("out-of-range", at + ".noise", "the noise is not above zero, so that the fit is singular",
                   "state how far two values of the same temperature may differ, such as \"0.1 K\"");
        if (s.bias_sigma < 0)
            report("out-of-range", at + ".bias", "the bias is below zero", "state its size, such as \"0.5 K\"");
    }

    void check_use_of_sensors()
    {
        for (const auto& run : file_.runs)
            for (const auto& curve : run.curves)
                used_.insert(curve.sensor);
        for (std::size_t k = 0; k < file_.sensors.size(); ++k) {
            check_units(k);
            if (!used_.contains(k) && !plan_ && diagnostics_.error_count() == 0)
                file_.notes.push_back(fmt::format("sensor {} ({}) belongs to no measured column", k,
                                                  fmt::join(file_.sensors[k].columns, ", ")));
        }
    }

    void check_units(std::size_t k)
    {
        for (const auto& run : file_.runs)
            for (const auto& curve : run.curves) {
                const auto expected = curve.of_gap ? Dimension::length : Dimension::temperature_difference;
                if (curve.sensor != k || file_.sensors[k].dimension == expected)
                    continue;
                return report("unit-mismatch", fmt::format("sensors.{}.noise", k),
                              fmt::format("'{}' of the run '{}' is {}, and the noise '{}' is not", curve.column,
                                          run.name, curve.of_gap ? "a length" : "a temperature",
                                          file_.sensors[k].noise),
                              "give temperatures and dimensions sensors of their own");
            }
    }

    // ---------------------------------------------------------------- runs

    /// @param before  settings ahead of these that are known to be right
    std::shared_ptr<const Case> read_with(const std::vector<std::string>& set, const std::string& at,
                                          const std::vector<std::string>& before = {})
    {
        auto overrides = of_.overrides;
        overrides.insert(overrides.end(), before.begin(), before.end());
        overrides.insert(overrides.end(), set.begin(), set.end());
        Diagnostics found;
        auto value = std::make_shared<Case>();
        const auto document = read_case(of_.path, overrides, *value, found, of_.files);
        const auto first = static_cast<int>(document.paths.size() - set.size());
        for (const auto& d : found.items())
            if (d.severity == Severity::error) {
                const bool own = d.place.file >= first;
                report(d.code, own ? fmt::format("{}.{}", at, d.place.file - first) : at,
                       fmt::format("the case refuses this setting: {}", d.message), d.help);
            }
        return found.error_count() == 0 ? value : nullptr;
    }

    /// The case of a run in each alternative.
    std::vector<std::shared_ptr<const Case>> read_alternatives(const std::vector<std::string>& set)
    {
        std::vector<std::shared_ptr<const Case>> result;
        for (std::size_t k = 0; k < file_.alternatives.size(); ++k)
            result.push_back(read_with(file_.alternatives[k].set, fmt::format("alternatives.{}.set", k), set));
        return result;
    }

    RunReport reporter(const std::string& at)
    {
        return [this, at](const std::string& key, const std::string& code, const std::string& message,
                          const std::string& help) { report(code, at + "." + key, message, help); };
    }

    void read_run(std::size_t k)
    {
        auto& run = file_.runs[k];
        const std::string at = fmt::format("runs.{}", k);
        run.input = read_with(run.set, at + ".set");
        if (!run.input)
            return;
        run.alternatives = read_alternatives(run.set);
        const bool has_values = !run.reference.empty() || !run.data.empty();
        if (has_values)
            run.curves = measured_curves(run, file_.sensors, reporter(at), file_.notes);
        else if (!plan_ && !run.hold_out)
            return report("no-values", at + ".name", fmt::format("the run '{}' has no measured values", run.name),
                          "give `reference` or `data`; without them the run can be planned (--plan) or predicted "
                          "(hold_out = true)");
        if (!has_values && run.measure.empty() && plan_)
            return report("no-values", at + ".name", fmt::format("the run '{}' measures nothing", run.name),
                          "give `measure`, such as [\"P1\", \"E_SW\"], or the file of its values");
        const auto planned = planned_curves(run.measure, run, file_.sensors, reporter(at));
        if (plan_)
            run.curves.insert(run.curves.end(), planned.begin(), planned.end());
    }

    void require_fitted_run()
    {
        const bool any =
            std::ranges::any_of(file_.runs, [](const auto& run) { return !run.hold_out && !run.curves.empty(); });
        if (!any)
            report("no-values", "runs", "no run is fitted: all are held out", "remove `hold_out` from a measured run");
    }

    void check_candidate(std::size_t k)
    {
        auto& c = file_.candidates[k];
        const std::string at = fmt::format("candidates.{}", k);
        std::vector<std::string> names;
        for (const auto& run : file_.runs)
            names.push_back(run.name);
        if (!c.run.empty() && std::ranges::find(names, c.run) == names.end()) {
            const auto near = closest_name(c.run, names);
            report("unknown-name", at + ".run", fmt::format("there is no run '{}'", c.run),
                   near.empty() ? fmt::format("the file has: {}", fmt::join(names, ", "))
                                : fmt::format("did you mean '{}'?", near));
        }
        CalibrationRun probe;
        probe.input = c.set.empty() ? std::make_shared<Case>(base_) : read_with(c.set, at + ".set");
        c.input = c.set.empty() ? nullptr : probe.input;
        if (c.input)
            c.alternatives = read_alternatives(c.set);
        if (probe.input)
            (void)planned_curves(c.measure, probe, file_.sensors, reporter(at));
    }

    CalibrationFile& file_;
    const Document& document_;
    Diagnostics& diagnostics_;
    const CalibratedCase& of_;
    bool plan_;
    Case base_;
    std::set<std::size_t> used_;
};

}  // namespace

CalibrationFile read_calibration(const std::filesystem::path& path, const CalibratedCase& of, bool plan)
{
    Diagnostics diagnostics;
    const Document document = load_document(path, {}, diagnostics, FileAccess::anywhere);
    if (diagnostics.error_count() == 0) {
        require_kind(document, KindOfFile::calibration, diagnostics);
    }
    stop_at_errors(diagnostics, "the calibration file; nothing was computed");
    CalibrationFile file;
    Reader(document, diagnostics, nullptr).read(file);
    stop_at_errors(diagnostics, "the calibration file; nothing was computed");
    CalibrationChecker(file, document, diagnostics, of, plan).run();
    stop_at_errors(diagnostics, "the calibration file; nothing was computed");
    return file;
}

}  // namespace deadpoint::casefile
