#include "deadpoint/study/laws/viscosity.hpp"

#include "deadpoint/core/error.hpp"

#include <fmt/format.h>

namespace deadpoint::study {

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
    try {
        return [law = law_of(input.lubricants.at(lubricant)), lubricant](double temperature) {
            try {
                return law(temperature);
            } catch (const DomainError& error) {
                throw DomainError(fmt::format("lubricants.{}: {}", lubricant, error.what()));
            }
        };
    } catch (const InputError& error) {
        throw InputError(fmt::format("lubricants.{}: {}", lubricant, error.what()));
    }
}

}  // namespace deadpoint::study
