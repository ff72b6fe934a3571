/// Requirement: mistakes that independent checks find are thrown together, each with the path of its key, and by the
/// kind of the worst.
#include "deadpoint/core/mistakes.hpp"

#include "../messages.hpp"

#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

std::vector<Diagnostic> found_in(const Mistakes& mistakes)
{
    try {
        mistakes.raise();
    } catch (const CaseError& error) {
        return error.diagnostics();
    } catch (const CaseDomainError& error) {
        return error.diagnostics();
    }
    return {};
}

}  // namespace

TEST_CASE("checks without a mistake raise nothing")
{
    Mistakes mistakes;
    CHECK(mistakes.attempt("parts.bed", [] {}));
    CHECK(mistakes.empty());
    CHECK_NOTHROW(mistakes.raise());
}

TEST_CASE("mistakes of several checks come together, each with its path, message and help")
{
    Mistakes mistakes("geometry");
    mistakes.add("parts.bed", "it is flat", "make it thicker");
    CHECK_FALSE(mistakes.attempt("parts.rod", [] { throw InputError("it is bent\n  help: straighten it"); }));
    CHECK_FALSE(mistakes.attempt("parts", [] { throw mistake("parts.pin.size", "it is odd"); }));
    const auto found = found_in(mistakes);
    REQUIRE(found.size() == 3);
    CHECK(found[0].path == "parts.bed");
    CHECK(found[0].code == "geometry");
    CHECK(found[0].help == "make it thicker");
    CHECK(found[1].path == "parts.rod");
    CHECK(found[1].message == "it is bent");
    CHECK(found[1].help == "straighten it");
    CHECK(found[2].path == "parts.pin.size");  // an error that knows its key keeps it
    CHECK(messages::error_of<CaseError>([&] { mistakes.raise(); }) == "parts.bed: it is flat\n  help: make it thicker\n"
                                                                      "parts.rod: it is bent\n  help: straighten it\n"
                                                                      "parts.pin.size: it is odd");
}

TEST_CASE("a mistake that several checks meet is told once")
{
    Mistakes mistakes;
    for (int segment = 0; segment < 3; ++segment)
        mistakes.attempt("operation", [] { throw mistake("joints.pin", "it is loose"); });
    mistakes.add("joints.pin", "it is long");
    CHECK(found_in(mistakes).size() == 2);
}

TEST_CASE("values out of range keep their kind, unless something is wrong input")
{
    Mistakes mistakes;
    mistakes.attempt("lubricants.oil", [] { throw DomainError("too cold"); });
    CHECK_THROWS_AS(mistakes.raise(), CaseDomainError);
    CHECK(found_in(mistakes).front().code == "out-of-range");
    mistakes.add("joints.pin", "it is loose");
    CHECK_THROWS_AS(mistakes.raise(), CaseError);
    CHECK(found_in(mistakes).size() == 2);
}

TEST_CASE("errors that are not about the case pass through")
{
    Mistakes mistakes;
    CHECK_THROWS_AS(mistakes.attempt("parts.bed", [] { throw IoError("no such file"); }), IoError);
    CHECK_THROWS_AS(mistakes.attempt("parts.bed", [] { throw ConvergenceError("no end"); }), ConvergenceError);
    CHECK(mistakes.empty());
}

TEST_CASE("about() names the key of an error that has none, and returns what the action returns")
{
    CHECK(about("joints", [] { return 3; }) == 3);
    CHECK(messages::error_of<CaseError>([] { about("joints", [] { throw InputError("it is loose"); }); }) ==
          "joints: it is loose");
    CHECK(messages::error_of<CaseDomainError>([] {
              about("surfaces", [] { about("surfaces.air", [] { throw DomainError("too hot"); }); });
          }) == "surfaces.air: too hot");
}

TEST_CASE("the name of an interface leads to its place in a case")
{
    CHECK(interface_path("crank.bush") == "joints.crank.interfaces.bush");
    CHECK(interface_path("bush") == "joints");
}
