#include "deadpoint/tribology/calibrated.hpp"

#include "deadpoint/core/error.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace deadpoint::tribology {
namespace {

constexpr double square_millimetre = 1e-6;

double viscous_speed_exponent(FrictionKind kind) { return kind == FrictionKind::rolling ? 5.0 / 3.0 : 2.0; }

void check(const CalibratedFriction& friction, bool has_lubricant)
{
    const auto wrong = [](double value) { return !std::isfinite(value) || value < 0; };
    if (wrong(friction.load_part) || wrong(friction.viscous_part) || wrong(friction.scale) ||
        !std::isfinite(friction.exponent))
        throw InputError(
            fmt::format("friction law: load part {} W, viscous part {} W and scale {} must not be negative",
                        friction.load_part, friction.viscous_part, friction.scale));
    if (!(friction.reference_speed > 0) || !std::isfinite(friction.reference_speed))
        throw InputError(
            "friction law: give the speed at which it was calibrated (reference_speed), greater than zero");
    if (friction.viscous_part > 0 && !has_lubricant)
        throw InputError("friction law: a viscous part needs a lubricant; name one, or set viscous_part to zero");
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
    constexpr double rounding = 0.05;  // [K]: a press that starts at the first point is not outside
    const bool in_range =
        temperature >= temperature_.front() - rounding && temperature <= temperature_.back() + rounding;
    return {value, slope * value, in_range};
}

FrictionKind friction_kind(const std::string& name)
{
    if (name == "rolling")
        return FrictionKind::rolling;
    if (name == "pin")
        return FrictionKind::pin;
    if (name == "guide")
        return FrictionKind::guide;
    throw InputError(fmt::format("'{}' is no kind of friction; use 'rolling', 'pin' or 'guide'", name));
}

HeatLaw calibrated_heat(const CalibratedFriction& friction, const ViscosityCurve* viscosity, double speed)
{
    check(friction, viscosity != nullptr);
    const double s = std::abs(speed) / friction.reference_speed;
    const double load = friction.scale * friction.load_part * s;
    const double viscous = friction.scale * friction.viscous_part * std::pow(s, viscous_speed_exponent(friction.kind));
    if (viscous == 0)
        return [load](double) { return LawValue{load, 0, true}; };

    return [load, viscous, p = friction.exponent, curve = *viscosity](double temperature) {
        const LawValue nu = curve(temperature);
        const double part = viscous * std::pow(nu.value / square_millimetre, p);
        return LawValue{load + part, part * p * nu.slope / nu.value, nu.in_range};
    };
}

}  // namespace deadpoint::tribology
