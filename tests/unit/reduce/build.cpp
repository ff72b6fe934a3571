#include "deadpoint/reduce/offline/build.hpp"

#include "../../scratch_folder.hpp"
#include "deadpoint/exchange/heat_causes.hpp"
#include "deadpoint/reduce/kept/build_checkpoint.hpp"
#include "deadpoint/reduce/offline/training.hpp"
#include "deadpoint/reduce/online/reduced_run.hpp"
#include "deadpoint/reduce/online/terms_file.hpp"
#include "near.hpp"
#include "rods.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <iterator>
#include <numeric>

using namespace deadpoint;
using namespace deadpoint::reduce;

namespace {

using Terms = std::shared_ptr<const PreparedTerms>;

Terms prepared(DenseTerms terms) { return std::make_shared<const PreparedTerms>(std::move(terms)); }

ThermalHistory run_on(const Terms& terms, const HeatProblem& problem)
{
    lumps::Quiet observer;
    return ReducedRun(terms, problem, 1, 293).go({}, observer);
}

BuiltModels built(rods::RodModel& full)
{
    lumps::Quiet observer;
    return build(full, {rods::problem()}, rods::box(), rods::options(), {}, observer).value();
}

/// Cancelled after so many reports of progress.
class StoppingObserver : public lumps::Quiet {
public:
    explicit StoppingObserver(int reports) : left_(reports) {}
    void progress(double, std::string_view) override { --left_; }
    [[nodiscard]] bool cancelled() const override { return left_ <= 0; }

private:
    int left_;
};

std::vector<HeatProblem> new_problems()
{
    Draws draws(99);
    std::vector<HeatProblem> result{rods::problem()};
    for (int k = 0; k < 8; ++k)
        result.push_back(drawn_problem({rods::problem()}, rods::box(), draws));
    return result;
}

}  // namespace

TEST_CASE("a reduced model answers as the full one, with coefficients it never saw")
{
    rods::RodModel full;
    const auto models = built(full);
    CHECK(models.small.terms->terms.uniform.size() <= 20);
    const auto terms = prepared(rods::full_terms());
    for (const auto& problem : new_problems()) {
        const auto exact = run_on(terms, problem);
        const auto small = difference(run_on(models.small.terms, problem), exact, 0);
        const auto large = difference(run_on(models.large, problem), exact, 0);
        const auto estimate = difference(run_on(models.small.terms, problem), run_on(models.large, problem), 0);
        CHECK(small.temperature < 0.1);   // twice what was asked for in the test runs of the build
        CHECK(large.temperature < 1e-3);  // its fields span nearly all 60 states of the full model
        CHECK(std::abs(estimate.temperature - small.temperature) <= large.temperature + 1e-12);
        CHECK(std::abs(estimate.gap - small.gap) <= large.gap + 1e-15);
    }
}

TEST_CASE("a build that is stopped anywhere goes on to the same model bit by bit")
{
    const auto wanted = [] {
        rods::RodModel full;
        return stored(built(full).small.terms->terms);
    }();
    const ScratchFolder folder;
    const auto attempt = [&](int until) {
        rods::RodModel full;
        StoppingObserver observer(until);
        const BuildCheckpoint kept(folder.path, "this build", true, [](const std::string& text) { FAIL(text); });
        return build(full, {rods::problem()}, rods::box(), rods::options(), kept, observer);
    };
    const auto pieces = [&] { return std::distance(std::filesystem::directory_iterator(folder.path), {}); };
    CHECK_FALSE(attempt(5).has_value());
    CHECK(pieces() == 5);
    CHECK_FALSE(attempt(5 + 3).has_value());  // kept sets count too
    CHECK(pieces() == 8);
    CHECK_FALSE(attempt(24 + 7).has_value());  // in the training runs
    CHECK(pieces() == 24 + 2);                 // sets, basis, terms
    const auto models = attempt(1 << 20);
    REQUIRE(models.has_value());
    CHECK(pieces() == 24 + 3);
    const auto found = stored(models->small.terms->terms);
    CHECK(found.solid == wanted.solid);
    REQUIRE(found.joints.size() == wanted.joints.size());
    for (std::size_t k = 0; k < found.joints.size(); ++k)
        CHECK(found.joints[k].entries == wanted.joints[k].entries);
    CHECK(found.observed.entries == wanted.observed.entries);

    const BuildCheckpoint other(folder.path, "another build", true, {});
    rods::RodModel full;
    lumps::Quiet observer;
    CHECK_THROWS_AS(build(full, {rods::problem()}, rods::box(), rods::options(), other, observer), InputError);
    std::filesystem::resize_file(folder.path / "training.bin", 100);
    CHECK_THROWS_AS(attempt(1 << 20), IoError);
}

TEST_CASE("the small model is the smallest that is accurate enough")
{
    rods::RodModel full;
    auto options = rods::options();
    lumps::Quiet observer;
    options.temperature = options.gap = 0;
    const auto finest = build(full, {rods::problem()}, rods::box(), options, {}, observer).value();
    CHECK(finest.small.terms->terms.uniform.size() == 20);
    CHECK(full.basis.cols() == 20);
    CHECK((full.basis.transpose() * full.basis - Eigen::MatrixXd::Identity(20, 20)).norm() < 1e-9);
    REQUIRE(finest.small.by_size.size() == 1);
    CHECK(finest.small.by_size[0].second.temperature == finest.small.in_box.temperature);
}

TEST_CASE("heat is conserved, and causes sum to the gap")
{
    rods::RodModel full;
    const auto models = built(full);
    for (const auto& problem : new_problems()) {
        lumps::Quiet observer;
        ReducedRun run(models.small.terms, problem, 1, 293);
        const auto history = run.go({}, observer);
        CHECK(history.energy.mismatch() < 1e-9);
        const auto causes = run.causes(models.small.terms->terms.observed.row(0).transpose(), history.time.size() - 1);
        const auto sum = [](const std::vector<double>& values) {
            return std::accumulate(values.begin(), values.end(), 0.0);
        };
        const double all = sum(causes.friction) + sum(causes.oil) + sum(causes.surfaces) + causes.start;
        CHECK(all == near(history.functionals[0].value.back(), 1e-9, 1e-9 * 1e-6));
    }
}

TEST_CASE("a run whose conduction is summed of factors is that of sums of matrices")
{
    rods::RodModel full;
    const auto models = built(full);
    const auto few = std::make_shared<const PreparedTerms>(models.small.terms->terms, Sums::of_factors);
    for (const auto& problem : new_problems()) {
        const auto one = run_on(few, problem), other = run_on(models.small.terms, problem);
        const auto off = difference(one, other, 0);
        CHECK(off.temperature < 1e-9);  // 300 K times rounding, some thousand times
        CHECK(off.gap < 1e-9 * std::abs(other.functionals[0].value.back()));
    }
}

TEST_CASE("an error in the first minute of a segment does not count, but at the end of a shorter one")
{
    ThermalHistory one, other;
    one.time = other.time = {0, 30, 100, 100, 130, 200};
    one.probes = {{{0, 5, 1, 1, 7, 1}, {0, 0, 0, 0, 0, 0}}};
    other.probes = {{{0, 0, 0.5, 0.5, 0, 0.75}, {0, 0, 0, 0, 0, 0}}};
    CHECK(difference(one, other, SIZE_MAX).temperature == near(0.5, 1e-5));
    for (auto* run : {&one, &other}) {  // a last segment of 30 s: its end counts
        run->time.pop_back();
        run->probes[0].value.pop_back();
        run->probes[0].rate.pop_back();
    }
    CHECK(difference(one, other, SIZE_MAX).temperature == near(7, 1e-5));
}

TEST_CASE("an error between two steps of one run is found at the steps of the other, whichever comes first")
{
    ThermalHistory coarse, fine;
    coarse.time = {0, 100, 200};
    coarse.probes = {{{0, 0, 0}, {0, 0, 0}}};
    fine.time = {0, 100, 150, 200};
    fine.probes = {{{0, 0, 3, 0}, {0, 0, 0, 0}}};
    CHECK(difference(coarse, fine, SIZE_MAX).temperature == near(3, 1e-5));
    CHECK(difference(fine, coarse, SIZE_MAX).temperature == near(3, 1e-5));
}

TEST_CASE("terms survive their way into a file")
{
    rods::RodModel full;
    const auto models = built(full);
    const auto kept = stored(models.small.terms->terms);
    DenseTerms again;
    again.geometry = models.small.terms->terms.geometry;
    restore(kept, again);
    CHECK((again.solid - models.small.terms->terms.solid).norm() < 1e-12 * models.small.terms->terms.solid.norm());
    CHECK(kept.solid.size() == static_cast<std::size_t>(again.uniform.size()));  // its diagonal, and no more
    CHECK(std::ranges::is_sorted(kept.solid.begin() + 1, kept.solid.end()));
    const auto problem = new_problems()[3];
    const auto difference_by_rounding =
        difference(run_on(prepared(again), problem), run_on(models.small.terms, problem), 0);
    CHECK(difference_by_rounding.temperature < 1e-3);  // 300 K times the rounding of 32 bits, some ten times
    CHECK(difference_by_rounding.gap < 1e-9);

    const auto& large = models.large->terms;
    restore(stored(large), again);
    CHECK((again.solid - large.solid).norm() < 1e-15 * large.solid.norm());  // a triangle, of 64 bits
    restore(kept, again);

    auto broken = kept;
    broken.solid.pop_back();
    CHECK_THROWS_WITH_AS(restore(broken, again),
                         "the solid of a reduced model has another number of entries than states", InputError);
    broken = kept;
    broken.films[0].entries.pop_back();
    CHECK_THROWS_AS(restore(broken, again), InputError);
}
