#include "deadpoint/tribology/friction/lubricant.hpp"

#include "deadpoint/core/units.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/tribology/arguments.hpp"
#include "deadpoint/tribology/units.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>
#include <utility>

namespace deadpoint::tribology {
namespace {

constexpr double walther_shift = 0.7;          // [mm2/s]
constexpr double walther_least = 2;            // [mm2/s]; below it D341 adds terms
constexpr double range_rounding = 0.05;        // [K]; a press that starts at the first point is not outside the range
constexpr double tested_density_change = 0.1;  // share of the density

// Value of a law; throws if the value is outside the range in which oil flows.
LawValue flowing(const LawValue& viscosity, double temperature, const char* law)
{
    if (viscosity.value >= thinnest_oil && viscosity.value <= stiffest_oil)
        return viscosity;
    throw DomainError(fmt::format("viscosity: at {:.1f} degC {} gives {:.2g} mm2/s, and what lubricates has {:.1f} to "
                                  "{:.0e} mm2/s\n  help: state the oil near that temperature too (`viscosity`), or "
                                  "check why a joint gets there",
                                  temperature - zero_celsius, law, viscosity.value / square_millimetre,
                                  thinnest_oil / square_millimetre, stiffest_oil / square_millimetre));
}

bool within(const TemperatureRange& range, double temperature)
{
    return temperature >= range.lowest - range_rounding && temperature <= range.highest + range_rounding;
}

double walther_ordinate(double viscosity)
{
    return std::log10(std::log10(viscosity / square_millimetre + walther_shift));
}

void check_point(const ViscosityPoint& point)
{
    require_positive("viscosity point: temperature [K]", point.temperature);
    require_positive("viscosity point: viscosity [m2/s]", point.viscosity);
    if (point.viscosity <= (1 - walther_shift) * square_millimetre)
        throw InputError(fmt::format("viscosity point: {} m2/s is too thin for ASTM D341, which ends at 0.3 mm2/s\n  "
                                     "help: give a table of viscosity over temperature",
                                     point.viscosity));
}

}  // namespace

ViscosityCurve::ViscosityCurve(std::vector<double> temperature, std::vector<double> viscosity)
    : temperature_(std::move(temperature)), log_viscosity_(std::move(viscosity))
{
    if (temperature_.size() != log_viscosity_.size() || temperature_.size() < 2)
        throw InputError(
            fmt::format("viscosity curve: {} temperatures and {} viscosities; give as many of both, two at least",
                        temperature_.size(), log_viscosity_.size()));
    for (std::size_t i = 0; i < temperature_.size(); ++i) {
        if (i > 0 && !(temperature_[i] > temperature_[i - 1]))
            throw InputError(fmt::format("viscosity curve: temperatures must increase, but {} K follows {} K",
                                         temperature_[i], temperature_[i - 1]));
        if (!(log_viscosity_[i] > 0) || !std::isfinite(log_viscosity_[i]))
            throw InputError(
                fmt::format("viscosity curve: {} m2/s at {} K is not positive", log_viscosity_[i], temperature_[i]));
        log_viscosity_[i] = std::log(log_viscosity_[i]);
    }
}

LawValue ViscosityCurve::operator()(double temperature) const
{
    const auto above = std::upper_bound(temperature_.begin() + 1, temperature_.end() - 1, temperature);
    const auto i = static_cast<std::size_t>(above - temperature_.begin());
    const double slope = (log_viscosity_[i] - log_viscosity_[i - 1]) / (temperature_[i] - temperature_[i - 1]);
    const double value = std::exp(log_viscosity_[i - 1] + slope * (temperature - temperature_[i - 1]));
    const bool in_range = within({temperature_.front(), temperature_.back()}, temperature);
    const LawValue result{value, slope * value, in_range};
    return in_range ? result : flowing(result, temperature, "the end slope of its table");
}

Walther walther_through(const ViscosityPoint& colder, const ViscosityPoint& warmer, TemperatureRange range)
{
    check_point(colder);
    check_point(warmer);
    const double run = std::log10(warmer.temperature / colder.temperature);
    const double fall = walther_ordinate(colder.viscosity) - walther_ordinate(warmer.viscosity);
    if (!(fall / run > 0) || !std::isfinite(fall / run))
        throw InputError(
            fmt::format("viscosity: {} m2/s at {} K and {} m2/s at {} K do not fall with temperature\n  help: "
                        "give two states of one oil at different temperatures",
                        colder.viscosity, colder.temperature, warmer.viscosity, warmer.temperature));
    const double b = fall / run;
    return {walther_ordinate(colder.viscosity) + b * std::log10(colder.temperature), b, range};
}

ViscosityLaw walther_viscosity(const Walther& line)
{
    require_positive("Walther line: b", line.b);
    if (!std::isfinite(line.a))
        throw InputError(fmt::format("Walther line: a is {}, which is no number", line.a));
    return [line](double temperature) {
        require_positive_state("oil temperature [K]", temperature);
        const double inner = std::pow(10.0, line.a - line.b * std::log10(temperature));
        const double shifted = std::pow(10.0, inner);
        const double viscosity = shifted - walther_shift;
        const double slope = -shifted * std::numbers::ln10 * inner * line.b / temperature;
        return flowing({viscosity * square_millimetre, slope * square_millimetre,
                        within(line.range, temperature) && viscosity >= walther_least},
                       temperature, "the line of ASTM D341");
    };
}

ViscosityLaw vogel_viscosity(const Vogel& formula)
{
    require_positive("Vogel formula: factor [m2/s]", formula.factor);
    require_positive("Vogel formula: b [K]", formula.b);
    if (!(formula.pole < formula.range.lowest))
        throw InputError(fmt::format("Vogel formula: its pole at {} K must lie below the range, which begins at {} K",
                                     formula.pole, formula.range.lowest));
    return [formula](double temperature) {
        const double above = temperature - formula.pole;
        require_positive_state("oil temperature above the pole of Vogel's formula [K]", above);
        const double viscosity = formula.factor * std::exp(formula.b / above);
        return flowing({viscosity, -viscosity * formula.b / (above * above), within(formula.range, temperature)},
                       temperature, "Vogel's formula");
    };
}

DensityLaw linear_density(const OilDensity& oil)
{
    require_positive("oil density [kg/m3]", oil.density);
    require_positive("temperature of the oil density [K]", oil.temperature);
    require_not_negative("expansion of the oil [1/K]", oil.expansion);
    return [oil](double temperature) {
        const double change = -oil.expansion * (temperature - oil.temperature);
        const double density = oil.density * (1 + change);
        require_positive_state("oil density [kg/m3]", density);
        return LawValue{density, -oil.density * oil.expansion, std::abs(change) <= tested_density_change};
    };
}

ViscosityLaw dynamic_viscosity(const Lubricant& lubricant)
{
    if (!lubricant.viscosity || !lubricant.density)
        throw InputError("lubricant: a film needs viscosity and density\n  help: give both");
    return [lubricant](double temperature) {
        const LawValue nu = lubricant.viscosity(temperature);
        const LawValue rho = lubricant.density(temperature);
        return LawValue{rho.value * nu.value, rho.value * nu.slope + rho.slope * nu.value, nu.in_range && rho.in_range};
    };
}

const std::array<IsoVgGrade, 11>& iso_vg_grades()
{
    static constexpr std::array<IsoVgGrade, 11> grades{{
        {10, 10e-6, 2.65e-6, 850},
        {15, 15e-6, 3.4e-6, 855},
        {22, 22e-6, 4.3e-6, 865},
        {32, 32e-6, 5.4e-6, 870},
        {46, 46e-6, 6.8e-6, 875},
        {68, 68e-6, 8.7e-6, 880},
        {100, 100e-6, 11.1e-6, 885},
        {150, 150e-6, 14.7e-6, 890},
        {220, 220e-6, 19.0e-6, 895},
        {320, 320e-6, 24.0e-6, 900},
        {460, 460e-6, 30.6e-6, 905},
    }};
    return grades;
}

IsoVgGrade iso_vg_grade(int grade)
{
    std::vector<int> known;
    for (const IsoVgGrade& entry : iso_vg_grades()) {
        if (entry.grade == grade)
            return entry;
        known.push_back(entry.grade);
    }
    throw InputError(
        fmt::format("there is no oil of grade ISO VG {}\n  help: use one of {}, or give the oil's viscosity "
                    "at two temperatures",
                    grade, fmt::join(known, ", ")));
}

Lubricant iso_vg_oil(int grade)
{
    const IsoVgGrade oil = iso_vg_grade(grade);
    const Walther line = walther_through({zero_celsius + 40, oil.at_40}, {zero_celsius + 100, oil.at_100});
    return {walther_viscosity(line), linear_density({oil.density})};
}

}  // namespace deadpoint::tribology
