#include "deadpoint/press/laws/viscosity.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/core/mistakes.hpp"

#include <fmt/format.h>

namespace deadpoint::press {

namespace {

tribology::ViscosityLaw law_of(const casefile::Lubricant& oil)
{
    const auto& [temperature, value] = oil.viscosity;
    if (oil.law == casefile::Lubricant::Law::vogel)
        return tribology::vogel_viscosity({*oil.vogel_factor, *oil.vogel_b, oil.vogel_pole, {}});
    if (oil.law == casefile::Lubricant::Law::walther)
        return tribology::walther_viscosity(
            tribology::walther_through({temperature[0], value[0]}, {temperature[1], value[1]}));
    return tribology::ViscosityCurve(temperature, value);
}

}  // namespace

tribology::ViscosityLaw viscosity_law(const casefile::Case& input, const std::string& lubricant)
{
    const auto path = "lubricants." + lubricant;
    return [law = about(path, [&] { return law_of(input.lubricants.at(lubricant)); }), path](double temperature) {
        return about(path, [&] { return law(temperature); });
    };
}

}  // namespace deadpoint::press
