#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

/// The scalars of a heat balance at one time, and the records of accepted steps.
namespace deadpoint::heat {

/// An oil circuit at one time.
struct OilFlow {
    double inlet = 0;            ///< [K]
    double outlet = 0;           ///< [K]
    double sump = 0;             ///< [K]
    double sump_rate = 0;        ///< dT/dt of the sump; 0 if it follows at once [K/s]
    double sump_relaxation = 0;  ///< -d(sump_rate)/d(sump) [1/s]
    double heat = 0;             ///< from the joints [W]
    double cooler = 0;           ///< taken by the cooler [W]
};
constexpr auto members(const OilFlow*)
{
    return std::tuple{&OilFlow::inlet,           &OilFlow::outlet, &OilFlow::sump,  &OilFlow::sump_rate,
                      &OilFlow::sump_relaxation, &OilFlow::heat,   &OilFlow::cooler};
}

/// The air of an enclosure at one time.
struct AirFlow {
    double temperature = 0;    ///< [K]
    double from_surfaces = 0;  ///< [W]
    double power = 0;          ///< [W]
    double to_room = 0;        ///< [W]
    [[nodiscard]] double kept() const { return from_surfaces + power - to_room; }
};
constexpr auto members(const AirFlow*)
{
    return std::tuple{&AirFlow::temperature, &AirFlow::from_surfaces, &AirFlow::power, &AirFlow::to_room};
}

/// The scalars with which the balance of a stage is linear in the temperatures, all of the model.
struct StageRecord {
    double time = 0;                      ///< [s]
    std::vector<double> source_heat;      ///< per source, as in the energy balance [W]
    std::vector<double> body_heat;        ///< [W]
    std::vector<double> oil_temperature;  ///< per interface, as used in the solve [K]
    std::vector<double> film_mean;        ///< per surface condition: mean temperature; 0 where it is prescribed [K]
    std::vector<double>
        variable_to_air;       ///< per surface condition whose coefficient depends on temperature: total heat loss [W]
    std::vector<AirFlow> air;  ///< per enclosure
};
constexpr auto members(const StageRecord*)
{
    return std::tuple{
        &StageRecord::time,      &StageRecord::source_heat,     &StageRecord::body_heat, &StageRecord::oil_temperature,
        &StageRecord::film_mean, &StageRecord::variable_to_air, &StageRecord::air};
}

/// Everything scalar that enters the heat balance at one time.
struct HeatBalance : StageRecord {
    std::vector<double> source_slope;        ///< of a source's heat by the solids' part of its film temperature [W/K]
    std::vector<double> source_temperature;  ///< mean film temperature per source [K]
    std::vector<double> film;                ///< mean film temperature per interface [K]
    std::vector<OilFlow> oil;                ///< per circuit
    double generated = 0;                    ///< friction and other heat [W]
    double to_air = 0;                       ///< of the room [W]
    double to_oil = 0;                       ///< [W]
    double flux = 0;                         ///< through surfaces of prescribed flux, into the parts [W]
    bool in_range = true;                    ///< of the laws of friction heat
    std::vector<double> films_untested;      ///< per surface condition: area where its law is out of range [m2]
};
constexpr auto members(const HeatBalance*)
{
    return std::tuple_cat(members(static_cast<const StageRecord*>(nullptr)),
                          std::tuple{&HeatBalance::source_slope, &HeatBalance::source_temperature, &HeatBalance::film,
                                     &HeatBalance::oil, &HeatBalance::generated, &HeatBalance::to_air,
                                     &HeatBalance::to_oil, &HeatBalance::flux, &HeatBalance::in_range,
                                     &HeatBalance::films_untested});
}

/// An accepted step, enough to run it backward.
struct StepRecord {
    std::size_t segment = 0;
    std::size_t row = 0;  ///< of the history that holds its end
    double duration = 0;  ///< [s]
    StageRecord start, middle, end;
};
constexpr auto members(const StepRecord*)
{
    return std::tuple{&StepRecord::segment, &StepRecord::row,    &StepRecord::duration,
                      &StepRecord::start,   &StepRecord::middle, &StepRecord::end};
}

}  // namespace deadpoint::heat
