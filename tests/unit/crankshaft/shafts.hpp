#pragma once

#include "deadpoint/crankshaft/shaft/shaft.hpp"
#include "deadpoint/crankshaft/shaft/system.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

/// Shafts with known answers. The reference's y and z are x and y here: both turn from the first to the second.
namespace deadpoint::shafts {

using namespace crankshaft;

inline const nlohmann::json& reference()
{
    static const nlohmann::json data = [] {
        std::ifstream file(std::string(DEADPOINT_TEST_DATA) + "/rotor.json");
        return nlohmann::json::parse(file);
    }();
    return data;
}

constexpr double rpm = std::numbers::pi / 30;

inline Matrix2 isotropic(double value) { return {{{value, 0}, {0, value}}}; }

inline Bearing bearing(const std::string& name, double position, double stiffness, double damping = 0)
{
    Bearing result;
    result.name = name;
    result.position = position;
    result.stiffness = isotropic(stiffness);
    result.damping = isotropic(damping);
    return result;
}

/// Steel of the reference, with no sections yet.
inline Shaft steel()
{
    Shaft shaft;
    shaft.youngs_modulus = 215e9;
    shaft.poissons_ratio = 0.277;
    return shaft;
}

constexpr double steel_density = 7870;

/// The paper's crankshaft (Table 1). Readings of the table: "literal" (bearings and disk at the left ends of the
/// elements named), "nodouble" (the same, the pulley's element without mass), "elemmid" (at their middles, without
/// mass).
inline Shaft table1(const std::string& variant, double stiffness, double damping = 0)
{
    Shaft shaft = steel();
    std::vector<double> begin;
    double end = 0;
    for (const auto& row : reference()["table1_L_D"]) {
        begin.push_back(end);
        shaft.sections.push_back({row[0], row[1], 0, steel_density});
        end += row[0].get<double>();
    }
    if (variant != "literal")
        shaft.sections[16].density = 0;
    const auto place = [&](std::size_t element) {
        return begin[element - 1] + (variant == "elemmid" ? 0.5 * shaft.sections[element - 1].length : 0.0);
    };
    shaft.disks.push_back({place(17), 512, 45.83, 24.33});
    const std::size_t elements[]{3, 4, 13, 14};
    for (const std::size_t element : elements)
        shaft.bearings.push_back(bearing("bearing " + std::to_string(element), place(element), stiffness, damping));
    return shaft;
}

/// Left end of the paper's element 9, the middle of the crank.
constexpr double crank_middle = 0.4856;

/// A beam of 1 m x 0.1 m whose ends are held in place but free to turn.
inline Shaft pinned_beam(int elements)
{
    Shaft shaft;
    shaft.youngs_modulus = 210e9;
    shaft.poissons_ratio = 0.3;
    for (int i = 0; i < elements; ++i)
        shaft.sections.push_back({1.0 / elements, 0.1, 0, 7850});
    // As in the reference; 1e-6 of the beam's own compliance.
    shaft.bearings = {bearing("left", 0, 1e14), bearing("right", 1, 1e14)};
    return shaft;
}

/// The rotor of Friswell, Penny, Garvey and Lees, Dynamics of Rotating Machines (2010), examples 5.9.1 and 5.9.2.
inline Shaft friswell(double stiffness_x, double stiffness_y)
{
    Shaft shaft;
    shaft.youngs_modulus = 211e9;
    shaft.poissons_ratio = 211.0 / (2 * 81.2) - 1;
    const double cowper = 6 * (1 + shaft.poissons_ratio) / (7 + 6 * shaft.poissons_ratio);
    for (int i = 0; i < 6; ++i)
        shaft.sections.push_back({0.25, 0.05, 0, 7810, cowper});
    const auto disk = [](double position, double outer) {
        const double inner = 0.05;
        const double width = 0.07;
        const double mass = 7810 * width * std::numbers::pi / 4 * (outer * outer - inner * inner);
        const double polar = mass / 8 * (outer * outer + inner * inner);
        return Disk{position, mass, polar, polar / 2 + mass * width * width / 12};
    };
    shaft.disks = {disk(0.5, 0.28), disk(1.0, 0.35)};
    for (const double position : {0.0, 1.5}) {
        shaft.bearings.push_back(bearing("at " + std::to_string(position), position, stiffness_x));
        shaft.bearings.back().stiffness[1][1] = stiffness_y;
    }
    return shaft;
}

/// A small crankshaft with a pulley, anisotropic bearings and a crank between them.
inline Shaft small_shaft()
{
    Shaft shaft = steel();
    shaft.sections = {{0.1, 0.08, 0, steel_density}, {0.2, 0.12, 0.03, steel_density}, {0.25, 0.07, 0, steel_density}};
    shaft.disks = {{0.5, 60, 2.0, 1.2}};
    shaft.bearings = {bearing("left", 0.05, 3e8, 2e4), bearing("right", 0.35, 2e8, 1e4)};
    shaft.bearings[0].stiffness = {{{3e8, 2e7}, {2e7, 2e8}}};
    shaft.modal_damping = 0.03;
    return shaft;
}

}  // namespace deadpoint::shafts
