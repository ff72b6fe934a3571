#include "deadpoint/fem/reference/quadrature.hpp"

#include "deadpoint/fem/reference/element.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace deadpoint::fem {
namespace {

struct LinePoint {
    double place;  // on the unit interval
    double weight;
};

// Gauss' points on the unit interval, from the roots r of Legendre's polynomials: (1 +- r) / 2.
std::vector<LinePoint> gauss_on_line(unsigned n)
{
    const auto pair = [](double root, double weight) {
        return std::vector<LinePoint>{{(1 - root) / 2, weight}, {(1 + root) / 2, weight}};
    };
    switch (n) {
    case 1:
        return {{0.5, 1}};
    case 2:
        return pair(std::sqrt(1.0 / 3), 0.5);
    case 3: {
        const auto outer = pair(std::sqrt(0.6), 5.0 / 18);
        return {outer[0], {0.5, 4.0 / 9}, outer[1]};
    }
    case 4: {
        const double spread = 2.0 / 7 * std::sqrt(1.2), share = std::sqrt(30.0) / 72;
        const auto outer = pair(std::sqrt(3.0 / 7 + spread), 0.25 - share);
        const auto inner = pair(std::sqrt(3.0 / 7 - spread), 0.25 + share);
        return {outer[0], inner[0], inner[1], outer[1]};
    }
    default:
        throw std::invalid_argument("a rule has 1 to 4 points per direction");
    }
}

// A point by its barycentric coordinates, in ascending order; every other order of them is a point of the same weight.
struct Orbit {
    std::array<double, 4> coordinates;
    double weight;
};

Quadrature of_orbits(const std::vector<Orbit>& orbits)
{
    Quadrature rule;
    for (auto [x, weight] : orbits) {
        do {
            rule.points.push_back({x[0], x[1], x[2]});
            rule.weights.push_back(weight);
        } while (std::ranges::next_permutation(x).found);
    }
    return rule;
}

// A rule without symmetry.
const Quadrature& six_points()
{
    static const Quadrature rule{{{0.16200149169852451, 0.18385035049209769, 0.012718366313681451},
                                  {0.010905212211189241, 0.28152380212354622, 0.3621268299455338},
                                  {0.19011700243928389, 0.011403329444557171, 0.35862072046688392},
                                  {0.170816925164989, 0.15281814309092731, 0.63849329996172666},
                                  {0.15868516322744061, 0.58566280565521578, 0.1308471689520965},
                                  {0.57122605214911515, 0.14691839008716959, 0.14037280579421069}},
                                 {0.020387000459557516, 0.021344402118457815, 0.022094671190740867,
                                  0.023437401610067202, 0.037402527819592898, 0.042000663468250383}};
    return rule;
}

}  // namespace

Quadrature gauss_on_cube(unsigned n)
{
    const auto line = gauss_on_line(n);
    Quadrature rule;
    for (const auto& z : line)
        for (const auto& y : line)
            for (const auto& x : line) {
                rule.points.push_back({x.place, y.place, z.place});
                rule.weights.push_back(x.weight * y.weight * z.weight);
            }
    return rule;
}

Quadrature gauss_on_tetrahedron(unsigned n)
{
    switch (n) {
    case 1:
        return of_orbits({{{0.25, 0.25, 0.25, 0.25}, 1.0 / 6}});
    case 2:
        return six_points();
    case 3:
        return of_orbits({{{0.067342242210098213, 0.31088591926330061, 0.31088591926330061, 0.31088591926330061},
                           0.01878132095300265},
                          {{0.092735250310891248, 0.092735250310891248, 0.092735250310891248, 0.72179424906732625},
                           0.012248840519393659},
                          {{0.045503704125649642, 0.045503704125649642, 0.45449629587435036, 0.45449629587435036},
                           0.0070910034628469121}});
    case 4:
        return of_orbits({{{0.25, 0.25, 0.25, 0.25}, 0.015914214910688472},
                          {{0.052896550665391562, 0.31570114977820279, 0.31570114977820279, 0.31570114977820279},
                           0.0070549302016611713},
                          {{0.05048982259839635, 0.05048982259839635, 0.44951017740160365, 0.44951017740160365},
                           0.0053161546388095964},
                          {{0.047160700360998065, 0.18883383102600099, 0.18883383102600099, 0.57517163758699996},
                           0.0062011884547224366},
                          {{0.02126547254148314, 0.02126547254148314, 0.14663881381848509, 0.81083024109854862},
                           0.0013517951383172236}});
    default:
        throw std::invalid_argument("a rule on tetrahedra is of number 1 to 4");
    }
}

Quadrature gauss_on(const ReferenceElement& element, unsigned n)
{
    return element.is_cube() ? gauss_on_cube(n) : gauss_on_tetrahedron(n);
}

}  // namespace deadpoint::fem
