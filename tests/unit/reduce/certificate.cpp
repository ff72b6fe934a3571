#include "deadpoint/reduce/certificate/certificate.hpp"

#include "deadpoint/error.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/reduce/certificate/bends.hpp"
#include "deadpoint/reduce/certificate/lowest.hpp"
#include "deadpoint/reduce/certificate/residual_file.hpp"
#include "deadpoint/reduce/certificate/residual_terms.hpp"
#include "deadpoint/reduce/kept/build_checkpoint.hpp"
#include "deadpoint/reduce/offline/training.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "near.hpp"
#include "rods.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;
using namespace deadpoint::reduce;

namespace {

using Terms = std::shared_ptr<const PreparedTerms>;

/// A basis too small for its task, so that its error is seen.
struct Certified {
    Certified()
    {
        lumps::Quiet observer;
        auto options = rods::options();
        options.sets = 8;
        options.certificate = true;
        options.largest = 6;
        models = build(full, {rods::problem()}, rods::box(), options, {}, observer).value();
    }
    rods::RodModel full;
    BuiltModels models;
};

const Certified& certified()
{
    static const Certified once;
    return once;
}

ThermalHistory run_on(const Terms& terms, const HeatProblem& problem)
{
    lumps::Quiet observer;
    return ReducedRun(terms, problem, 1, 293).go({}, observer);
}

std::vector<heat::Loads> outputs()
{
    const auto& layout = certified().models.large->terms.geometry.layout;
    return {{{layout.probe(1), 1}}, {{layout.count(), 1}}};
}

Eigen::MatrixXd conduction(const DenseTerms& terms, const HeatProblem& problem)
{
    const auto coefficients = coefficients_of(problem, HeatSegment{});
    const auto& joint = terms.joints[0];
    Eigen::MatrixXd result = terms.solid;
    std::size_t q = 0;
    for (const auto* term : {&joint.aa, &joint.bb, &joint.between, &joint.turning}) {
        if (!term->is_missing())
            result += coefficients[q] * term->factor * term->factor.transpose();
        ++q;
    }
    for (const auto& film : terms.films)
        result += coefficients[q++] * film.factor * film.factor.transpose();
    return result;
}

double smallest_eigenvalue(const Eigen::MatrixXd& matrix)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace

TEST_CASE("the lowest conduction of a box is below that of all its values")
{
    auto base = rods::problem();
    base.segments[0].interfaces = base.interfaces;
    base.segments[0].interfaces[0].film_a /= 4;  // a segment of its own law
    const auto terms = rods::full_terms();
    const auto lowest = conduction(terms, lowest_conduction(base, rods::box()));
    CHECK(smallest_eigenvalue(lowest) > 0);
    Draws draws(5);
    for (int k = 0; k < 20; ++k) {
        auto problem = base;
        set_values(problem, rods::box(), draws.values(rods::box()));
        for (const auto& laws : {problem.interfaces, problem.segments[0].interfaces}) {
            problem.interfaces = laws;
            const auto there = conduction(terms, problem);
            CHECK(smallest_eigenvalue(there - lowest) > -1e-12 * there.norm());  // rounding
        }
    }
}

TEST_CASE("a joint's lowest coefficients are those of the corners where each is smallest")
{
    const auto lowest = lowest_conduction(rods::problem(), rods::box());
    const auto coefficients = coefficients_of(lowest, HeatSegment{});
    // a: 300 to 30000, b: 200 to 20000, oil: 0 to 1500 W/m2/K
    CHECK(coefficients[0] == 0);
    CHECK(coefficients[1] == 0);
    CHECK(coefficients[2] == near(300. * 200 / 2000, 1e-12));
    CHECK(coefficients[4] == near(2.4, 1e-12));  // 0.2 of 12

    auto box = rods::box();
    box[4].from = 0.5;  // oil: 150 to 1500
    const auto with_oil = coefficients_of(lowest_conduction(rods::problem(), box), HeatSegment{});
    CHECK(with_oil[0] == near(300. * 150 / (300 + 20000 + 150), 1e-12));
    CHECK(with_oil[1] == near(200. * 150 / (200 + 30000 + 150), 1e-12));
    CHECK(with_oil[2] == near(300. * 200 / 2000, 1e-12));
}

TEST_CASE("sizes of residuals are those of the full system, or a little above")
{
    const auto& residual = *certified().models.residual;
    const auto loads = uniform_loads(certified().models.large->terms, residual);
    const auto terms = rods::full_terms();
    // a functional alone, whose vector is known
    const auto lowest = lowest_conduction(rods::problem(), rods::box());
    Draws draws(7);
    for (int k = 0; k < 10; ++k) {
        auto problem = rods::problem();
        set_values(problem, rods::box(), draws.values(rods::box()));
        if (k == 0)
            problem = lowest;
        const Eigen::LLT<Eigen::MatrixXd> factor(conduction(terms, problem));
        const ResidualNorm norm(residual, loads, coefficients_of(problem, HeatSegment{}));
        Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(residual.count(), residual.functionals + residual.observed);
        columns.bottomRows(columns.cols()).setIdentity();
        const auto squares = norm.squares(residual.root.triangularView<Eigen::Upper>() * columns);
        for (Eigen::Index f = 0; f < residual.functionals; ++f) {
            const Eigen::VectorXd load = terms.functionals.row(f).transpose();
            const double exact = load.dot(factor.solve(load));
            CHECK(squares[f] >= exact * (1 - 1e-9));
            CHECK(squares[f] <= exact * 1.0001 + 1e-12);  // joint and films of the rods have few directions, all kept
        }
    }
}

TEST_CASE("bounds hold, with coefficients that the build never saw")
{
    const auto terms = std::make_shared<const PreparedTerms>(rods::full_terms());
    const auto& models = certified().models;
    Draws draws(41);
    double largest = 0;
    for (int k = 0; k < 20; ++k) {
        const auto problem = drawn_problem({rods::problem()}, rods::box(), draws);
        const auto large = run_on(models.large, problem), exact = run_on(terms, problem);
        const auto certificate = certify(models.large, *models.residual, problem, large.time, outputs());
        REQUIRE(certificate.refused.empty());
        const double probe = std::abs(large.probes[1].value.back() - exact.probes[1].value.back());
        const double gap = std::abs(large.functionals[0].value.back() - exact.functionals[0].value.back());
        CHECK(certificate.bounds[0] >= probe);
        CHECK(certificate.bounds[1] >= gap);
        largest = std::max(largest, certificate.bounds[1]);
        CHECK(certificate.bounds[1] < 1e-6);  // E_SW is 1 um/K: below 1 K, as far as the small basis is off
    }
    MESSAGE("largest bound of the gap " << largest);
}

TEST_CASE("the bound of an output is the same beside how many others")
{
    const auto& models = certified().models;
    const auto large = run_on(models.large, rods::problem());
    const auto bounds = [&](const std::vector<heat::Loads>& asked) {
        return certify(models.large, *models.residual, rods::problem(), large.time, asked).bounds;
    };
    const std::vector<double> alone{bounds({outputs()[0]})[0], bounds({outputs()[1]})[0]};
    std::vector<heat::Loads> many;  // more steps of outputs than are worked on at once
    while (many.size() * large.time.size() < 3000)
        many.push_back(outputs()[many.size() % 2]);
    const auto found = bounds(many);
    REQUIRE(found.size() == many.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        CHECK(found[k] == near(alone[k % 2], 1e-9));  // rounding of sums of some thousand products
}

TEST_CASE("a law that is not straight adds to the bound where it bends")
{
    const auto terms = std::make_shared<const PreparedTerms>(rods::full_terms());
    const auto& models = certified().models;
    const auto bound_with = [&](double jump, double at) {
        auto problem = rods::problem();
        problem.segments[0].heat[0] = [=](double t) {
            return LawValue{60 - 0.4 * (t - 293) - (t > at ? jump * (t - at) : 0), -0.4 - (t > at ? jump : 0), true};
        };
        const auto large = run_on(models.large, problem), exact = run_on(terms, problem);
        const auto found = certify(models.large, *models.residual, problem, large.time, outputs());
        CHECK(found.bounds[1] >= std::abs(large.functionals[0].value.back() - exact.functionals[0].value.back()));
        return found.bounds[1];
    };
    const double end = run_on(models.large, rods::problem()).source_temperature[0].back();
    const double straight = bound_with(0, end), kinked = bound_with(0.1, end - 0.01);
    MESSAGE(straight << " " << kinked);
    CHECK(kinked > 1.2 * straight);
    CHECK(bound_with(0.1, end + 20) == near(straight, 1e-9));  // more than 5 K from all temperatures
}

TEST_CASE("a law that jumps adds what its jump may heat")
{
    const auto terms = std::make_shared<const PreparedTerms>(rods::full_terms());
    const auto& models = certified().models;
    const double end = run_on(models.large, rods::problem()).source_temperature[0].back();
    const auto bound_with = [&](double jump) {
        auto problem = rods::problem();
        problem.segments[0].heat[0] = [=](double t) {
            return LawValue{60 - 0.4 * (t - 293) + (t > end - 0.01 ? jump : 0), -0.4, true};
        };
        const auto large = run_on(models.large, problem), exact = run_on(terms, problem);
        const auto found = certify(models.large, *models.residual, problem, large.time, outputs());
        REQUIRE(found.refused.empty());
        CHECK(found.bounds[1] >= std::abs(large.functionals[0].value.back() - exact.functionals[0].value.back()));
        return found.bounds[1];
    };
    // twice the jump may heat twice as much; without it there is the rest of the bound alone
    const double none = bound_with(0), once = bound_with(0.01), twice = bound_with(0.02);
    MESSAGE(none << " " << once << " " << twice);
    CHECK(once > 1.2 * none);
    CHECK(twice - none == near(2 * (once - none), 0.1));
}

TEST_CASE("no error that falling heat allows makes more of bent laws than their bound")
{
    Draws draws(17);
    const auto between = [&](double least, double most) { return least * std::pow(most / least, draws.next()); };
    for (int round = 0; round < 200; ++round) {
        std::vector<BentLaw> laws(1 + static_cast<std::size_t>(6 * draws.next()));
        for (auto& law : laws)
            law = {between(10, 1000), between(1e-3, 1), between(1e-3, 10), between(1e-2, 1), between(1e-2, 1)};
        const double energy = between(1e-4, 1e4), bound = largest_of_bent(laws, energy);
        double largest = 0;
        std::vector<double> share(laws.size());
        const auto sum_of = [&] {
            double whole = 0, sum = 0;
            for (const double s : share)
                whole += s;
            for (std::size_t k = 0; k < laws.size(); ++k) {
                const auto& law = laws[k];
                const double e = std::sqrt(share[k] / whole * energy / (law.duration * law.fall));
                sum += law.duration * law.seen * std::min(law.curvature / 2 * e * e, law.bend * e);
            }
            return sum;
        };
        for (std::size_t k = 0; k < laws.size(); ++k) {  // all of it for one
            share.assign(laws.size(), 0);
            share[k] = 1;
            largest = std::max(largest, sum_of());
        }
        for (std::size_t k = 0; k < laws.size(); ++k)  // what is best where all count by their bends
            share[k] = laws[k].duration * std::pow(laws[k].seen * laws[k].bend, 2) / laws[k].fall;
        largest = std::max(largest, sum_of());
        for (int attempt = 0; attempt < 100; ++attempt) {
            for (double& s : share)
                s = between(1e-4, 1);
            largest = std::max(largest, sum_of());
        }
        CHECK(largest <= bound * (1 + 1e-12));
        CHECK(bound <= 3 * largest);  // each of the two parts is reached by some errors; both together hardly
    }
    CHECK(largest_of_bent({}, 1) == 0);
    CHECK(largest_of_bent({{10, 0.5, 4, 1e9, 2}}, 7) == near(0.5 * 4 / 2. / 2 * 7, 1e-5));  // by its curvature
    CHECK(largest_of_bent({{10, 0.5, 1e9, 3, 2}}, 7) == near(0.5 * 3 * std::sqrt(10 / 2. * 7), 1e-5));  // by its bend
}

TEST_CASE("what the vectors of the terms leave out is in the remainder")
{
    lumps::Quiet observer;
    rods::RodModel full;
    auto options = rods::options();
    options.certificate = true;
    options.residual.left = 1e-3;
    options.largest = 6;
    const auto models = build(full, {rods::problem()}, rods::box(), options, {}, observer).value();
    const auto& residual = *models.residual;
    const auto& reduced = models.large->terms;
    CHECK(residual.factors.cols() < reduced.uniform.size() / 2);
    const auto loads = uniform_loads(reduced, residual);
    Draws draws(9);
    bool matters = false;
    for (int k = 0; k < 10; ++k) {
        auto problem = rods::problem();
        set_values(problem, rods::box(), draws.values(rods::box()));
        const ResidualNorm norm(residual, loads, coefficients_of(problem, HeatSegment{}));
        Eigen::VectorXd states(reduced.uniform.size());
        for (double& x : states)
            x = draws.next() - 0.5;
        const auto seen = seen_by_terms(residual, loads, states);
        // |K V x| in K^-1 is |V x| in K
        const Eigen::MatrixXd on_basis = conduction(reduced, problem);
        const double exact = std::sqrt(states.dot(on_basis * states));
        const double kept =
            std::sqrt(norm.squares(residual.root.triangularView<Eigen::Upper>() * norm.conducted(seen))[0]);
        const double rest = std::sqrt(norm.remainder_squares(seen)[0]);
        CHECK(kept + rest >= exact * (1 - 1e-6));
        matters |= kept < 0.9 * exact;
    }
    CHECK(matters);
}

TEST_CASE("a certificate is refused where its assumptions fail")
{
    const auto& models = certified().models;
    const auto refused = [&](const HeatProblem& problem) {
        return certify(models.large, *models.residual, problem, {0, 60, 120}, outputs()).refused;
    };
    CHECK(refused(rods::problem()) == "");
    auto rising = rods::problem();
    rising.segments[0].heat[0] = [](double t) { return LawValue{60 + 400 * (t - 293), 400, true}; };
    CHECK(refused(rising).find("rises") != std::string::npos);
    auto follows = rods::problem();
    follows.surfaces[1].emissivity = 0.5;
    CHECK(refused(follows).find("follows its temperature") != std::string::npos);
    auto below = rods::problem();
    below.surfaces[0].coefficient = 0.1;
    CHECK(refused(below).find("below the range") != std::string::npos);
    auto rings = rods::problem();
    rings.segments[0].ring_heat = {[](double) { return 1.0; }};
    CHECK(refused(rings).find("rings") != std::string::npos);
}

TEST_CASE("the bound vanishes as the basis comes to span the full system")
{
    rods::RodModel full;
    lumps::Quiet observer;
    auto options = rods::options();
    options.sets = 24;
    options.certificate = true;
    options.largest = 6;
    const auto models = build(full, {rods::problem()}, rods::box(), options, {}, observer).value();
    const auto large = run_on(models.large, rods::problem());
    const auto certificate = certify(models.large, *models.residual, rods::problem(), large.time, outputs());
    CHECK(certificate.bounds[1] < 2e-10);  // rounding and Newton's tolerance: 1e-5 of the heat, whose E_SW is 20 um
    MESSAGE(certificate.bounds[1] << " " << certificate.bounds[0]);
}

TEST_CASE("a certificate that went through its file gives the same bounds")
{
    const auto& models = certified().models;
    const auto& residual = *models.residual;
    const auto& terms = models.large->terms;
    const ResidualSizes sizes{
        static_cast<std::uint64_t>(residual.states), static_cast<std::uint64_t>(residual.functionals),
        static_cast<std::uint64_t>(residual.observed), 4 * terms.joints.size() + terms.films.size() + 1};
    const auto again = restored(stored(residual), sizes);
    const auto large = run_on(models.large, rods::problem());
    const auto before = certify(models.large, *models.residual, rods::problem(), large.time, outputs());
    const auto after = certify(models.large, again, rods::problem(), large.time, outputs());
    for (std::size_t k = 0; k < outputs().size(); ++k)
        CHECK(after.bounds[k] == near(before.bounds[k], 5e-4));  // 32 bits a number, and residuals are differences
    const auto refused = [&](auto&& change) {
        auto changed = stored(residual);
        change(changed);
        CHECK_THROWS_AS(restored(changed, sizes), InputError);
    };
    refused([](StoredResidual& r) { r.root.pop_back(); });
    refused([](StoredResidual& r) { r.first[2] = 1000; });
    refused([](StoredResidual& r) { r.functionals = ~std::uint64_t{0}; });
    refused([](StoredResidual& r) { r.observed += 1; });
    refused([](StoredResidual& r) { r.lowest[0] = -1; });
    refused([](StoredResidual& r) { r.factors.rows = std::uint64_t{1} << 63; });
    refused([](StoredResidual& r) { r.remainder = {std::uint64_t{1} << 40, 0, {}}; });
    refused([](StoredResidual& r) { r.products.rows = 0; });
}

TEST_CASE("the bound of a sum of outputs is at most the sum of their bounds, and its value their values'")
{
    const auto& models = certified().models;
    const auto large = run_on(models.large, rods::problem());
    auto asked = outputs();
    const double factor = -2e-6;
    asked.push_back({{asked[0][0].functional, factor}, {asked[1][0].functional, 1}});
    asked.push_back({{asked[0][0].functional, factor}});
    const auto found = certify(models.large, *models.residual, rods::problem(), large.time, asked);
    REQUIRE(found.refused.empty());
    // Rounding of the products in single precision of which the bounds are made.
    CHECK(found.bounds[3] == near(std::abs(factor) * found.bounds[0], 1e-6));
    CHECK(found.bounds[2] <= (found.bounds[1] + found.bounds[3]) * (1 + 1e-6));
    CHECK(found.bounds[2] > 0);
    CHECK(found.values[2] == near(found.values[1] + found.values[3], 1e-12));
    CHECK(found.values[3] == near(factor * found.values[0], 1e-12));
    CHECK(found.values[0] == near(large.probes[1].value.back(), 0, 0.1));  // other steps between the same times
}
