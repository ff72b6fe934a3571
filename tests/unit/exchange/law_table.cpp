#include "deadpoint/exchange/laws/law_table.hpp"

#include "deadpoint/error.hpp"
#include "near.hpp"

#include <cmath>
#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

LawValue falling(double t)
{
    const double heat = 400 * std::exp(-0.03 * (t - 293.15));
    return {heat, -0.03 * heat, true};
}

double largest_error(const LawTable& table, double (*exact)(double))
{
    double largest = 0;
    for (int i = 0; i <= 100'003; ++i) {
        const double at = 213.15 + 360.0 * i / 100'003;
        largest = std::max(largest, std::abs(table(at).value - exact(at)) / exact(at));
    }
    return largest;
}

}  // namespace

TEST_CASE("a law as a table keeps the stated tolerance at 1e5 places, and needs fewer points for less")
{
    const LawTable fine(falling), coarse(falling, {213.15, 573.15, 1e-6});
    const auto exact = [](double t) { return falling(t).value; };
    CHECK(largest_error(fine, exact) < 1e-10);
    CHECK(largest_error(coarse, exact) < 1e-6);
    CHECK(coarse.points().size() < fine.points().size() / 4);  // the error is of fourth order: 10 times, by halving
    // The slope of the cubic is of third order.
    CHECK(fine(300).slope == near(falling(300).slope, 1e-7));
}

TEST_CASE("a straight law is two points, exact within and beyond them")
{
    const LawTable table([](double t) { return LawValue{5 - 0.02 * (t - 300), -0.02, true}; });
    CHECK(table.points().size() == 2);
    for (const double at : {1.0, 213.15, 300.0, 573.15, 2000.0})
        CHECK(table(at).value == near(5 - 0.02 * (at - 300), 1e-14));
}

TEST_CASE("a kink is met to its place, a jump becomes a steep line")
{
    const LawTable kink([](double t) {
        return t < 320 ? LawValue{2000 - 40 * (t - 320), -40, true} : LawValue{2000 - 5 * (t - 320), -5, true};
    });
    CHECK(kink(319.9).value == near(2004, 1e-9));
    CHECK(kink(320.1).value == near(1999.5, 1e-9));
    const LawTable jump([](double t) { return LawValue{t < 320 ? 100.0 : 20.0, 0, true}; });
    CHECK(jump(320 - 1e-5).value == 100);
    CHECK(jump(320 + 1e-5).value == 20);
}

TEST_CASE("the tested range of a law is that of its table; where it is not finite, its table ends")
{
    const LawTable table(
        [](double t) {
            if (t <= 250)
                return LawValue{NAN, NAN, false};
            const double value = 100 / (t - 250);
            return LawValue{value, -value / (t - 250), t > 280 && t < 350};
        },
        {240, 400, 1e-6});
    CHECK(table.points().front() > 250);
    CHECK(std::isfinite(table(200).value));
    CHECK_FALSE(table(279.99).in_range);
    CHECK(table(280.01).in_range);
    CHECK(table(349.99).in_range);
    CHECK_FALSE(table(350.01).in_range);
    CHECK_THROWS_AS(LawTable([](double) { return LawValue{NAN, 0, true}; }), DomainError);
}

TEST_CASE("tables are data: compared, hashed, printed; none is none")
{
    const LawTable a(falling), b(falling), c([](double t) { return LawValue{t, 1, true}; });
    CHECK(a == b);
    CHECK(hash_of(a) == hash_of(b));
    CHECK(hash_of(a) != hash_of(c));
    CHECK(text_of(c) == "213.15 213.15000000000001 1\n573.15 573.14999999999998 1\n");
    CHECK_FALSE(LawTable());
    CHECK_FALSE(LawTable(HeatLaw()));
    CHECK(a);
}

TEST_CASE("a formula is data: printed with all digits, hashed, compared")
{
    const LawFormula film{"air film", {{"speed", 0.1}, {"emissivity", 0.9}}};
    CHECK(text_of(film) == "air film: speed = 0.10000000000000001, emissivity = 0.90000000000000002");
    CHECK(hash_of(film) == hash_of(LawFormula(film)));
    CHECK(hash_of(film) != hash_of({"air film", {{"speed", 0.1}, {"emissivity", 0.8}}}));
}

TEST_CASE("a table times a factor, plus an offset, is that of the law times the factor, plus the offset")
{
    const LawTable table = LawTable(falling).affine(0.25, 30);
    CHECK(largest_error(table, [](double t) { return 30 + 0.25 * falling(t).value; }) < 1e-10);
    CHECK(table(300).slope == near(0.25 * falling(300).slope, 1e-7));
    CHECK(table.points() == LawTable(falling).points());
    CHECK(!table(600).in_range);
}
