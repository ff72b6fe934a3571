/// Requirement: a film law acts in the transient as its formula says, and the energy balance still closes.
#include "near.hpp"
#include "solved_case.hpp"

#include <cmath>

using verification::solve;
using verification::zero_celsius;

namespace {

/// Nusselt's number of a vertical wall by Churchill and Chu and air by Sutherland, written out anew.
double convection(double surface, double ambient, double height)
{
    const double t = (surface + ambient) / 2;
    const double viscosity = 1.716e-5 * std::pow(t / 273.15, 1.5) * (273.15 + 110.4) / (t + 110.4);
    const double conductivity = 0.02414 * std::pow(t / 273.15, 1.5) * (273.15 + 194.4) / (t + 194.4);
    const double density = 101325 / (287.05 * t);
    const double nu = viscosity / density, prandtl = viscosity * 1006 / conductivity;
    const double rayleigh = 9.81 / t * (surface - ambient) * std::pow(height, 3) / (nu * nu) * prandtl;
    const double bracket = std::pow(1 + std::pow(0.492 / prandtl, 9.0 / 16), 8.0 / 27);
    return std::pow(0.825 + 0.387 * std::pow(rayleigh, 1.0 / 6) / bracket, 2) * conductivity / height;
}

/// Temperature at which 0.02^2 m2 of heated face and 0.0036 m2 of faces in air balance [K].
double balance(double flux, double ambient)
{
    double low = ambient, high = ambient + 200;
    for (int i = 0; i < 100; ++i) {
        const double t = (low + high) / 2;
        const double lost = 0.0036 * (convection(t, ambient, 0.04) * (t - ambient) +
                                      0.5 * 5.670374419e-8 * (std::pow(t, 4) - std::pow(ambient, 4)));
        (lost < 4e-4 * flux ? low : high) = t;
    }
    return low;
}

}  // namespace

TEST_CASE("a heated block in still air comes to rest where its film law balances the heat")
{
    const auto solved = solve("wall-in-air");
    const double expected = balance(1500, 293.15) - zero_celsius;
    CHECK(expected > 35);  // a rise that the correlation feels
    // The block is not quite at one temperature: 1500 W/m2 over 20 mm of copper are 0.075 K.
    CHECK(solved.probe("middle") == near(expected, 0.05 / expected));
    CHECK_FALSE(solved.history().film_out_of_range.at(0));
    CHECK(solved.history().to_air.back() == near(0.6, 1e-4));  // all that comes in
}

TEST_CASE("a film follows a daily ambient within each step's tolerance")
{
    const std::vector<std::string> daily{
        "surfaces.heater.heat_flux=0 W/m^2", "operation.0.duration=96 h", "numerics.max_step=600 s",
        "operation.0.ambient={ mean = \"20 degC\", amplitude = \"5 K\", time_of_maximum = \"12 h\" }"};
    const auto solved = solve("wall-in-air", daily);
    double highest = 0, lowest = 100;
    for (int hour = 72; hour <= 96; ++hour) {
        highest = std::max(highest, solved.probe("middle", 3600.0 * hour));
        lowest = std::min(lowest, solved.probe("middle", 3600.0 * hour));
    }
    // The block lags by about its time constant of 40 min and keeps 1 / sqrt(1 + (2 pi / 36)^2) = 98 % of 5 K.
    CHECK(highest == near(24.9, 0.2 / 24.9));
    CHECK(lowest == near(15.1, 0.2 / 15.1));
    CHECK(highest < 25);
    CHECK(lowest > 15);
}

TEST_CASE("a film law outside its tested range is recorded")
{
    // 1e-4 of the Rayleigh number of the block's own height is far below 0.1, while the surface is 16 K above the air.
    const auto solved = solve("wall-in-air", {"surfaces.air.film.length=0.2 mm"});
    CHECK(solved.history().film_out_of_range.at(0));
}
