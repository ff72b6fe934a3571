#include "../tests/unit/heat/lumps.hpp"
#include "deadpoint/exchange/heat.hpp"
#include "deadpoint/exchange/laws/laws.hpp"
#include "deadpoint/heat/films.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

// A warm-up of three hours on reduced models of a made-up press: 19 bodies of 64 nodes, 24 joints of 15 nodes a side
// with oil, 14 of them with heat that falls with the temperature, two films a body of 15 nodes each. The states are
// responses of the bodies to their joints and films. Prints medians of a run with its laws, model made before [ms].

namespace {

using namespace deadpoint;
using reduce::DenseTerms;

constexpr int bodies = 19, side = 4, nodes = side * side * side, joints = 24, sources = 14, films = 38, patch = 15;
constexpr double capacity = 15000, conductance = 15;  // of a node [J/K], between neighbours [W/K]

using Nodes = std::vector<int>;

Nodes random_patch(std::mt19937& random, int body)
{
    Nodes result(nodes);
    for (int k = 0; k < nodes; ++k)
        result[static_cast<std::size_t>(k)] = body * nodes + k;
    std::ranges::shuffle(result, random);
    result.resize(patch);
    return result;
}

/// Matrices over nodes, divided by the roots of their equal capacities.
struct Press {
    Press()
    {
        std::mt19937 random(7);
        for (int j = 0; j < joints; ++j) {
            a.push_back(random_patch(random, j % bodies));
            b.push_back(random_patch(random, (j + 1 + j / bodies) % bodies));
        }
        for (int f = 0; f < films; ++f)
            surfaces.push_back(random_patch(random, f % bodies));
        for (int body = 0; body < bodies; ++body)
            for (int k = 0; k < nodes; ++k)
                for (const int next : {1, side, side * side})
                    if ((k / next) % side + 1 < side)
                        link(body * nodes + k, body * nodes + k + next);
    }
    void link(int p, int q)
    {
        const double value = conductance / capacity;
        for (const auto& [row, column, sign] : {std::tuple(p, p, 1), {q, q, 1}, {p, q, -1}, {q, p, -1}})
            solid(row, column) += sign * value;
    }
    Eigen::MatrixXd solid = Eigen::MatrixXd::Zero(bodies * nodes, bodies* nodes);
    std::vector<Nodes> a, b, surfaces;
};

Eigen::VectorXd mean_of(const Nodes& of)
{
    Eigen::VectorXd result = Eigen::VectorXd::Zero(bodies * nodes);
    for (const int k : of)
        result[k] = 1 / (static_cast<double>(of.size()) * std::sqrt(capacity));
    return result;
}

constexpr double joint_area = 0.02, film_area = 0.4;

/// Orthonormal states: uniform temperature, then responses of all joints and films at growing speeds.
Eigen::MatrixXd states_of(const Press& press, int count)
{
    Eigen::MatrixXd inputs(bodies * nodes, 2 * joints + films), all(bodies * nodes, count);
    for (int j = 0; j < joints; ++j) {
        inputs.col(2 * j) = mean_of(press.a[static_cast<std::size_t>(j)]);
        inputs.col(2 * j + 1) = mean_of(press.b[static_cast<std::size_t>(j)]);
    }
    for (int f = 0; f < films; ++f)
        inputs.col(2 * joints + f) = mean_of(press.surfaces[static_cast<std::size_t>(f)]);
    all.col(0).setOnes();
    for (Eigen::Index filled = 1, round = 0; filled < count; ++round) {
        Eigen::MatrixXd shifted = press.solid;
        shifted.diagonal().array() += std::pow(10.0, static_cast<double>(round) - 3.5);
        const Eigen::MatrixXd answers = shifted.llt().solve(inputs);
        const Eigen::Index more = std::min<Eigen::Index>(answers.cols(), count - filled);
        all.middleCols(filled, more) = answers.leftCols(more).colwise().normalized();
        filled += more;
    }
    return Eigen::MatrixXd(all.householderQr().householderQ() * Eigen::MatrixXd::Identity(bodies * nodes, count));
}

Eigen::MatrixXd rows_of(const Eigen::MatrixXd& states, const Nodes& of, double area)
{
    Eigen::MatrixXd result(states.cols(), static_cast<Eigen::Index>(of.size()));
    for (std::size_t k = 0; k < of.size(); ++k)
        result.col(static_cast<Eigen::Index>(k)) =
            std::sqrt(area / static_cast<double>(of.size()) / capacity) * states.row(of[k]).transpose();
    return result;
}

DenseTerms terms_of(const Press& press, int count)
{
    const Eigen::MatrixXd states = states_of(press, count);
    DenseTerms terms;
    auto& layout = terms.geometry.layout;
    layout = {joints, bodies, films, 0, 8};
    terms.solid = states.transpose() * press.solid * states;
    terms.uniform = std::sqrt(capacity) * states.colwise().sum().transpose();
    terms.functionals = reduce::RowMatrix::Zero(static_cast<Eigen::Index>(layout.count()), count);
    const auto set = [&](std::size_t functional, const Nodes& of, double factor) {
        terms.functionals.row(static_cast<Eigen::Index>(functional)) = factor * mean_of(of).transpose() * states;
    };
    for (std::size_t j = 0; j < joints; ++j) {
        const Eigen::MatrixXd a = rows_of(states, press.a[j], joint_area), b = rows_of(states, press.b[j], joint_area);
        terms.joints.push_back({{a}, {b}, {a - b}, {}});
        terms.geometry.interface_names.push_back("joint");
        terms.geometry.interface_area.push_back(joint_area);
        set(layout.mean(j, false), press.a[j], 1);
        set(layout.mean(j, true), press.b[j], 1);
    }
    for (std::size_t f = 0; f < films; ++f) {
        terms.films.push_back({rows_of(states, press.surfaces[f], film_area)});
        terms.geometry.surface_area.push_back(film_area);
        set(layout.surface(f), press.surfaces[f], film_area);
    }
    for (std::size_t p = 0; p < bodies; ++p) {
        Nodes all(nodes);
        std::iota(all.begin(), all.end(), static_cast<int>(p) * nodes);
        set(layout.part(p), all, 1);
    }
    for (std::size_t p = 0; p < 8; ++p)
        set(layout.probe(p), {static_cast<int>(p) * 2 * nodes + 5}, 1);
    return terms;
}

LawValue natural_convection(double surface, double air)
{
    const double rise = std::hypot(surface - air, 0.1), value = 1.42 * std::sqrt(std::sqrt(rise / 0.5));
    return {value, 0.25 * value * (surface - air) / (rise * rise), true};
}

HeatProblem problem_of(bool following, double fixed_step)
{
    HeatProblem result;
    for (int i = 0; i < joints; ++i) {
        InterfaceLaw law;
        law.film_a = 3000 + 100 * i;
        law.film_b = 5000;
        law.oil = 300;
        law.oil_temperature = 300;
        law.source = i % sources;
        result.interfaces.push_back(law);
    }
    for (int r = 0; r < sources; ++r)
        result.sources.push_back({"row " + std::to_string(r), 1, {}, {}});
    for (int f = 0; f < films; ++f) {
        result.surfaces.push_back(lumps::film(5 + 0.1 * f));
        if (following) {
            result.surfaces.back().emissivity = 0.6;
            result.surfaces.back().laws.emplace_back(
                [](double air) -> FilmLaw { return [air](double t) { return natural_convection(t, air); }; });
        }
    }
    result.segments = {lumps::segment(result, 3 * 3600.0, 293)};
    result.segments[0].ambient = [](double time) { return 293 + 3 * std::sin(time / 150); };
    for (auto& heat : result.segments[0].heat)
        heat = LawTable([](double t) {
            const double watts = 4000 * std::exp(-0.02 * (t - 293));
            return LawValue{watts, -0.02 * watts, true};
        });
    result.time_tolerance = 0.02;
    result.fixed_step = fixed_step;
    return result;
}

using Terms = std::shared_ptr<const reduce::PreparedTerms>;

/// @param new_matrix  each run has a conductance that no run before had, so that it sums and reduces its own matrix
void measure(const Terms& terms, const char* what, bool following, double fixed_step, bool new_matrix = true)
{
    auto problem = problem_of(following, fixed_step);
    std::vector<double> milliseconds;
    ThermalHistory history;
    for (int r = 0; r < 51; ++r) {
        if (new_matrix)
            problem.interfaces[0].film_a = std::nextafter(problem.interfaces[0].film_a, 1e9);
        const auto begin = std::chrono::steady_clock::now();
        reduce::DenseSystem system(terms, problem);
        heat::HeatRun<reduce::DenseSystem> run(system, problem);
        run.temperature() = 293 * system.parts().uniform;
        run.set_media({}, {});
        lumps::Quiet observer;
        run.begin();
        history = run.go({}, observer);
        milliseconds.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(milliseconds);
    std::printf(
        "%td states, %s: %zu steps, %d solves, %.2f ms (fastest %.2f ms); probe at the end %.9f K, balance %.1e\n",
        terms->terms.uniform.size(), what, history.time.size() - 1, history.linear_solves,
        milliseconds[milliseconds.size() / 2], milliseconds.front(), history.probes[0].value.back(),
        history.energy.mismatch());
}

}  // namespace

int main()
{
    const Press press;
    for (const int states : {200, 300}) {
        const auto terms = std::make_shared<const reduce::PreparedTerms>(terms_of(press, states));
        measure(terms, "adaptive steps", false, 0);
        measure(terms, "adaptive steps on a matrix that another run made", false, 0, false);
        measure(terms, "86 equal steps", false, 3 * 3600.0 / 86);
        measure(terms, "films that follow the temperature", true, 0);
    }
}
