/// Requirement: a law has its own keys. Those of another law are refused unless they say what a case without them says,
/// as the resolved case does, and whatever is missing or foreign is said at once.
#include "../../scratch_folder.hpp"
#include "../messages.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/casefile/files/write.hpp"
#include "deadpoint/error.hpp"

#include <doctest/doctest.h>
#include <filesystem>
#include <string>
#include <vector>

using namespace deadpoint;
using namespace deadpoint::casefile;
using messages::has;

namespace {

namespace fs = std::filesystem;

const fs::path cases = fs::path(DEADPOINT_SOURCE_DIR) / "cases";

std::string error_of(const std::vector<std::string>& overrides)
{
    return messages::error_of<InputError>([&] { read_case(cases / "starter/case.toml", overrides); });
}

Case starter(const std::vector<std::string>& overrides)
{
    return read_case(cases / "starter/case.toml", overrides).value;
}

}  // namespace

TEST_CASE("resolved cases of every law read back as the same case")
{
    const ScratchFolder scratch;
    for (const auto* name : {"jl75g-60/physics.toml", "starter-by-laws/case.toml"}) {
        CAPTURE(name);
        const auto first = read_case(cases / name, {}, FileAccess::anywhere).value;
        const auto second = read_case(scratch.file("resolved.toml", write_case(first)), {}, FileAccess::anywhere).value;
        CHECK(write_case(second) == write_case(first));
        CHECK(case_hash(second) == case_hash(first));
    }
}

TEST_CASE("a law's keys may be stated with another one at their defaults only")
{
    const std::string pin = "friction.journals={ law = \"pin\", coefficient = 0.1";
    const auto plain = starter({pin + " }"});
    const auto stated =
        starter({pin + ", balls = 0, axial_preload = \"0 kN\", oil_supply = \"bath\", exponent = 1.0 }"});
    CHECK(std::holds_alternative<PinFriction>(stated.friction.at("journals").law));
    CHECK(case_hash(stated) == case_hash(plain));
    for (const auto* foreign : {"balls = 9", "axial_preload = \"1 kN\"", "oil_supply = \"jet\"", "exponent = 0.5",
                                "bearing = \"deep_groove_ball\"", "kind = \"rolling\"", "film_area = \"1 m^2\""}) {
        CAPTURE(foreign);
        const auto message = error_of({pin + ", " + foreign + " }"});
        const std::string text = foreign;
        CHECK(has(message, "law = \"pin\" does not use '" + text.substr(0, text.find(' ')) + "'"));
        CHECK(has(message, "1 error in"));
    }
}

TEST_CASE("all that a law misses and all that it does not use is said together")
{
    const auto message = error_of(
        {"friction.journals={ law = \"palmgren\", lubricant = \"oil\", clearance = \"20 um\", bore = \"80 mm\" }"});
    for (const auto* piece : {"'bearing' is missing for law = \"palmgren\"", "'mean_diameter' is missing",
                              "'static_rating' is missing", "does not use 'clearance'", "does not use 'bore'"}) {
        CHECK(has(message, piece));
    }
    CHECK(has(message, "5 errors in"));
}

TEST_CASE("where no law can be read its keys are known, but not judged")
{
    CHECK(has(error_of({"friction.journals={ law = \"pins\", coefficient = 0.1 }"}), "1 error in"));
    CHECK(has(error_of({"friction.journals={ coefficient = 0.1 }"}), "1 error in"));
    const auto film = error_of({"surfaces.air_frame.film={ coefficient = \"5 W/m^2/K\", length = \"1 m\" }"});
    CHECK(has(film, "'length' belongs to a law, and none is named"));
}

TEST_CASE("names of laws serve every struct")
{
    const auto c = read_case(cases / "starter-by-laws/case.toml").value;
    CHECK(law_name(c.joints.at("guide").interfaces.at(0).conductance) == "cooper_mikic_yovanovich");
    CHECK(law_name(*c.surfaces.at("flywheel_rim").film) == "rotating_cylinder");
    CHECK(law_name(Film{PlateFilm{PlateFilm::Facing::down, true, {}}, {}, 0, {}}) == "paper_horizontal_down");
    CHECK(law_name(Film{FilmCoefficient{5}, {}, 0, {}}).empty());
    CHECK(law_name(Conductance{SideFilms{}}).empty());
}
