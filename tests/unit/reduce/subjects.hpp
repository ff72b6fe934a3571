#pragma once

#include "deadpoint/reduce/online/box.hpp"
#include "rods.hpp"

#include <cmath>
#include <utility>
#include <vector>

/// Machines of lumps with free coefficients, for derivatives by them.
namespace subjects {

using deadpoint::HeatProblem;
using namespace deadpoint::reduce;

/// A machine with its free coefficients.
struct Subject {
    DenseTerms terms;
    HeatProblem problem;
    Box box;
    std::vector<double> values;

    [[nodiscard]] HeatProblem at(const std::vector<double>& other) const
    {
        auto result = problem;
        set_values(result, box, other);
        return result;
    }
};

/// The two rods: half an hour with heat, a break, and heat again with other conductances.
inline Subject rods_with_break()
{
    Subject result{rods::full_terms(), rods::problem(), rods::box(), {1.3, 0.8, 0.9, 1.2, 0.7, 1.1, 2, 3}};
    result.box.push_back({"oil temperature", FreeCoefficient::Kind::oil_temperature, {}, {}, -10, 10});
    auto& segments = result.problem.segments;
    segments.assign(3, segments[0]);
    segments[0].duration = 1800;
    segments[1].duration = 900;
    segments[1].heat[0] = {};
    segments[2].duration = 1500;
    segments[2].interfaces = result.problem.interfaces;
    segments[2].interfaces[0].film_a = 1500;
    return result;
}

/// Two bearings: a source in two joints that also heats by load zone, a joint that turns fully, and a
/// source whose heat enters a part.
inline Subject bearings()
{
    const lumps::Machine machine{{900, 1100, 1300, 700, 1500},
                                 {{0, 4, 9}, {3, 4, 11}},
                                 {{0, 1, 0.02}, {1, 2, 0.03}, {2, 3, 0.01}},
                                 {{4, 0.4}, {1, 0.2}, {2, 0.1}},
                                 {0, 2, 4}};
    Subject result;
    auto& problem = result.problem;
    deadpoint::InterfaceLaw law;
    law.film_a = 1500;
    law.film_b = 900;
    law.oil = 200;
    law.oil_temperature = 300;
    law.source = 0;
    problem.interfaces.assign(3, law);
    problem.interfaces[0].load_zone = [](const deadpoint::Vec3&) { return 1.0; };
    problem.interfaces[1].turns_fully = true;
    problem.interfaces[1].heat_weight = 2.5;
    problem.interfaces[2].source = 1;
    problem.interfaces[2].heat_part = 4;
    problem.interfaces[2].load_zone = problem.interfaces[0].load_zone;
    problem.sources = {{"rolling", 0.5, {{0, false}}, {{1, true}}}, {"sliding", 1, {}, {}}};
    problem.body_heat = {{"motor", {3}, -1}};
    problem.surfaces = {lumps::film(15), lumps::film(10), lumps::film(0)};
    problem.surfaces[1].ambient = lumps::steady(285);
    problem.surfaces[2].kind = deadpoint::SurfaceCondition::Kind::flux;
    problem.surfaces[2].flux = lumps::steady(50);
    problem.segments = {lumps::segment(problem, 600, 293)};
    auto& segment = problem.segments[0];
    segment.heat = {[](double t) {
                        return deadpoint::LawValue{80 - 0.5 * (t - 293), -0.5, true};
                    },
                    [](double t) {
                        return deadpoint::LawValue{30 - 0.2 * (t - 293), -0.2, true};
                    }};
    segment.zoned_heat = {20, 10};
    segment.body_heat[0] = lumps::steady(25);
    problem.initial_temperature = [](int part, const deadpoint::Vec3&) { return 293.0 + part; };
    result.terms = lumps::terms_of(machine, problem);
    auto& terms = result.terms;
    terms.parts = Eigen::MatrixXd(terms.uniform.asDiagonal());
    terms.observed = RowMatrix::Ones(1, 5);
    terms.joints[1].turning.factor *= 0.8;
    const auto& layout = terms.geometry.layout;
    for (std::size_t i = 0; i < 3; ++i)
        for (const bool side_b : {false, true}) {
            auto zone = terms.functionals.row(static_cast<Eigen::Index>(layout.zone(i, side_b)));
            zone[3] = (side_b ? 0.6 : 1) / terms.uniform[3];
            zone[static_cast<Eigen::Index>(i)] = -1 / terms.uniform[static_cast<Eigen::Index>(i)];
        }
    result.box = {{"film", FreeCoefficient::Kind::film, {0}, {15}, 0.2, 5},
                  {"films", FreeCoefficient::Kind::film, {0, 1}, {15, 10}, 0.2, 5},
                  {"1a", FreeCoefficient::Kind::side, {0}, {1500}, 0.1, 10},
                  {"1b", FreeCoefficient::Kind::side, {1}, {900}, 0.1, 10},
                  {"2", FreeCoefficient::Kind::side, {2, 3}, {900}, 0.1, 10},
                  {"3", FreeCoefficient::Kind::side, {4, 5}, {900}, 0.1, 10},
                  {"oil 1", FreeCoefficient::Kind::oil, {0}, {200}, 0, 5},
                  {"oil", FreeCoefficient::Kind::oil, {1, 2}, {200, 150}, 0, 5},
                  {"rolling", FreeCoefficient::Kind::heat, {0}, {80}, 0.3, 3},
                  {"sliding", FreeCoefficient::Kind::heat, {1}, {30}, 0.3, 3},
                  {"oil temperature", FreeCoefficient::Kind::oil_temperature, {}, {}, -10, 10},
                  {"ambient", FreeCoefficient::Kind::ambient, {}, {}, -10, 10}};
    result.values = {1.2, 0.7, 1.4, 0.8, 1.1, 0.9, 0.6, 1.5, 1.2, 0.9, 4, -3};
    return result;
}

/// Oil of two circuits through the bearings: cooled in the first and second, and in the third from a sump. A stop has
/// two interfaces, since the first bearing's oil also reaches a fourth one.
/// @param sump_capacity  0: the sump follows at once [J/K]
inline Subject oiled_bearings(double sump_capacity)
{
    Subject result = bearings();
    auto& problem = result.problem;
    problem.oil = {{"cooled", {{0}, {1}}, true, 295, 0, 0, 0},
                   {"from a sump", {{2}, {}, {3}}, false, 0, sump_capacity, 1.5, 291}};
    auto law = problem.interfaces[2];
    law.source = 1;
    law.heat_part = -1;
    law.load_zone = {};
    law.heat_weight = 0.4;
    problem.interfaces.push_back(law);
    problem.segments[0].oil_flow = {12, 9};
    problem.segments[0].duration = 400;
    problem.segments.push_back(problem.segments[0]);
    problem.segments[1].oil_flow = {20, 0};  // the second pump stands still
    problem.segments[1].duration = 200;
    problem.segments.push_back(problem.segments[0]);
    problem.segments[2].duration = 200;
    problem.fixed_step = 20;
    problem.time_tolerance = 1e-6;  // so that oil and joints agree to rounding
    auto& terms = result.terms;
    const auto& from = terms.geometry.layout;
    auto layout = from;
    layout.interfaces = 4;
    RowMatrix functionals = RowMatrix::Zero(static_cast<Eigen::Index>(layout.count()), terms.uniform.size());
    const auto rows = [](std::size_t count) { return static_cast<Eigen::Index>(count); };
    functionals.topRows(6) = terms.functionals.topRows(6);
    functionals.middleRows(rows(layout.zone(0, false)), 6) = terms.functionals.middleRows(rows(from.zone(0, false)), 6);
    functionals.bottomRows(rows(layout.count() - layout.part(0))) =
        terms.functionals.bottomRows(rows(from.count() - from.part(0)));
    functionals(rows(layout.mean(3, false)), 4) = 1 / terms.uniform[4];
    functionals(rows(layout.mean(3, true)), 0) = 1 / terms.uniform[0];
    terms.functionals = functionals;
    terms.geometry.layout = layout;
    terms.geometry.interface_names.emplace_back("joint 3");
    terms.geometry.interface_area.push_back(0.015);
    const Eigen::VectorXd a = std::sqrt(0.015) * Eigen::VectorXd::Unit(5, 4) / terms.uniform[4];
    const Eigen::VectorXd b = std::sqrt(0.015) * Eigen::VectorXd::Unit(5, 0) / terms.uniform[0];
    terms.joints.push_back({{a}, {b}, {a - b}, {}});
    result.box.push_back({"4", FreeCoefficient::Kind::side, {6, 7}, {900}, 0.1, 10});
    result.box.push_back({"oil 4", FreeCoefficient::Kind::oil, {3}, {220}, 0, 5});
    result.values.insert(result.values.end(), {1.3, 0.8});
    return result;
}

/// A film over two lumps, so that its temperature has a variance.
inline void spread(DenseTerms& terms, std::size_t surface, int first, double area, int second, double more)
{
    const auto n = terms.uniform.size();
    const auto lump = [&](int k) -> Eigen::VectorXd { return Eigen::VectorXd::Unit(n, k) / terms.uniform[k]; };
    Eigen::MatrixXd factor(n, 2);
    factor << std::sqrt(area) * lump(first), std::sqrt(more) * lump(second);
    terms.films[surface].factor = factor;
    terms.functionals.row(static_cast<Eigen::Index>(terms.geometry.layout.surface(surface))) =
        (area * lump(first) + more * lump(second)).transpose();
    terms.geometry.surface_area[surface] = area + more;
}

/// As natural convection: 1.8 |T - T_air|^0.3, smooth at zero [W/m2/K].
inline deadpoint::FilmLawAt natural_convection(double factor)
{
    return {[factor](double air) -> deadpoint::FilmLaw {
        return [=](double surface) {
            const double rise = surface - air, square = rise * rise + 4;
            return deadpoint::LawValue{factor * 1.8 * std::pow(square, 0.15),
                                       factor * 1.8 * 0.3 * rise * std::pow(square, -0.85), true};
        };
    }};
}

/// The bearings with films that follow the temperature: natural convection and radiation, both over two lumps, of which
/// two surfaces radiate to each other.
inline Subject warm_bearings()
{
    Subject result = bearings();
    auto& problem = result.problem;
    problem.surfaces[2] = lumps::film(0);
    for (auto& surface : problem.surfaces)
        surface.laws = {natural_convection(1)};
    problem.surfaces[0].emissivity = 0.7;
    problem.surfaces[1].emissivity = 0.8;
    problem.surfaces[2].emissivity = 0.5;
    problem.segments[0].ambient = [](double time) { return 293 + 4 * std::sin(time / 200); };
    problem.radiation = {{{1, 2}, {0.06, 0.1, 0.1, 0.03}}};  // rows sum to emissivity times area
    spread(result.terms, 0, 4, 0.4, 3, 0.3);
    spread(result.terms, 1, 1, 0.12, 0, 0.08);
    spread(result.terms, 2, 2, 0.13, 1, 0.13);
    problem.fixed_step = 30;
    result.box.erase(result.box.begin(), result.box.begin() + 2);
    result.values.erase(result.values.begin(), result.values.begin() + 2);
    return result;
}

/// Warm bearings in two cabinets, one of which is heated; a film of constant coefficient gives heat to one, and natural
/// convection to both.
inline Subject enclosed_bearings()
{
    Subject result = warm_bearings();
    auto& problem = result.problem;
    problem.radiation.clear();
    problem.surfaces[0].enclosure = 0;
    problem.surfaces[0].emissivity = 0;
    problem.surfaces[1].enclosure = 1;
    problem.surfaces[1].emissivity = 0;
    problem.surfaces[1].ambient = {};
    problem.surfaces[2] = lumps::film(9);
    problem.surfaces[2].enclosure = 0;
    problem.enclosures = {{"crank", 300, 2, 293}, {"motor", 150, 1.5, 295}};
    problem.segments[0].enclosure_power = {{}, lumps::steady(20)};
    problem.segments.push_back(problem.segments[0]);
    problem.segments[1].duration = 300;
    problem.segments[1].enclosure_power.clear();
    for (auto& surface : problem.surfaces)
        if (!surface.laws.empty())
            surface.laws.push_back(natural_convection(0.6));
    return result;
}

}  // namespace subjects
