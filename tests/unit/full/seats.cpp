/// Requirement: only seats and journals that carry a joint have a part in the dimension chain.
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/drift/corners.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/drift/chain_model.hpp"
#include "deadpoint/press/drift/gap_model.hpp"
#include "near.hpp"

#include <algorithm>
#include <doctest/doctest.h>

using namespace deadpoint;

namespace {

casefile::Case made_press(const std::vector<std::string>& more = {})
{
    return casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml", more).value;
}

const Machine& machine()
{
    static const Machine built = [] {
        Observer quiet;
        return full::prepare_machine(made_press(), 3, quiet);
    }();
    return built;
}

std::string mark(const char* key, int interface, bool value)
{
    return "joints.crank_bearing.interfaces." + std::to_string(interface) + "." + key + (value ? "=true" : "=false");
}

/// Functionals of a chain of the starter press: the dimensions, and what takes positions of joints besides them.
struct Chain {
    explicit Chain(const std::vector<std::string>& more) : input(made_press(more)), model(input, machine()) {}

    /// The dimension where each part of the frame rises in proportion to its z, 1 m per m, and all else stands.
    [[nodiscard]] double of_leaning_frame(int dimension) const
    {
        double sum = 0;
        for (const auto& point : model.dimensions[static_cast<std::size_t>(dimension)].points)
            if (part_at(point.face).body == "frame")
                sum += point.weight[1] * point.position[2];
        return sum;
    }
    [[nodiscard]] bool touches(const std::string& part) const
    {
        auto all = model.dimensions;
        all.insert(all.end(), model.centres.begin(), model.centres.end());
        const auto gaps = press::describe_gaps(input, machine(), model);
        const auto corners = static_cast<std::ptrdiff_t>(gaps.corners.size());
        all.insert(all.end(), gaps.functionals.begin(), gaps.functionals.begin() + corners);
        return std::ranges::any_of(all, [&](const Functional& functional) {
            return std::ranges::any_of(functional.points,
                                       [&](const auto& point) { return part_at(point.face).name == part; });
        });
    }

    casefile::Case input;
    press::ChainModel model;

private:
    static const MeshPart& part_at(std::uint32_t face) { return machine().parts[machine().faces[face].part]; }
};

constexpr double bush_at = 0.17;  ///< middle of the back bush along z [m]; the front one lies at -0.17 m
constexpr double rounding = 1e-9;

}  // namespace

TEST_CASE("E_BG is the height of the seats that carry")
{
    const Chain both({}), back({mark("seat", 0, false)}), front({mark("seat", 1, false)});
    CHECK(both.of_leaning_frame(drift::bearing_to_ground) == near(0, rounding, rounding));
    CHECK(back.of_leaning_frame(drift::bearing_to_ground) == near(bush_at, rounding));
    CHECK(front.of_leaning_frame(drift::bearing_to_ground) == near(-bush_at, rounding));
    // The slide hangs on the seats, so the gap follows E_BG; table and guides lie in the middle of the frame.
    CHECK(back.of_leaning_frame(drift::gap) == near(bush_at, rounding));
}

TEST_CASE("a seat that does not carry has no part in dimensions, centres, corners and static opening")
{
    CHECK(Chain({}).touches("bush_front"));
    CHECK_FALSE(Chain({mark("seat", 0, false)}).touches("bush_front"));
    CHECK(Chain({mark("seat", 0, false)}).touches("bush_back"));
}

TEST_CASE("a bearing of the crank has play if it carries at seat and journal")
{
    CHECK(Chain({}).model.bearings() == 2);
    CHECK(Chain({mark("seat", 0, false)}).model.bearings() == 1);
    CHECK(Chain({mark("journal", 1, false)}).model.bearings() == 1);
    CHECK_THROWS_WITH_AS(Chain({mark("seat", 0, false), mark("journal", 1, false)}),
                         doctest::Contains("no bearing of the crank carries it"), InputError);
    CHECK_THROWS_AS(Chain({mark("seat", 0, false), mark("seat", 1, false)}), InputError);
}

TEST_CASE("marks select the journals of any joint, and none of them selects all")
{
    const auto sides = [](const std::vector<std::string>& more, const char* joint) {
        const Chain chain(more);
        const auto at = std::distance(chain.input.joints.begin(), chain.input.joints.find(joint));
        const auto& surfaces = chain.model.description.joints[static_cast<std::size_t>(at)];
        return std::pair{surfaces.in_a.size(), surfaces.in_b.size()};
    };
    CHECK(sides({}, "crank_bearing") == std::pair<std::size_t, std::size_t>{2, 2});
    CHECK(sides({mark("journal", 0, false)}, "crank_bearing") == std::pair<std::size_t, std::size_t>{1, 2});
    CHECK(sides({}, "guide") == std::pair<std::size_t, std::size_t>{2, 2});
    CHECK(sides({"joints.guide.interfaces.0.seat=true"}, "guide") == std::pair<std::size_t, std::size_t>{2, 1});
}
