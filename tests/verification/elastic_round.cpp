#include "../record.hpp"
#include "elastic_model.hpp"

#include <cmath>
#include <numbers>

// Rings of second order: round surfaces and a round bond against Lame's thick cylinders.

using namespace deadpoint;
using verification::Elastic;

namespace {

constexpr double bore = 0.02, middle = 0.03, outside = 0.05, height = 0.01;
constexpr double youngs = 210e9, poisson = 0.3, warm = 50;

/// The rings along y, bonded, between two planes that hold their ends.
casefile::Case bonded_rings(double outer_size, double inner_size, bool tetrahedra)
{
    auto input = verification::read("two-rings", {"numerics.order=2", "materials.outer.expansion=1e-12 1/K"});
    for (auto& [name, part] : input.parts) {
        part.body = "outer";
        part.tetrahedra = tetrahedra;
        std::get<CylinderShape>(part.shapes[0].form).axis = Axis::y;
    }
    input.parts["outer_ring"].size = outer_size;
    input.parts["inner_ring"].size = inner_size;
    input.bodies.erase("inner");
    input.joints.clear();
    for (const char* name : {"bore", "outside"}) {
        input.surfaces[name].axis = "y";
        input.surfaces[name].temperature.reset();
    }
    auto& ends = input.surfaces["ends"];
    ends.select = "all";
    ends.within = BoxShape{{-1, height - 1e-7, -1}, {1, 1, 1}};
    input.surfaces["lower_ends"] = ends;
    input.surfaces["lower_ends"].within = BoxShape{{-1, -1, -1}, {1, 1e-7, 1}};
    return input;
}

/// Mean of the displacement away from the axis over a cylinder about y.
Functional mean_growth(const Machine& machine, const std::string& surface)
{
    Functional result;
    double area = 0;
    for (const auto& entry : machine.surfaces[study::surface_index(machine, surface)].faces)
        for (const auto& point : face_points(machine, machine.faces[entry.face])) {
            const double r = std::hypot(point.position[0], point.position[2]);
            result.points.push_back({entry.face,
                                     point.position,
                                     {point.weight * point.position[0] / r, 0, point.weight * point.position[2] / r}});
            area += point.weight;
        }
    for (auto& point : result.points)
        point.weight = (1 / area) * point.weight;
    return result;
}

/// How far bore and outside grow where the inner ring is warm, both held in length: Lame's cylinders in plane strain
/// under the pressure that closes their misfit.
std::array<double, 2> lame_growths()
{
    const double plane = (1 + poisson) / youngs, free_strain = (1 + poisson) * 1.2e-5 * warm;
    const double a2 = bore * bore, c2 = middle * middle, b2 = outside * outside, k = 1 - 2 * poisson;
    const double give_outer = plane * middle / (b2 - c2) * (k * c2 + b2);
    const double give_inner = plane * middle / (c2 - a2) * (k * c2 + a2);
    const double pressure = free_strain * middle / (give_outer + give_inner);
    return {free_strain * bore - plane * pressure * c2 / (c2 - a2) * (k + 1) * bore,
            plane * pressure * c2 / (b2 - c2) * (k + 1) * outside};
}

std::array<double, 2> solved_growths(double outer_size, double inner_size, bool tetrahedra)
{
    auto input = bonded_rings(outer_size, inner_size, tetrahedra);
    Elastic rings(input);
    // both ends are one surface of feet, which keeps its height
    auto& all = rings.machine.surfaces[static_cast<std::size_t>(study::surface_index(rings.machine, "ends"))].faces;
    const auto& lower =
        rings.machine.surfaces[static_cast<std::size_t>(study::surface_index(rings.machine, "lower_ends"))].faces;
    all.insert(all.end(), lower.begin(), lower.end());
    std::erase_if(all, [](const SurfaceFace& face) { return !face.central; });
    const auto values = rings.values("ends", rings.model.constant_field(293.15 + warm),
                                     {mean_growth(rings.machine, "bore"), mean_growth(rings.machine, "outside")});
    return {values[0], values[1]};
}

}  // namespace

TEST_CASE("order in space: rings of second order that are bonded at a cylinder, after Lame")
{
    const auto exact = lame_growths();
    for (const bool tetrahedra : {false, true}) {
        const auto coarse = solved_growths(0.013, 0.0085, tetrahedra),
                   fine = solved_growths(0.0065, 0.00425, tetrahedra);
        const std::array<std::string, 2> names{"bore", "outside"};
        for (std::size_t i = 0; i < 2; ++i) {
            const double before = std::abs(coarse[i] / exact[i] - 1), after = std::abs(fine[i] / exact[i] - 1);
            MESSAGE(names[i] << ": errors " << before << ", " << after << ", order " << std::log2(before / after));
            // Chords in place of arcs give 1 % and order 2.
            CHECK(after < 2e-4);
            CHECK((std::log2(before / after) > 3 || after < 1e-6));
        }
    }
}
