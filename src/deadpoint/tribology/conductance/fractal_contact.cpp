#include "deadpoint/tribology/conductance/fractal_contact.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/tribology/conductance/conductance.hpp"
#include "deadpoint/tribology/root.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::tribology {
namespace {

void require_fractal(bool holds, const char* what, double value, const char* help)
{
    if (!holds || !std::isfinite(value))
        throw DomainError(fmt::format("fractal contact: {} is {}\n  help: {}", what, value, help));
}

void check_dimension(double dimension)
{
    require_fractal(dimension > 1 && dimension < 2, "the fractal dimension", dimension,
                    "that of a profile lies between 1 and 2; machined surfaces have 1.2 to 1.7");
}

void check(const FractalContact& contact, double pressure)
{
    check_dimension(contact.dimension);
    require_fractal(contact.roughness > 0, "the scaling length G [m]", contact.roughness,
                    "machined surfaces have 1e-13..1e-8");
    require_fractal(contact.sample > 0, "the sample length [m]", contact.sample, "give the side of the measured area");
    require_fractal(contact.hardness > 0, "the hardness [Pa]", contact.hardness, "steel has about 2e9 Pa");
    require_fractal(contact.modulus > 0, "the contact modulus [Pa]", contact.modulus, "see contact_modulus()");
    require_fractal(pressure >= 0, "the pressure [Pa]", pressure, "give zero or more");
}

/// (e^(q t) - 1) / q, which is t at q = 0.
double exponential_mean(double q, double t) { return std::abs(q * t) < 1e-12 ? t : std::expm1(q * t) / q; }

/// The two sums over the spots, with lengths scaled by the critical spot: t = ln(a_L / a_c).
class SpotSums {
public:
    SpotSums(const FractalContact& contact, double psi)
        : D_(contact.dimension), h_((2 - D_) / 2), q_((3 - 2 * D_) / 2), hardness_(contact.hardness)
    {
        log_area_ = 2 * std::log(contact.sample);
        log_critical_ =
            2 * std::log(contact.roughness) + 2 / (D_ - 1) * std::log(2 * contact.modulus / contact.hardness);
        log_scale_ = h_ * std::log(psi) + std::log(D_ / (2 - D_)) - log_area_;
    }
    [[nodiscard]] double log_critical() const { return log_critical_; }
    /// ln of a_L while all spots are plastic: A_r* = p a_L D / (2 - D) / A.
    [[nodiscard]] double log_plastic_spot(double share) const { return std::log(share) - log_scale_; }

    /// ln of A_r* for t >= 0.
    [[nodiscard]] double log_share(double t) const
    {
        return log_scale_ + D_ / 2 * t + log_critical_ + std::log(0.5 * std::expm1(h_ * t) + 1);
    }
    /// ln of P for t >= 0. With a_c = G^2 (2E/H)^(2/(D-1)), E G^(D-1) a_c^(q-h) = H / 2, so the modulus drops out.
    [[nodiscard]] double log_pressure(double t) const
    {
        const double elastic = (2 - D_) / (3 * std::sqrt(2 * std::numbers::pi)) * exponential_mean(q_, t);
        return std::log(hardness_) + log_scale_ + D_ / 2 * t + log_critical_ + std::log(elastic + 1);
    }

private:
    double D_, h_, q_, hardness_;
    double log_area_ = 0, log_critical_ = 0, log_scale_ = 0;
};

/// Depth d by which the largest spot is pressed in.
double depth(const FractalContact& contact, double share)
{
    if (share == 0)
        return 0;
    const double D = contact.dimension;
    const double psi = domain_extension(D);
    return std::pow(psi, -(2 - D) * (2 - D) / 4) * std::pow(contact.roughness, D - 1) *
           std::pow((4 - 2 * D) / D * share, (2 - D) / 2) * std::pow(contact.sample, 2 - D);
}

void check_gap_fluid(const GapFluid& fluid)
{
    require_fractal(fluid.conductivity >= 0, "the conductivity of the gap's fluid [W/m/K]", fluid.conductivity,
                    "oil has about 0.14, air 0.026, a vacuum 0");
    require_fractal(fluid.jump >= 0, "the temperature jump of the gas [m]", fluid.jump, "give 0 for a liquid");
}

}  // namespace

double domain_extension(double dimension)
{
    check_dimension(dimension);
    const double D = dimension;
    // For D -> 2 both sides vanish; after division by 2 - D the equation keeps its slope.
    const double e = 2 - D;
    const auto equation = [D, e](double psi) {
        const double grown = std::expm1(e / 2 * std::log(psi)) / e;
        const double reduced = std::expm1(-e / D * std::log1p(std::pow(psi, -D / 2))) / e;
        return grown - reduced - 1 / D;
    };
    return increasing_root(equation, 1.0, 4.0);
}

ContactArea fractal_area(const FractalContact& contact, double pressure)
{
    check(contact, pressure);
    const SpotSums sums(contact, domain_extension(contact.dimension));
    ContactArea area;
    area.log_critical = sums.log_critical();
    if (pressure == 0)
        return area;
    area.share = pressure / contact.hardness;
    double log_spot = sums.log_plastic_spot(area.share);
    area.plastic = log_spot <= area.log_critical;
    if (!area.plastic) {
        const auto mismatch = [&sums, target = std::log(pressure)](double t) { return sums.log_pressure(t) - target; };
        double high = 1;  // ln P grows at least like (D/2) t, so the loop ends
        while (mismatch(high) < 0)
            high *= 2;
        const double t = increasing_root(mismatch, 0.0, high);
        area.share = std::exp(sums.log_share(t));
        log_spot = area.log_critical + t;
    }
    area.largest_spot = std::exp(log_spot);
    require_fractal(area.share < 1, "the share of the area in real contact", area.share,
                    "the pressure is too high for this surface; check it and the scaling length G");
    area.in_range = area.share <= 0.1 && area.largest_spot <= contact.sample * contact.sample;
    return area;
}

ContactConductance fractal_conductance(const FractalContact& contact, const GapFluid& fluid, double pressure)
{
    check_gap_fluid(fluid);
    const ContactArea area = fractal_area(contact, pressure);
    const double pressed_in = depth(contact, area.share);
    require_fractal(contact.separation > pressed_in, "the separation z [m]", contact.separation,
                    fmt::format("it must exceed the depth of the largest spot, {:.4g} m", pressed_in).c_str());
    const double gap = 2 * (contact.separation - pressed_in);
    const double solid = harmonic_conductivity(contact.conductivity1, contact.conductivity2);
    const double through_fluid = (1 - area.share) * fluid.conductivity / (gap + fluid.jump);
    ContactConductance result{area.share * solid / gap + through_fluid, true, {}};
    require_fractal(result.conductance > 0, "the result [W/m2/K]", result.conductance,
                    "faces without pressure conduct only through a fluid");
    if (!area.in_range) {
        result.in_range = false;
        result.notes.push_back(
            fmt::format("share of the area in real contact {:.3g}, largest spot {:.3g} m2: beyond 0.1 "
                        "or the sample of {:.3g} m2, where the fractal law is not meant",
                        area.share, area.largest_spot, contact.sample * contact.sample));
    }
    return result;
}

double fractal_separation(const FractalContact& contact, const GapFluid& fluid, double pressure, double conductance)
{
    check_gap_fluid(fluid);
    require_fractal(conductance > 0, "the known conductance [W/m2/K]", conductance, "give a positive number");
    const ContactArea area = fractal_area(contact, pressure);
    const double solid = area.share * harmonic_conductivity(contact.conductivity1, contact.conductivity2);
    const double open = (1 - area.share) * fluid.conductivity;
    // h = solid / L + open / (L + M) is quadratic in L; its positive root without cancellation.
    const double linear = conductance * fluid.jump - solid - open;
    const double root = std::hypot(linear, 2 * std::sqrt(conductance * solid * fluid.jump));
    const double gap = linear > 0 ? 2 * solid * fluid.jump / (linear + root) : (root - linear) / (2 * conductance);
    require_fractal(gap > 0, "the gap that conducts this [m]", gap,
                    "give the known conductance of a gap that can conduct it");
    return gap / 2 + depth(contact, area.share);
}

}  // namespace deadpoint::tribology
