#pragma once

#include "deadpoint/reduce/offline/box.hpp"
#include "rods.hpp"

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

}  // namespace subjects
