/// Requirement: a model whose checksum is right, but whose contents are not what the program writes, is refused with
/// what does not fit, before its sizes take memory; so is one that is not of the case, or whose large model is not.
#include "../../lumped_press.hpp"
#include "../../scratch_folder.hpp"
#include "../messages.hpp"
#include "deadpoint/casefile/files/read.hpp"
#include "deadpoint/error.hpp"
#include "deadpoint/full/model/prepare.hpp"
#include "deadpoint/observer.hpp"
#include "deadpoint/press/result/run_result.hpp"
#include "deadpoint/twin/run/run_reduced.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <filesystem>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace deadpoint;
using messages::has;

namespace {

const casefile::Case& input()
{
    static const auto read = casefile::read_case(DEADPOINT_SOURCE_DIR "/cases/starter/case.toml").value;
    return read;
}

twin::ReducedPress lumped()
{
    static const LumpedPress built = [] {
        Observer quiet;
        return LumpedPress(input(), full::prepare_machine(input(), 3, quiet));
    }();
    return built.press();
}

/// Changes the terms of a press as they are, without what makes sizes fit.
void with_terms(twin::ReducedPress& press, const std::function<void(reduce::DenseTerms&)>& change)
{
    auto changed = std::make_shared<reduce::PreparedTerms>(press.terms->terms);
    change(changed->terms);
    press.terms = changed;
}

using Change = std::function<void(twin::ReducedPress&)>;

std::string written_and_read(const Change& change)
{
    const ScratchFolder folder;
    const auto file = folder.path / "press.rom";
    auto press = lumped();
    change(press);
    twin::write_reduced(file, press);
    return messages::error_of<IoError>([&] { std::ignore = twin::read_reduced(file); });
}

std::string run_error(const Change& change)
{
    auto press = lumped();
    change(press);
    return messages::error_of<IoError>([&] { twin::require_fit(input(), press); });
}

}  // namespace

TEST_CASE("a sound model is read and runs")
{
    const ScratchFolder folder;
    const auto file = folder.path / "press.rom";
    twin::write_reduced(file, lumped());
    const auto press = twin::read_reduced(file);
    Observer quiet;
    const auto result = twin::run_reduced(input(), press, {}, twin::ReducedDetail::all, quiet);
    CHECK(result.drift);
    CHECK(result.thermal.time.back() > 0);
}

TEST_CASE("sizes, indices and signs that do not fit are refused")
{
    const std::vector<std::pair<Change, const char*>> cases{
        {[](auto& p) { with_terms(p, [](auto& t) { t.observed.resize(0, t.uniform.size()); }); }, "observes 0"},
        {[](auto& p) { with_terms(p, [](auto& t) { t.observed.resize(1000000, 0); }); }, "sizes of its matrices"},
        {[](auto& p) {
             with_terms(
                 p, [](auto& t) { t.functionals.conservativeResize(t.functionals.rows() - 1, t.functionals.cols()); });
         },
         "sizes of its matrices"},
        {[](auto& p) {
             with_terms(p, [](auto& t) {
                 t.geometry.layout.probes -= 1;
                 t.geometry.layout.bodies += 1;
             });
         },
         ""},
        {[](auto& p) { with_terms(p, [](auto& t) { t.geometry.layout.interfaces = ~std::size_t{0} / 2; }); },
         "sizes of its matrices"},
        {[](auto& p) { with_terms(p, [](auto& t) { t.geometry.interface_names.pop_back(); }); },
         "sizes of its matrices"},
        {[](auto& p) { with_terms(p, [](auto& t) { t.geometry.interface_names[0] = "other"; }); },
         "'other' of its terms"},
        {[](auto& p) { with_terms(p, [](auto& t) { t.geometry.surface_area[0] = -1; }); }, "negative size"},
        {[](auto& p) { p.adjoints = 1000; }, "says that 1000 have a meaning"},
        {[](auto& p) { p.machine.interfaces[0].part_b = 1000; }, "belongs to no part"},
        {[](auto& p) { p.machine.surfaces[0].figures.parts[0].part = 1000; }, "belongs to no part"},
        {[](auto& p) { p.chain->figures.bearings = -1; }, "bearings"},
        {[](auto& p) { p.chain->gaps.corners.resize(3); }, "corners"},
        {[](auto& p) { p.chain->gaps.clearances.resize(100); }, "clearances"},
        {[](auto& p) { p.chain.reset(); }, "no dimension chain"},
        {[](auto& p) {
             p.frame.emplace().rods.resize(1);
             p.first_frame = ~std::size_t{0};
         },
         "rods"},
        {[](auto& p) { p.box[0].base.clear(); }, "its coefficient 'ambient'"},
        {[](auto& p) { p.box[0].from = 20; }, "its coefficient 'ambient'"},
        {[](auto& p) { p.box[0] = {"joints", reduce::FreeCoefficient::Kind::side, {100000}, {1}, 0, 1}; },
         "coefficient 'joints'"},
        {[](auto& p) { p.box[0].kind = static_cast<reduce::FreeCoefficient::Kind>(6); }, "a kind that does not exist"},
        {[](auto& p) { p.size_scale = 0; }, "cannot be"},
        {[](auto& p) { p.reference = std::nan(""); }, "is not a finite number"},
    };
    for (const auto& [change, reason] : cases) {
        const auto message = written_and_read(change);
        CAPTURE(reason);
        if (*reason == '\0')
            CHECK(message.empty());  // read as such; the case tells (below)
        else
            CHECK_MESSAGE(has(message, reason), message);
    }
}

TEST_CASE("a diagonal of many states in a small file takes no memory")
{
    // 30 000 states of 8 bytes for each part would take 7 GB as a matrix.
    const auto message = written_and_read([](auto& press) {
        with_terms(press, [](reduce::DenseTerms& terms) {
            const Eigen::Index many = 30000;
            terms.parts.setOnes(many, terms.parts.cols());
            terms.functionals.setOnes(terms.functionals.rows(), many);
            terms.observed.setOnes(terms.observed.rows(), many);
            terms.solid = Eigen::MatrixXd::Zero(1, 1);
            terms.joints.clear();
            terms.films.clear();
            terms.geometry.layout.interfaces = terms.geometry.layout.surfaces = 0;
            terms.geometry.interface_names.clear();
            terms.geometry.interface_area.clear();
            terms.geometry.surface_area.clear();
            terms.functionals.conservativeResize(static_cast<Eigen::Index>(terms.geometry.layout.count()), many);
        });
    });
    CHECK_MESSAGE(has(message, "30000 states, more than the 2500"), message);
}

TEST_CASE("the large model lies beside the small one, and nowhere else")
{
    for (const auto* name : {"../press.large.rom", "/etc/passwd", "sub/press.large.rom", ".", ".."})
        CHECK_MESSAGE(has(written_and_read([&](auto& press) { press.large_file = name; }), "not in its own folder"),
                      name);
    CHECK(written_and_read([](auto& press) { press.large_file = "missing.rom"; }).empty());
    const ScratchFolder folder, other;
    auto press = lumped();
    press.large_file = "large.rom";
    twin::write_reduced(other.path / "large.rom", lumped());
    twin::write_reduced(folder.path / "press.rom", press);
    std::filesystem::create_symlink(other.path / "large.rom", folder.path / "large.rom");
    CHECK(has(messages::error_of<IoError>([&] { std::ignore = twin::read_reduced(folder.path / "press.rom"); }),
              "not in its own folder"));
    // Both may be links to the same folder.
    twin::write_reduced(other.path / "press.rom", press);
    std::filesystem::create_symlink(other.path / "press.rom", folder.path / "link.rom");
    CHECK(twin::read_reduced(folder.path / "link.rom").large_file == "large.rom");
}

TEST_CASE("a model is of the case by the names, numbers and order of its parts, interfaces, surfaces and probes")
{
    CHECK(run_error([](auto&) {}).empty());
    const std::vector<std::pair<Change, const char*>> cases{
        {[](auto& p) {
             with_terms(p, [](auto& t) {
                 t.geometry.layout.probes -= 1;
                 t.geometry.layout.bodies += 1;
             });
         },
         "probes"},
        {[](auto& p) { p.machine.parts[0].name = "other"; }, "its parts"},
        {[](auto& p) { std::swap(p.machine.parts[0].name, p.machine.parts[1].name); }, "its parts"},
        {[](auto& p) { p.machine.parts[0].body = "other"; }, "its parts"},
        {[](auto& p) { p.machine.half_model = !p.machine.half_model; }, "its parts"},
        {[](auto& p) { std::swap(p.machine.interfaces[0].name, p.machine.interfaces[1].name); }, "its interfaces"},
        {[](auto& p) { p.machine.interfaces.pop_back(); }, "its interfaces"},
        {[](auto& p) { p.machine.surfaces[0].name = "other"; }, "its surfaces"},
        {[](auto& p) { p.machine.surfaces[0].figures.parts.pop_back(); }, "its surfaces"},
        {[](auto& p) { p.chain.reset(); }, "its dimension chain"},
        {[](auto& p) {
             p.chain->gaps.clearances.push_back({"c", ClearanceSeries::Kind::bearing, "other"});
         },
         "its dimension chain"},
    };
    for (const auto& [change, reason] : cases)
        CHECK_MESSAGE(has(run_error(change), reason), reason);
}

TEST_CASE("a large model of another layout is refused")
{
    const auto refused = [](const Change& change) {
        auto large = lumped();
        change(large);
        Observer quiet;
        const auto press = lumped();
        return messages::error_of<InputError>([&] {
            twin::run_reduced(input(), press, {&large, nullptr}, twin::ReducedDetail::figures, quiet);
        });
    };
    CHECK(refused([](auto& large) { large.version = "later"; }).empty());
    for (const Change& change : std::vector<Change>{
             [](auto& l) { l.case_hash = "other"; }, [](auto& l) { l.unknowns += 1; },
             [](auto& l) { l.chain->figures.bearings = 2; }, [](auto& l) { l.machine.parts.pop_back(); },
             [](auto& l) { l.box[0].to = 11; },
             [](auto& l) { with_terms(l, [](auto& t) { t.geometry.layout.probes += 1; }); },
             [](auto& l) { with_terms(l, [](auto& t) { t.observed.conservativeResize(2, t.observed.cols()); }); }})
        CHECK(has(refused(change), "belongs to another reduced press"));
}
