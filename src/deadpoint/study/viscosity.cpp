#include "deadpoint/study/viscosity.hpp"

#include "deadpoint/core/error.hpp"

#include <fmt/format.h>

namespace deadpoint::study {

tribology::ViscosityLaw viscosity_law(const casefile::Case& input, const std::string& lubricant)
{
    const auto& oil = input.lubricants.at(lubricant);
    const auto& [temperature, value] = oil.viscosity;
    try {
        if (oil.law == "vogel")
            return tribology::vogel_viscosity({*oil.vogel_factor, *oil.vogel_b, oil.vogel_pole, {}});
        if (oil.law == "walther")
            return tribology::walther_viscosity(
                tribology::walther_through({temperature[0], value[0]}, {temperature[1], value[1]}));
        return tribology::ViscosityCurve(temperature, value);
    } catch (const InputError& error) {
        throw InputError(fmt::format("lubricants.{}: {}", lubricant, error.what()));
    }
}

}  // namespace deadpoint::study
